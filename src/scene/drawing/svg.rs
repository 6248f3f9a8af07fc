//! Parts of SVG: text that fits, and numbers that are short.

/// The text escaped for XML and HTML.
pub fn escaped(text: &str) -> String {
    // A character that XML does not allow would make the whole file unreadable.
    let is_known = |c: char| {
        matches!(c, '\n' | '\t') || !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}')
    };
    let known: String = text.chars().filter(|c| is_known(*c)).collect();
    known.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A length with at most one decimal.
pub(super) fn short(x: f32) -> String {
    let text = format!("{x:.1}");
    let text = text.strip_suffix(".0").map(str::to_owned).unwrap_or(text);
    if text == "-0" { "0".to_owned() } else { text }
}

/// The approximate width of a text in a plain sans-serif face, in points; the reader's own face is
/// not known.
pub(super) fn width(text: &str, size: f32) -> f32 {
    let share = |c: char| match c {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' => 0.28,
        'f' | 't' | 'r' | ' ' | '(' | ')' | '-' | '[' | ']' => 0.36,
        'm' | 'w' | 'M' | 'W' | '…' => 0.86,
        'A'..='Z' => 0.67,
        c if c.is_ascii() => 0.56,
        c if (c as u32) < 0x1100 => 0.6,
        _ => 1.0,
    };
    size * text.chars().map(share).sum::<f32>()
}

/// A text in one line, cut off with an ellipsis where it is wider than `room`.
pub(super) fn fitted(text: &str, size: f32, room: f32) -> String {
    let line = text.replace(['\n', '\r', '\t'], " ");
    if width(&line, size) <= room {
        return line;
    }
    let mut kept = String::new();
    for c in line.chars() {
        kept.push(c);
        if width(&kept, size) + width("…", size) > room {
            kept.pop();
            break;
        }
    }
    format!("{}…", kept.trim_end())
}

/// A text in lines no wider than `room`, broken between words where there are any.
pub(super) fn wrapped(text: &str, size: f32, room: f32) -> Vec<String> {
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split(' ') {
            let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
            if width(&longer, size) <= room || line.is_empty() {
                line = longer;
            } else {
                lines.push(std::mem::replace(&mut line, word.to_owned()));
            }
        }
        lines.push(fitted(&line, size, room));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_fits_its_room() {
        assert_eq!(fitted("Light", 13.0, 100.0), "Light");
        let cut = fitted("A very long name of a node indeed", 13.0, 80.0);
        assert!(cut.ends_with('…') && width(&cut, 13.0) <= 80.0, "{cut}");
        let lines = wrapped("one two three four five\nsix", 13.0, 60.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| width(line, 13.0) <= 60.0), "{lines:?}");
        assert_eq!(lines.last().unwrap(), "six");
    }

    #[test]
    fn nothing_breaks_out_of_the_text() {
        assert_eq!(escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot;");
        assert_eq!((short(2.0), short(-0.01), short(1.26)), ("2".into(), "0".into(), "1.3".into()));
    }
}
