//! Command line of the program, as it is run and as it is shown.

use std::path::PathBuf;

/// Name of the program where its own file is not told.
const PROGRAM: &str = "chiaro";

/// Arguments of the program, and the folder in which it is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct CommandLine {
    pub(crate) folder: PathBuf,
    pub(crate) words: Vec<String>,
}

impl CommandLine {
    /// The command line as a shell takes it.
    pub(crate) fn text(&self) -> String {
        let words = self.words.iter().map(|word| quoted(word));
        std::iter::once(PROGRAM.to_owned()).chain(words).collect::<Vec<_>>().join(" ")
    }

    /// The command line with the way to its folder, as a shell takes both.
    pub(crate) fn text_from_anywhere(&self) -> String {
        format!("cd {} && {}", quoted(&self.folder.to_string_lossy()), self.text())
    }
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let is_plain = |sign: char| sign.is_ascii_alphanumeric() || "_-./=,:+@%".contains(sign);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', r"'\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_where_a_shell_would_part_them() {
        let words = ["render", "a shot.json", "-o", "out/####.exr", "it's", ""];
        let line = CommandLine {
            folder: PathBuf::from("/films/night fall"),
            words: words.map(str::to_owned).to_vec(),
        };
        assert_eq!(line.text(), r"chiaro render 'a shot.json' -o 'out/####.exr' 'it'\''s' ''");
        assert!(line.text_from_anywhere().starts_with("cd '/films/night fall' && chiaro render"));
    }
}
