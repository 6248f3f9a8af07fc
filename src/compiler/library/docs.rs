//! Parser of the doc comment of a node's first function, line by line:
//!
//! ```text
//! /// Profile                                            the label
//! ///
//! /// Shapes an angle into a tone.                       help, any number of lines
//! ///
//! /// @param offset "Offset" unit=rad default=0 min=0 max=pi : Up to this angle the tone is 1.
//! /// @param normal "Normal" from=normal : The normal to use.
//! /// @param concave "Concave" same=convex : Like another input, while unset.
//! /// @param angle "Angle" wire : Must be wired.
//! /// @param before_sum default=0 before=sum : The output as the lights before have left it.
//! /// @param reach default=1 reach : How bright the light arrives, where the node runs for each.
//! /// @choice mode "Mode" default=add add="Add" alpha="Alpha" : How it is laid over what is below.
//! /// @return tone "Tone" : From 0 to 1.
//! /// @preset "Lambert" offset=0 falloff=pi/2
//! /// @bypass below when opacity = 0 : nothing is laid over what is below
//! /// @bound tone when mode = alpha|shade
//! /// @unit when clamped = 1
//! /// @opaque
//! /// @error fast 2e-3 : of the tone
//! /// @source BADF eq. 5
//! ```
//!
//! A `@bypass` gives the conditions under which the node may be left out, and its replacement: an
//! input or a number. Its conditions compare an input with a number, with another input, with words
//! of a choice (`mode = add|alpha`; `mode != add|alpha` for all others), or with `black` (first
//! three numbers 0), `unit` (all numbers known to lie in [0, 1]) or `unit_alpha` (the fourth
//! number, if there is one). Beside `=` there are `<=` and `>=`, against a number or another input:
//! they hold where constants or ranges show that they hold at every fragment. `@unit` says when the
//! result is known to lie in [0, 1], apart from a card's rounding error, and `@unit alpha` that the
//! alpha of a color does. `@opaque` says that the color is opaque where the node's image, all
//! colors that the node takes and all stops of its ramps are. A test holds that a bypassed node
//! equals one that is not. An `@error` bounds the difference of a cheaper tier from the exact one;
//! a test holds that too.
//!
//! A `@bound` names an input that is a share, with the choices for which it is one: the compiler
//! clamps the input (of a color its alpha) to [0, 1] before the node's functions see it, and adds
//! no clamp where ranges show that the value lies there.
//!
//! Numbers may be written with `pi` (`pi/2`, `-pi`, `2pi`), vectors with commas and no spaces, text
//! in quotes. A help text may go on in following lines that are indented by two spaces or more.

use std::fmt;

/// Tag: one `@word ...` line.
#[derive(Clone, Debug, PartialEq)]
pub struct Tag {
    /// Kind of the tag: `param`, `choice`, `return`, `preset`, `bypass`, `bound`, `unit`, `opaque`,
    /// `error`, `source`.
    pub word: String,
    /// Pieces between the word and the colon, split at spaces; quoted texts are one piece without
    /// their quotes.
    pub pieces: Vec<TagPiece>,
    /// Text after ` : `.
    pub help: String,
}

/// Piece of a tag.
#[derive(Clone, Debug, PartialEq)]
pub enum TagPiece {
    /// Word without quotes.
    Word(String),
    /// Quoted text, without its quotes.
    Quoted(String),
    /// `key=value`.
    Pair(String, String),
}

impl fmt::Display for TagPiece {
    /// Writes the piece as in the doc comment.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => f.write_str(word),
            Self::Quoted(text) => write!(f, "\"{text}\""),
            Self::Pair(key, value) => write!(f, "{key}={value}"),
        }
    }
}

/// Parsed doc comment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Docs {
    /// First line, without a full stop at the end.
    pub label: String,
    /// Paragraphs after the label, with `\n\n` between.
    pub help: String,
    /// Tags, in the order of their lines.
    pub tags: Vec<Tag>,
}

/// Parses the lines of a doc comment.
pub fn parse(lines: &[String]) -> Docs {
    let mut docs = Docs::default();
    let mut lines = lines.iter().map(String::as_str).peekable();
    docs.label = lines.next().unwrap_or_default().trim().trim_end_matches('.').to_owned();
    let mut paragraph = String::new();
    while let Some(line) = lines.next() {
        if let Some(tag) = line.trim_start().strip_prefix('@') {
            let mut text = tag.to_owned();
            while let Some(more) =
                lines.next_if(|next| next.starts_with("  ") && !next.trim_start().starts_with('@'))
            {
                text.push(' ');
                text.push_str(more.trim());
            }
            docs.tags.push(parse_tag(&text));
        } else if line.trim().is_empty() {
            end_paragraph(&mut docs.help, &mut paragraph);
        } else {
            if !paragraph.is_empty() {
                paragraph.push(' ');
            }
            paragraph.push_str(line.trim());
        }
    }
    end_paragraph(&mut docs.help, &mut paragraph);
    docs
}

fn end_paragraph(help: &mut String, paragraph: &mut String) {
    if paragraph.is_empty() {
        return;
    }
    if !help.is_empty() {
        help.push_str("\n\n");
    }
    help.push_str(&std::mem::take(paragraph));
}

fn parse_tag(text: &str) -> Tag {
    let (head, help) = text.split_once(" : ").unwrap_or((text, ""));
    let mut pieces = split_pieces(head).into_iter();
    let word = match pieces.next() {
        Some(TagPiece::Word(word)) => word,
        _ => String::new(),
    };
    Tag { word, pieces: pieces.collect(), help: help.trim().to_owned() }
}

fn split_pieces(text: &str) -> Vec<TagPiece> {
    let mut pieces = Vec::new();
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        if let Some(quoted) = rest.strip_prefix('"') {
            let (inside, after) = quoted.split_once('"').unwrap_or((quoted, ""));
            pieces.push(TagPiece::Quoted(inside.to_owned()));
            rest = after.trim_start();
            continue;
        }
        let end = rest.find(|c: char| c.is_whitespace() || c == '"').unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        match word.split_once('=') {
            Some((key, "")) if !key.is_empty() && after.starts_with('"') => {
                let (inside, after) = after[1..].split_once('"').unwrap_or((&after[1..], ""));
                pieces.push(TagPiece::Pair(key.to_owned(), inside.to_owned()));
                rest = after.trim_start();
            }
            Some((key, value)) if !key.is_empty() && !value.is_empty() => {
                pieces.push(TagPiece::Pair(key.to_owned(), value.to_owned()));
                rest = after.trim_start();
            }
            _ => {
                pieces.push(TagPiece::Word(word.to_owned()));
                rest = after.trim_start();
            }
        }
    }
    pieces
}

/// Parses a number: `0.5`, `pi`, `-pi/2`, `2pi`.
pub fn number(text: &str) -> Option<f64> {
    if let Ok(number) = text.parse::<f64>() {
        return number.is_finite().then_some(number);
    }
    let (numerator, denominator) = match text.split_once('/') {
        Some((numerator, denominator)) => (numerator, denominator.parse::<f64>().ok()?),
        None => (text, 1.0),
    };
    let factor = match numerator.strip_suffix("pi")? {
        "" => 1.0,
        "-" => -1.0,
        factor => factor.parse::<f64>().ok()?,
    };
    Some(factor * std::f64::consts::PI / denominator)
}

/// Parses numbers with commas between them.
pub fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(|part| number(part.trim())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comment_is_read_whole() {
        let lines = [
            "Profile.",
            "",
            "Shapes an angle",
            "into a tone.",
            "@param offset \"Offset angle\" unit=rad default=pi/2 : Up to here: 1.",
            "  And further.",
            "@choice mode default=add add=\"Add it\"",
        ];
        let docs = parse(&lines.map(str::to_owned));
        assert_eq!(docs.label, "Profile");
        assert_eq!(docs.help, "Shapes an angle into a tone.");
        assert_eq!(docs.tags[0].help, "Up to here: 1. And further.");
        assert_eq!(docs.tags[0].pieces[1], TagPiece::Quoted("Offset angle".into()));
        assert_eq!(docs.tags[0].pieces[3], TagPiece::Pair("default".into(), "pi/2".into()));
        assert_eq!(docs.tags[1].pieces[2], TagPiece::Pair("add".into(), "Add it".into()));
    }

    #[test]
    fn numbers_may_have_pi() {
        use std::f64::consts::PI;
        assert_eq!(number("-pi/2"), Some(-PI / 2.0));
        assert_eq!(number("2pi"), Some(2.0 * PI));
        assert_eq!(numbers("1,0.5,pi"), Some(vec![1.0, 0.5, PI]));
        assert_eq!(number("inf"), None);
    }
}
