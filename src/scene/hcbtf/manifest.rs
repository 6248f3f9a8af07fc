//! `manifest.json`: the contents of an `.hcbtf` file, and their places in the archive.

use chiaro_locale::tr;

use super::folder;
use super::report::FileReport;
use crate::diag::Diagnostic;
use crate::document::{Address, Direction, Hcbtf, HcbtfManifest, LoadedDocument, PaintedSample};

/// Name of the manifest in the archive.
pub(super) const NAME: &str = "manifest.json";
/// Folder of the samples in the archive.
pub(super) const SAMPLES: &str = "samples/";
/// Name of the thumbnail in the archive.
pub(super) const THUMBNAIL: &str = "thumbnail.png";
/// Greatest length of a manifest that is read, in bytes: [`MAX_PAINTED`] samples need about half of
/// it.
pub(super) const MAX_MANIFEST_BYTES: u64 = 8 << 20;

/// The name of a sample's entry.
pub(super) fn sample_name(address: Address) -> String {
    format!("{SAMPLES}{}", folder::file_name(address))
}

/// The manifest's text: a field a line, a rule a line, a sample a line, so that tools that compare
/// lines work well.
pub(super) fn text(hcbtf: &Hcbtf) -> String {
    let painted = |address: &Address| {
        let Address { light, view } = *address;
        PaintedSample { light, view, file: sample_name(*address) }
    };
    let manifest = HcbtfManifest {
        grid: hcbtf.grid,
        is_tiling: hcbtf.is_tiling,
        rules: hcbtf.rules.clone(),
        painted: hcbtf.painted.keys().map(painted).collect(),
        unknown: hcbtf.unknown.clone(),
    };
    manifest.to_text()
}

/// Reads a manifest; all errors go to the report. Of the painted samples those are left whose
/// entries can be read.
pub(super) fn parse(text: &[u8], report: &mut FileReport) -> Option<HcbtfManifest> {
    report.reads(NAME);
    let mut manifest = document(text, HcbtfManifest::read, report)?;
    let grid = manifest.grid;
    let mut index = 0;
    manifest.painted.retain(|PaintedSample { light, view, file }| {
        let path = format!("painted[{index}].file");
        index += 1;
        if leads_outside(file) {
            let message = tr!("`{NAME}`: the path `{file}` leads outside the file");
            let hint = tr!("samples lie inside the zip: name them like `samples/l2.3_v1.4.png`");
            let problem = Diagnostic::error("hcbtf-path", message);
            report.add(problem.json_path(path).hint(hint));
            return false;
        }
        let holds =
            |direction: &Direction, of: crate::document::Directions| of.contains(*direction);
        holds(light, grid.light) && holds(view, grid.view)
    });
    name_anew(&mut manifest);
    Some(manifest)
}

/// Gives the unknown fields of each painted sample to the name that the sample will be written by.
fn name_anew(manifest: &mut HcbtfManifest) {
    let Some(fields) = manifest.unknown.get_mut("painted").and_then(|all| all.as_object_mut())
    else {
        return;
    };
    for sample in &manifest.painted {
        if let Some(of_sample) = fields.remove(&sample.file) {
            fields.insert(sample_name(sample.address()), of_sample);
        }
    }
}

/// Reads a document of an HCBTF from the bytes of the part that the report is at.
pub(super) fn document<T>(
    text: &[u8],
    read: impl FnOnce(&str, &str) -> LoadedDocument<T>,
    report: &mut FileReport,
) -> Option<T> {
    let text = match std::str::from_utf8(text) {
        Ok(text) => text,
        Err(error) => {
            let part = report.part();
            let message = tr!(
                "`{part}` is not UTF-8 text after its first {bytes} bytes",
                bytes = error.valid_up_to()
            );
            report.add(Diagnostic::error("not-utf8", message).hint(tr!("save it as UTF-8")));
            return None;
        }
    };
    let LoadedDocument { value, diagnostics, .. } = read(text, "");
    report.add_document(diagnostics);
    value
}

/// True if a path is anything but names below the archive's root.
fn leads_outside(path: &str) -> bool {
    path.contains(['\\', ':', '\0']) || path.split('/').any(|part| matches!(part, "" | "." | ".."))
}
