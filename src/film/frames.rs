//! Frames: which ones, and into which files.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use chiaro_locale::tr;

/// Greatest number of frames of one list: a feature film has some 200,000.
const MAX_FRAMES: usize = 1_000_000;

/// Greatest number of a frame, and of digits in a pattern.
const MAX_FRAME: i32 = 99_999_999;
const MAX_DIGITS: usize = 8;

/// Frames to draw, in the order in which they are named, each once: `1-240`, `1-240x2` for every
/// second one, `-12--1` before frame 0, several joined by commas.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameList(Vec<i32>);

impl FrameList {
    /// The frames from the first to the last one.
    ///
    /// # Errors
    /// The reason, where there are too many.
    pub fn of_range([first, last]: [i32; 2]) -> Result<Self, String> {
        format!("{first}-{last}").parse()
    }

    /// The numbers of the frames.
    pub fn frames(&self) -> &[i32] {
        &self.0
    }
}

impl FrameList {
    /// A list of these frames, in their order.
    pub fn of(frames: Vec<i32>) -> Self {
        Self(frames)
    }

    /// The list in parts of at most so many frames.
    pub fn chunks(&self, length: usize) -> impl Iterator<Item = Self> {
        self.0.chunks(length.max(1)).map(|part| Self(part.to_vec()))
    }
}

impl std::fmt::Display for FrameList {
    /// The shortest text that [`FromStr`] reads: ranges of equal steps.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut rest = self.0.as_slice();
        let mut comma = "";
        while let [first, after @ ..] = rest {
            let step = after.first().map_or(1, |next| next.saturating_sub(*first)).max(1);
            let is_on = |at: usize| {
                let wanted = i64::from(*first) + (at as i64 + 1) * i64::from(step);
                i64::from(after[at]) == wanted
            };
            let mut more = (0..after.len()).take_while(|at| is_on(*at)).count();
            // Two numbers with a gap are shorter by themselves.
            if step > 1 && more < 2 {
                more = 0;
            }
            write!(f, "{comma}{first}")?;
            if more > 0 {
                write!(f, "-{}", after[more - 1])?;
                if step > 1 {
                    write!(f, "x{step}")?;
                }
            }
            comma = ",";
            rest = &after[more..];
        }
        Ok(())
    }
}

impl FromStr for FrameList {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = || {
            tr!("write frames as 1-240, every second one as 1-240x2 (a step is 1 or more), and \
                 several as 1-48,60,96-120")
            .to_owned()
        };
        let mut frames = Vec::new();
        for part in text.split(',').map(str::trim) {
            let (range, step) = part.split_once('x').unwrap_or((part, "1"));
            let step: usize = step.parse().ok().filter(|step| *step > 0).ok_or_else(form)?;
            // A sign at the beginning is no range.
            let after_sign = range.strip_prefix('-').map_or(0, |_| 1);
            let dash = range[after_sign..].find('-').map(|at| at + after_sign);
            let (first, last) = dash.map_or((range, range), |at| (&range[..at], &range[at + 1..]));
            let number = |text: &str| {
                let number = text.parse().ok();
                number.filter(|number: &i32| number.abs() <= MAX_FRAME).ok_or_else(form)
            };
            let (first, last) = (number(first)?, number(last)?);
            if first > last {
                return Err(tr!("the last frame of `{part}` comes before its first"));
            }
            let count = (last - first) as usize / step + 1;
            if frames.len() + count > MAX_FRAMES {
                return Err(tr!("these are more than {MAX_FRAMES} frames"));
            }
            frames.extend((first..=last).step_by(step));
        }
        let mut seen = std::collections::HashSet::with_capacity(frames.len());
        frames.retain(|frame| seen.insert(*frame));
        Ok(Self(frames))
    }
}

/// A path with the place of the frame's number: `####`, a digit each, or `%04d`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramePattern {
    before: String,
    digits: usize,
    after: String,
}

impl FramePattern {
    /// The pattern that a path is; `None` for a path without a place for a number.
    ///
    /// # Errors
    /// The reason, for a path that is not text, has two places or too many digits.
    pub fn of(path: &Path) -> Result<Option<Self>, String> {
        let Some(text) = path.to_str() else { return Ok(None) };
        let Some((before, digits, after)) = split(text) else { return Ok(None) };
        if split(after).is_some() {
            return Err(tr!("the path has two places for the frame's number").to_owned());
        }
        if !(1..=MAX_DIGITS).contains(&digits) {
            return Err(tr!("a frame's number has 1 to {MAX_DIGITS} digits"));
        }
        if after.contains(['/', '\\']) {
            let problem =
                tr!("the frame's number belongs into the name of the file, not of a folder");
            return Err(problem.to_owned());
        }
        Ok(Some(Self { before: before.to_owned(), digits, after: after.to_owned() }))
    }

    /// The path of a frame's file. A number that is longer takes the digits that it needs.
    pub fn path(&self, frame: i32) -> PathBuf {
        let sign = if frame < 0 { "-" } else { "" };
        let number = frame.unsigned_abs();
        let width = self.digits;
        format!("{}{sign}{number:0width$}{}", self.before, self.after).into()
    }

    /// The folder of the files; empty for the current one.
    pub fn folder(&self) -> PathBuf {
        self.path(0).parent().map(Path::to_path_buf).unwrap_or_default()
    }

    /// The path of another file beside the frames, whose name begins as theirs do.
    pub fn beside(&self, name: &str) -> PathBuf {
        let ends = |c: char| matches!(c, '/' | '\\' | '.' | '_' | '-');
        let point = if self.before.is_empty() || self.before.ends_with(ends) { "" } else { "." };
        format!("{}{point}{name}", self.before).into()
    }

    /// The frame whose file has this path; `None` for every other path.
    pub fn frame_of(&self, path: &Path) -> Option<i32> {
        let number = path.to_str()?.strip_prefix(&self.before)?.strip_suffix(&self.after)?;
        let frame = number.parse().ok()?;
        (self.path(frame) == path).then_some(frame)
    }
}

/// The text before the place of a number, the number of digits, and the text after it.
fn split(text: &str) -> Option<(&str, usize, &str)> {
    let hashes = text.find('#').map(|at| {
        let digits = text[at..].bytes().take_while(|byte| *byte == b'#').count();
        (at, digits, at + digits)
    });
    let percent = text.find('%').and_then(|at| {
        let inner = &text[at + 1..];
        let end = inner.find('d')?;
        let digits = &inner[..end];
        let width = if digits.is_empty() { 1 } else { digits.parse().ok()? };
        Some((at, width, at + 1 + end + 1))
    });
    let first = [hashes, percent].into_iter().flatten().min_by_key(|(at, ..)| *at);
    first.map(|(at, digits, end)| (&text[..at], digits, &text[end..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(text: &str) -> Result<Vec<i32>, String> {
        text.parse::<FrameList>().map(|list| list.0)
    }

    #[test]
    fn lists_of_frames_are_read() {
        assert_eq!(frames("7"), Ok(vec![7]));
        assert_eq!(frames("1-4"), Ok(vec![1, 2, 3, 4]));
        assert_eq!(frames("1-8x3, 20,7"), Ok(vec![1, 4, 7, 20]));
        assert_eq!(frames("-3--1,-1-1"), Ok(vec![-3, -2, -1, 0, 1]));
        for wrong in ["", "a", "1-", "1-4x0", "1-4x", "4-1", "1-2-3", "--1", "1-2000000", "1.5"] {
            assert!(frames(wrong).is_err(), "{wrong}");
        }
        assert!(frames("1-999999999").is_err(), "no memory without bound");
    }

    #[test]
    fn lists_of_frames_are_written_as_they_are_read() {
        for text in ["7", "1-4", "1-7x3", "1-8,20,12", "-3--1", "1,3", "5,4,3", "1-240"] {
            let list: FrameList = text.parse().unwrap();
            assert_eq!(list.to_string(), text);
        }
        let list: FrameList = "1-8x3,20,7".parse().unwrap();
        assert_eq!(list.to_string().parse(), Ok(list));
        let parts: Vec<String> =
            FrameList::from_str("1-25").unwrap().chunks(10).map(|part| part.to_string()).collect();
        assert_eq!(parts, ["1-10", "11-20", "21-25"]);
    }

    #[test]
    fn patterns_name_files() {
        let path = |pattern: &str, frame| {
            let pattern = FramePattern::of(Path::new(pattern)).unwrap().unwrap();
            pattern.path(frame).display().to_string()
        };
        assert_eq!(path("out/####.exr", 7), "out/0007.exr");
        assert_eq!(path("out/a.%04d.png", 12_345), "out/a.12345.png");
        assert_eq!(path("#.exr", -3), "-3.exr");
        assert_eq!(path("%d.exr", 42), "42.exr");
        let read = |pattern: &str, path: &str| {
            let pattern = FramePattern::of(Path::new(pattern)).unwrap().unwrap();
            (pattern.folder().display().to_string(), pattern.frame_of(Path::new(path)))
        };
        assert_eq!(read("out/####.exr", "out/0007.exr"), ("out".to_owned(), Some(7)));
        assert_eq!(read("out/a.####.exr", "out/a.12345.exr").1, Some(12_345));
        assert_eq!(read("a.#.exr", "a.-3.exr"), (String::new(), Some(-3)));
        for other in ["out/7.exr", "out/0007.png", "out/00007.exr", "out/000x.exr", "0007.exr"] {
            assert_eq!(read("out/####.exr", other).1, None, "{other}");
        }
        assert_eq!(FramePattern::of(Path::new("out/a.png")), Ok(None));
        assert_eq!(FramePattern::of(Path::new("100%.png")), Ok(None));
        for wrong in ["##/##.png", "####/a.png", "#########.png", "%0d#.png"] {
            assert!(FramePattern::of(Path::new(wrong)).is_err(), "{wrong}");
        }
    }
}
