//! `chiaro desktop`: an entry in the menu of programs, file types and an icon, for desktops that
//! follow freedesktop.org.

use std::env::{current_exe, var_os};
use std::ffi::OsString;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::output::Output;
use crate::diag::Diagnostic;
use crate::files::write_atomic;

const EXAMPLES: &str = "\
Examples:
  chiaro desktop --print      what would be written, and where
  chiaro desktop --install    Chiaro is in the menu, and a double click on a look opens it
  chiaro desktop --remove     takes all of it away again";

/// Arguments of `chiaro desktop`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[group(required = true, multiple = false)]
pub(super) struct Arguments {
    /// Write the files for this user, and tell the desktop
    #[arg(long)]
    install: bool,
    /// Remove them
    #[arg(long)]
    remove: bool,
    /// Print what would be written
    #[arg(long)]
    print: bool,
}

/// Paths of the files that are written, below the user's data folder.
const ENTRY: &str = "applications/chiaro.desktop";
const TYPES: &str = "mime/packages/chiaro.xml";
const ICON: &str = "icons/hicolor/scalable/apps/chiaro.svg";

/// Programs that update a desktop's databases, and the folder that each of them reads.
const TOOLS: [(&str, &str); 2] =
    [("update-mime-database", "mime"), ("update-desktop-database", "applications")];

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let home = data_home(var_os).map_err(|problem| vec![problem])?;
    let program = current_exe().map_err(|error| {
        vec![Diagnostic::error(
            "no-program",
            format!("where this program lies cannot be found out: {error}"),
        )]
    })?;
    let files = files(&program).map_err(|problem| vec![problem])?;
    if arguments.print {
        for (place, text) in &files {
            output.result(&format!("{}:\n{text}", home.join(place).display()));
        }
        return Ok(());
    }
    let mut problems = Vec::new();
    for (place, text) in &files {
        let path = home.join(place);
        let done = if arguments.install { write(&path, text) } else { remove(&path) };
        match done {
            Ok(true) => output.result(&path.display().to_string()),
            Ok(false) => {}
            Err(problem) => problems.push(problem),
        }
    }
    for (tool, folder) in TOOLS {
        tell_desktop(tool, &home.join(folder), output);
    }
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

/// The user's folder for data of programs.
fn data_home(variable: impl Fn(&'static str) -> Option<OsString>) -> Result<PathBuf, Diagnostic> {
    if cfg!(any(target_os = "windows", target_os = "macos")) {
        let problem = Diagnostic::error(
            "no-desktop-entries",
            "this system's desktop has no entries of this kind",
        );
        return Err(problem.hint("open looks from the window, or by `chiaro edit FILE`"));
    }
    let folder = |name| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
    folder("XDG_DATA_HOME").or_else(|| Some(folder("HOME")?.join(".local/share"))).ok_or_else(
        || {
            Diagnostic::error("no-home", "there is no folder for this user's data")
                .hint("set HOME, or XDG_DATA_HOME, to a folder")
        },
    )
}

/// All files that are written: paths and texts.
fn files(program: &Path) -> Result<[(&'static str, String); 3], Diagnostic> {
    let entry = include_str!("chiaro.desktop").replace("{{exec}}", &quoted(program)?);
    let icon = include_str!("chiaro.svg").to_owned();
    Ok([(ENTRY, entry), (TYPES, include_str!("chiaro.xml").to_owned()), (ICON, icon)])
}

/// A path for the Exec line of an entry: quoted as for a shell, then escaped as a string of the
/// entry, with `%` doubled.
fn quoted(program: &Path) -> Result<String, Diagnostic> {
    let text = program
        .to_str()
        .filter(|text| !text.chars().any(|c| c.is_control() || c == '='))
        .ok_or_else(|| {
            let message = format!("an entry cannot name this program: {}", program.display());
            Diagnostic::error("odd-path", message).hint("move it to a folder with a plain name")
        })?;
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '\\' => quoted += r"\\\\",
            '"' | '`' | '$' => quoted.extend([r"\\", c.encode_utf8(&mut [0; 4])]),
            '%' => quoted += "%%",
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    Ok(quoted)
}

fn write(path: &Path, text: &str) -> Result<bool, Diagnostic> {
    if let Some(folder) = path.parent() {
        // A failure to create the folder is reported by the write.
        let _ = fs::create_dir_all(folder);
    }
    write_atomic(path, text.as_bytes()).map(|()| true).map_err(|problem| *problem)
}

/// Removes a file. Returns true if it existed.
fn remove(path: &Path) -> Result<bool, Diagnostic> {
    match fs::remove_file(path) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
        Err(error) => {
            Err(Diagnostic::error("not-removed", format!("this file cannot be removed: {error}"))
                .in_file(path.display().to_string()))
        }
    }
}

/// Lets a tool read a folder anew, if both exist. Otherwise the desktop takes notice at the next
/// login.
fn tell_desktop(tool: &str, folder: &Path, output: &Output) {
    if !folder.is_dir() {
        return;
    }
    match Command::new(tool).arg(folder).output() {
        Ok(ran) if ran.status.success() => {}
        Ok(ran) => {
            output.message(&format!("{tool}: {}", String::from_utf8_lossy(&ran.stderr).trim()));
        }
        Err(_) => output.message(&format!(
            "{tool} is not installed: the desktop takes notice at the next login"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_quoted_for_an_entry() {
        let of = |path: &str| quoted(Path::new(path)).unwrap();
        assert_eq!(of("/usr/bin/chiaro"), r#""/usr/bin/chiaro""#);
        assert_eq!(of("/a b/100%/chiaro"), r#""/a b/100%%/chiaro""#);
        assert_eq!(of(r"/a$b\c/chiaro"), r#""/a\\$b\\\\c/chiaro""#);
        assert!(quoted(Path::new("/a\nb")).is_err());
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_data_folder_is_the_systems() {
        let from = |pairs: &[(&str, &str)]| {
            data_home(|name| {
                pairs.iter().find(|(key, _)| *key == name).map(|(_, value)| OsString::from(value))
            })
        };
        assert!(from(&[]).is_err() && from(&[("HOME", "here")]).is_err());
        assert_eq!(from(&[("HOME", "/h")]).unwrap(), PathBuf::from("/h/.local/share"));
        assert_eq!(from(&[("HOME", "/h"), ("XDG_DATA_HOME", "/d")]).unwrap(), PathBuf::from("/d"));
    }
}
