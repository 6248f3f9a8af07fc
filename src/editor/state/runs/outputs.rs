//! Outputs of nodes that frames have as layers: those that can be picked, and those that are.

use crate::diag::nearest;

/// Output of a node that is a layer of the frames.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PickedOutput {
    /// Name of the layer.
    pub(crate) name: String,
    /// The output as `--aov` names it: `NODE.OUTPUT`, or `LOOK:NODE.OUTPUT`.
    pub(crate) output: String,
}

impl PickedOutput {
    /// The word after `--aov`.
    pub(super) fn word(&self) -> String {
        format!("{}={}", self.name, self.output)
    }
}

/// Output of a node that can be a layer of the frames.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct OfferedOutput {
    /// The output as `--aov` names it.
    pub(crate) output: String,
    /// Names of the node, with the groups around it, and of the output.
    pub(crate) title: String,
    /// True for a node of the document; those of the library's groups are found by a search alone.
    pub(crate) is_own: bool,
}

/// The outputs that a search finds, by all of its words, in titles and in names.
pub(crate) fn matching_outputs<'o>(
    offered: &'o [OfferedOutput],
    search: &str,
) -> impl Iterator<Item = &'o OfferedOutput> {
    let words: Vec<String> = search.split_whitespace().map(str::to_lowercase).collect();
    offered.iter().filter(move |offered| {
        let text = format!("{} {}", offered.title, offered.output).to_lowercase();
        (offered.is_own || !words.is_empty()) && words.iter().all(|word| text.contains(word))
    })
}

/// The outputs that a name may stand for which no output has, best first.
pub(crate) fn nearest_outputs<'o>(offered: &'o [OfferedOutput], wrong: &str) -> Vec<&'o str> {
    nearest(wrong.trim(), offered.iter().map(|offered| offered.output.as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outputs_are_found_by_label_and_by_name_and_near_ones_are_suggested() {
        let output = |output: &str, title: &str, is_own: bool| OfferedOutput {
            output: output.to_owned(),
            title: title.to_owned(),
            is_own,
        };
        let offered = [
            output("key.tone", "Key light: Tone", true),
            output("face/rim.below", "Face / Rim: Stack", true),
            output("key/tone.tone", "Key light / Profile: Tone", false),
        ];
        let names = |search: &str| {
            matching_outputs(&offered, search)
                .map(|offered| offered.output.as_str())
                .collect::<Vec<_>>()
        };
        assert_eq!(names(""), ["key.tone", "face/rim.below"]);
        assert_eq!(names("tone KEY"), ["key.tone", "key/tone.tone"]);
        assert_eq!(names("stack"), ["face/rim.below"]);
        assert_eq!(names("face/"), ["face/rim.below"]);
        assert!(names("keyy").is_empty());
        assert_eq!(nearest_outputs(&offered, "keyy.tone ")[0], "key.tone");
        assert!(nearest_outputs(&offered, "q").is_empty());
    }
}
