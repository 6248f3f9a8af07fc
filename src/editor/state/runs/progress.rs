//! Progress of frames, as `chiaro render --json` tells it line by line.

use std::collections::BTreeMap;

use chiaro_locale::tr;
use serde_json::Value as Json;

use super::RunLine;

/// Fate of a frame.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum FrameFate {
    /// Drawn, in so many seconds.
    Drawn(f64),
    /// Whole from a run before.
    Kept,
    /// The same picture as another frame.
    Equal(i32),
    /// Not drawn, with the reason.
    Failed(String),
}

impl FrameFate {
    /// The fate in words.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Drawn(seconds) => tr!("drawn in {seconds:.2} s"),
            Self::Kept => tr!("whole before, and kept").to_owned(),
            Self::Equal(frame) => tr!("the same picture as frame {frame}"),
            Self::Failed(reason) => reason.clone(),
        }
    }
}

/// Progress of frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct FrameProgress {
    /// Frames that were asked for, in their order, each with the name of its file.
    asked: Vec<(i32, String)>,
    fates: BTreeMap<i32, FrameFate>,
    /// Messages, the last of which tells the sum or the reason of a failure.
    messages: Vec<String>,
}

impl FrameProgress {
    /// Progress of frames, each with the name of its file, of which nothing is known yet.
    pub(crate) fn of(asked: Vec<(i32, String)>) -> Self {
        Self { asked, ..Self::default() }
    }

    /// Takes a line.
    pub(crate) fn take(&mut self, line: RunLine) {
        match line {
            RunLine::Result(text) => self.take_result(&text),
            RunLine::Message(text) => self.messages.push(text),
        }
    }

    fn take_result(&mut self, text: &str) {
        let Ok(json) = serde_json::from_str::<Json>(text) else { return };
        let frame = json.get("frame").and_then(Json::as_i64);
        let Some(frame) = frame.and_then(|frame| i32::try_from(frame).ok()) else { return };
        let seconds = || {
            let parts = json["seconds"].as_object().into_iter().flatten();
            parts.filter_map(|(_, part)| part.as_f64()).sum()
        };
        let fate = match json["state"].as_str() {
            Some("drawn") => FrameFate::Drawn(seconds()),
            Some("kept") => FrameFate::Kept,
            Some("equal") => {
                let to = json["to"].as_i64().and_then(|to| i32::try_from(to).ok());
                FrameFate::Equal(to.unwrap_or(frame))
            }
            _ => FrameFate::Failed(reason_of(&json)),
        };
        self.fates.insert(frame, fate);
    }

    /// Puts a failure that no line has told at its frame: the one whose file it names, or else the
    /// first of which nothing is known.
    pub(crate) fn fail(&mut self) {
        if self.failed().next().is_some() {
            return;
        }
        // What is wrong stands behind the place, and what to do about it in a line of its own.
        let is_error = |text: &&String| text.starts_with("error") || text.contains(": error[");
        let is_reason = |text: &&String| !text.trim_start().starts_with("help:");
        let reason = self.messages.iter().rfind(is_error);
        let reason = reason.or_else(|| self.messages.iter().rfind(is_reason));
        let Some(reason) = reason.cloned() else { return };
        let names = |(frame, file): &&(i32, String)| {
            !self.fates.contains_key(frame) && reason.contains(file.as_str())
        };
        let unknown = |(frame, _): &&(i32, String)| !self.fates.contains_key(frame);
        let at = self.asked.iter().find(names).or(self.asked.iter().find(unknown));
        if let Some((frame, _)) = at {
            self.fates.insert(*frame, FrameFate::Failed(reason));
        }
    }

    /// Frames that were asked for, with what became of them.
    pub(crate) fn frames(&self) -> impl ExactSizeIterator<Item = (i32, Option<&FrameFate>)> {
        self.asked.iter().map(|(frame, _)| (*frame, self.fates.get(frame)))
    }

    /// Frames that failed, with the reasons.
    pub(crate) fn failed(&self) -> impl Iterator<Item = (i32, &str)> {
        self.fates.iter().filter_map(|(frame, fate)| match fate {
            FrameFate::Failed(reason) => Some((*frame, reason.as_str())),
            _ => None,
        })
    }

    /// Number of frames that are whole, and of all.
    pub(crate) fn count(&self) -> [usize; 2] {
        let whole = self.fates.values().filter(|fate| !matches!(fate, FrameFate::Failed(_)));
        [whole.count(), self.asked.len()]
    }

    /// Seconds that the rest takes, where so many have passed; `None` before anything is drawn.
    pub(crate) fn seconds_left(&self, passed: f64) -> Option<f64> {
        let [whole, all] = self.count();
        let kept = self.fates.values().filter(|fate| **fate == FrameFate::Kept).count();
        let made = whole.saturating_sub(kept);
        (made > 0).then(|| passed / made as f64 * all.saturating_sub(whole) as f64)
    }

    /// Messages of the run.
    pub(crate) fn messages(&self) -> &[String] {
        &self.messages
    }
}

/// The reason of a failure: the messages of its problems.
fn reason_of(json: &Json) -> String {
    let problems = json["problems"].as_array().into_iter().flatten();
    let messages = problems.filter_map(|problem| problem.get("message")?.as_str());
    let messages: Vec<&str> = messages.collect();
    if messages.is_empty() { tr!("not drawn").to_owned() } else { messages.join("; ") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked() -> Vec<(i32, String)> {
        (1..=4).map(|frame| (frame, format!("out/{frame:04}.exr"))).collect()
    }

    #[test]
    fn frames_are_counted_and_a_failure_is_put_at_its_frame() {
        let mut progress = FrameProgress::of(asked());
        for text in [
            r#"{"frame":1,"state":"kept","seconds":{"planning":0.1}}"#,
            r#"{"frame":2,"state":"drawn","seconds":{"planning":0.5,"drawing":1.5}}"#,
            r#"{"frame":4,"state":"equal","to":2}"#,
            "no line of a frame",
        ] {
            progress.take(RunLine::Result(text.to_owned()));
        }
        assert_eq!(progress.count(), [3, 4]);
        assert_eq!(progress.seconds_left(4.0), Some(2.0));
        let told = "error[cannot-write]: out/0003.exr: the disk is full";
        progress.take(RunLine::Message(told.to_owned()));
        progress.take(RunLine::Message("hint: make room".to_owned()));
        progress.fail();
        assert_eq!(progress.failed().collect::<Vec<_>>(), [(3, told)]);
        let fates: Vec<Option<String>> =
            progress.frames().map(|(_, fate)| fate.map(FrameFate::text)).collect();
        assert_eq!(fates[1].as_deref(), Some("drawn in 2.00 s"));
        assert_eq!(fates[3].as_deref(), Some("the same picture as frame 2"));
    }

    #[test]
    fn a_failure_that_names_no_file_is_of_the_first_frame_that_is_not_known() {
        let mut progress = FrameProgress::of(asked());
        progress.take(RunLine::Message("error: no GPU".to_owned()));
        progress.fail();
        assert_eq!(progress.failed().collect::<Vec<_>>(), [(1, "error: no GPU")]);
        let mut told = FrameProgress::of(asked());
        let line = r#"{"frame":3,"state":"failed","problems":[{"message":"a damaged file"}]}"#;
        told.take(RunLine::Result(line.to_owned()));
        told.fail();
        assert_eq!(told.failed().collect::<Vec<_>>(), [(3, "a damaged file")]);
    }
}
