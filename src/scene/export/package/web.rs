//! Package `web`.

use super::super::ExportFile;
use super::{Package, PackageRequest};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "web",
    label: "Web page",
    help: "A page that opens from a file, with the mesh, orbit, lights and sliders.",
    opens: None,
    write,
};

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let mut files = vec![request.script()];
    files.extend(request.textures.iter().cloned());
    Ok(files)
}
