//! Reading of text files with a bound.

use std::io;
use std::path::Path;

use chiaro_locale::tr;

use super::json::MAX_BYTES;
use crate::diag::{Diagnostic, LineColumn};
use crate::files::{self, Files, ReadError};

/// Reads a text file of at most 64 MiB, or an [example](crate::examples).
///
/// # Errors
/// A diagnostic that names the file where it cannot be read, is too large, or is not UTF-8.
pub fn read_text(files: &dyn Files, path: &Path) -> Result<String, Box<Diagnostic>> {
    if let Some(text) = crate::examples::text(path) {
        return Ok(text);
    }
    let name = path.display().to_string();
    let fail = |code, message: String, hint: &str| {
        let problem = Diagnostic::error(code, message).in_file(name.clone());
        Box::new(if hint.is_empty() { problem } else { problem.hint(hint) })
    };
    let cannot = |error: io::Error| {
        let hint = match error.kind() {
            io::ErrorKind::NotFound => {
                tr!("check the spelling, and the folder that the path starts from")
            }
            io::ErrorKind::PermissionDenied => {
                tr!("you may not read this file: change its permissions")
            }
            io::ErrorKind::IsADirectory => tr!("this is a folder: name a file in it"),
            _ => "",
        };
        fail(
            "cannot-read",
            tr!("cannot read the file: {reason}", reason = crate::diag::reason(&error)),
            hint,
        )
    };
    let bytes = files.read(path, MAX_BYTES as u64).map_err(|error| match error {
        ReadError::Io(error) => cannot(error),
        ReadError::Special => {
            let message = tr!("cannot read the file: {error}");
            fail("cannot-read", message, tr!("name a plain file"))
        }
        ReadError::TooLarge { .. } => {
            let message = tr!(
                "the file is larger than {most} MiB, the bound for documents",
                most = MAX_BYTES >> 20
            );
            fail("too-large", message, tr!("keep big data in files that the document names"))
        }
    })?;
    if is_painting(path, &bytes) {
        let message = tr!("this is a painted surface (HCBTF), and no text").to_owned();
        let mut problem = fail(
            "wrong-document",
            message,
            tr!(
                "`chiaro edit` opens it to be painted on, and `chiaro hcbtf` tells what it holds, \
             fills, exports and imports it"
            ),
        );
        problem.hints.push(
            tr!("a look shows it by a node of the kind `hcbtf_lookup`, whose value `sheet` names \
             it: `example:hcbtf/brick.json` is one")
            .to_owned(),
        );
        return Err(problem);
    }
    if files::is_utf16(&bytes) {
        return Err(fail("not-utf8", tr!("the file is UTF-16").into(), tr!("save it as UTF-8")));
    }
    String::from_utf8(bytes).map_err(|error| {
        let bytes = error.as_bytes();
        let valid = error.utf8_error().valid_up_to();
        let before = String::from_utf8_lossy(&bytes[..valid]);
        let message = tr!("the file is not UTF-8 text from here on").into();
        let mut problem = fail(
            "not-utf8",
            message,
            tr!("a document is JSON in UTF-8; is this another kind of file?"),
        );
        problem.place.at = Some(LineColumn::of(&before, valid));
        problem
    })
}

/// True for the bytes of an `.hcbtf` file, or of another zip with that extension.
fn is_painting(path: &Path, bytes: &[u8]) -> bool {
    let is_called_so = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("hcbtf"));
    // Files that Chiaro writes have the manifest first.
    bytes.starts_with(b"PK") && (is_called_so || bytes.get(30..43) == Some(b"manifest.json"))
}
