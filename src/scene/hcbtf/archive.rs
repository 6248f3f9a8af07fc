//! Zip files: reading of untrusted ones, with bounds, and writing of our own, the same every time.
//!
//! The crate `zip` allocates memory for as many entries as a file claims to have, so the claims are
//! checked before: each place that could be a directory of the archive is held against
//! [`MAX_ENTRIES`].

use std::io::{Cursor, Read as _, Write as _};

use chiaro_locale::tr;
use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, System, ZipArchive, ZipWriter};

use crate::diag::Diagnostic;

/// Greatest number of entries of an archive that is read: a plain zip has no more.
const MAX_ENTRIES: u64 = 65_535;
/// Greatest size of everything that is unpacked from one archive, in bytes. Entries can share their
/// packed bytes, so the size of the file bounds nothing.
const MAX_UNPACKED: u64 = 2 << 30;
/// Greatest number of ends of directories in one file. One is usual; comments can hold some that
/// only look like an end.
const MAX_ENDS: usize = 64;
/// Signature before the end of a directory; below, that before the end's larger form.
const END: &[u8; 4] = b"PK\x05\x06";
const LARGE_END: &[u8; 4] = b"PK\x06\x06";

/// A zip file in memory, open for reading.
pub(super) struct Archive<'a> {
    zip: ZipArchive<Cursor<&'a [u8]>>,
    left: u64,
}

impl<'a> Archive<'a> {
    /// Opens an archive by reading its directory.
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, Diagnostic> {
        if bytes.is_empty() {
            return Err(Diagnostic::error("empty-file", tr!("the file is empty"))
                .hint(tr!("save it again, or take a backup")));
        }
        if !bytes.starts_with(b"PK") {
            let message =
                tr!("this is no painted surface (HCBTF): it does not begin as a zip file does");
            let is_json = bytes.trim_ascii_start().starts_with(b"{");
            let hint = if is_json {
                tr!("it is JSON, as looks and scenes are: `chiaro explain` tells of those")
            } else {
                tr!("is this another kind of file?")
            };
            return Err(Diagnostic::error("hcbtf-archive", message).hint(hint));
        }
        check_claims(bytes)?;
        let zip = ZipArchive::new(Cursor::new(bytes)).map_err(|error| broken(&error))?;
        Ok(Self { zip, left: MAX_UNPACKED })
    }

    /// The names of the entries, except those that are not UTF-8.
    pub(super) fn names(&self) -> impl Iterator<Item = String> + '_ {
        self.zip.file_names().filter_map(|name| Some(name.ok()?.into_owned()))
    }

    /// True if there is an entry of this name.
    pub(super) fn has(&self, name: &str) -> bool {
        self.zip.index_for_name(name).is_some()
    }

    /// True if two entries have one name, so that programs differ in the entry that they take.
    pub(super) fn has_duplicates(&self) -> bool {
        self.zip.has_duplicate_names()
    }

    /// The bytes of an entry, at most `most` of them, whatever number the file claims.
    pub(super) fn read(&mut self, name: &str, most: u64) -> Result<Vec<u8>, Diagnostic> {
        let bound = most.min(self.left);
        let too_large = || {
            let total = if bound < most {
                tr!(", and all of it more than {most} MiB", most = MAX_UNPACKED >> 20)
            } else {
                String::new()
            };
            let message = tr!("`{name}` unpacks to more than {bound} bytes{total}");
            Diagnostic::error("too-large", message)
                .hint(tr!("no sample of this grid needs as much: export it again as a plain PNG"))
        };
        let entry = self.zip.by_name(name).map_err(|error| unreadable(name, &error))?;
        if entry.size() > bound {
            return Err(too_large());
        }
        let mut bytes = Vec::new();
        // One byte beyond the bound shows that there are more.
        entry
            .take(bound + 1)
            .read_to_end(&mut bytes)
            .map_err(|error| unreadable(name, &ZipError::Io(error)))?;
        self.left -= (bytes.len() as u64).min(self.left);
        if bytes.len() as u64 > bound { Err(too_large()) } else { Ok(bytes) }
    }
}

/// Refuses files that claim more entries than possible, before any reader trusts the claim.
fn check_claims(bytes: &[u8]) -> Result<(), Diagnostic> {
    let too_many = |what: &str| {
        let message = tr!("the zip file has more {what}");
        Err(Diagnostic::error("too-many", message)
            .hint(tr!("this was not written by Chiaro: pack the files anew, as a plain zip")))
    };
    let number =
        |at: usize| bytes.get(at..)?.first_chunk::<8>().map(|bytes| u64::from_le_bytes(*bytes));
    let mut ends = 0;
    for at in
        bytes.windows(4).enumerate().filter(|(_, four)| four.starts_with(b"PK")).map(|(at, _)| at)
    {
        if bytes[at..].starts_with(END) {
            ends += 1;
        } else if bytes[at..].starts_with(LARGE_END) {
            // Two counts of entries: on this disk, and in all. A count beyond the file's length is
            // no count: these bytes are not a directory.
            let counts = [number(at + 24), number(at + 32)];
            if counts
                .into_iter()
                .flatten()
                .any(|count| count > MAX_ENTRIES && count <= bytes.len() as u64)
            {
                return too_many(&tr!("than {MAX_ENTRIES} entries"));
            }
        }
    }
    if ends > MAX_ENDS { too_many(tr!("than one directory")) } else { Ok(()) }
}

/// The error for an archive that cannot be read as a whole.
fn broken(error: &ZipError) -> Diagnostic {
    let message = tr!("the zip file cannot be read: {why}", why = reason(error));
    Diagnostic::error("hcbtf-archive", message)
        .hint(tr!("it may be cut off: copy or save it again, or take a backup"))
}

/// The error for an entry that cannot be read.
fn unreadable(name: &str, error: &ZipError) -> Diagnostic {
    let hint = match error {
        ZipError::FileNotFound => {
            tr!("put the file back, or take it out of `painted` in manifest.json")
        }
        ZipError::CompressionMethodNotSupported(_) => {
            tr!("pack it with the method Deflate, or without compression")
        }
        ZipError::UnsupportedArchive(_) => tr!("pack it as a plain zip: no password, one part"),
        _ => tr!("the file is damaged: pack the entry again, or take a backup"),
    };
    Diagnostic::error("hcbtf-entry", tr!("`{name}` cannot be read: {why}", why = reason(error)))
        .hint(hint)
}

fn reason(error: &ZipError) -> String {
    match error {
        ZipError::Io(error) => error.to_string(),
        ZipError::InvalidArchive(why) => why.to_string(),
        ZipError::FileNotFound => tr!("there is no such entry").to_owned(),
        other => other.to_string(),
    }
}

/// Writer of a zip file: entries come in the order given, with the time that zip files begin at and
/// the same attributes everywhere, so that equal entries give equal bytes.
pub(super) struct ArchiveWriter(ZipWriter<Cursor<Vec<u8>>>);

impl ArchiveWriter {
    pub(super) fn new() -> Self {
        Self(ZipWriter::new(Cursor::new(Vec::new())))
    }

    /// Adds a text, packed.
    pub(super) fn text(&mut self, name: &str, text: &str) -> Result<(), ZipError> {
        self.entry(name, text.as_bytes(), CompressionMethod::Deflated)
    }

    /// Adds a file that is packed already, as PNGs are.
    pub(super) fn packed(&mut self, name: &str, bytes: &[u8]) -> Result<(), ZipError> {
        self.entry(name, bytes, CompressionMethod::Stored)
    }

    fn entry(
        &mut self,
        name: &str,
        bytes: &[u8],
        method: CompressionMethod,
    ) -> Result<(), ZipError> {
        let options = SimpleFileOptions::default()
            .compression_method(method)
            .last_modified_time(DateTime::default())
            .unix_permissions(0o644)
            .system(System::Unix);
        self.0.start_file(name, options)?;
        Ok(self.0.write_all(bytes)?)
    }

    /// The bytes of the whole file.
    pub(super) fn finish(self) -> Result<Vec<u8>, ZipError> {
        Ok(self.0.finish()?.into_inner())
    }
}
