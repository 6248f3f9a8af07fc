//! Package `babylon`.

use super::super::ExportFile;
use super::{Package, PackageRequest};
use crate::diag::Diagnostic;

/// The package.
pub(super) const PACKAGE: Package = Package {
    slug: "babylon",
    label: "Babylon.js",
    help: "An ES module with a material for Babylon.js.",
    opens: None,
    write,
};

fn write(request: &PackageRequest<'_>) -> Result<Vec<ExportFile>, Vec<Diagnostic>> {
    let mut files = vec![request.module()];
    files.extend(request.textures.iter().cloned());
    Ok(files)
}
