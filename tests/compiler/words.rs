//! Names: a type's name says what the type is, and the glossary and the library's map of the code
//! name types, modules and files that exist.
//!
//! A name that is a pronoun, a preposition, an adverb, a verb or a bare participle (`What`, `Of`,
//! `Shown`) tells nobody what the type is, and comes again in the next module for another type.
//! Such names are refused in `src/`, in tests and in benchmarks.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use crate::support::files::below;
use crate::support::root;

/// Words that are no nouns, or riddles: type names that do not name a thing.
const RIDDLES: &[&str] = &[
    // Pronouns and questions.
    "All", "Anything", "Both", "Each", "Every", "Few", "How", "It", "Its", "Many", "None", "One",
    "Other", "Others", "Own", "Same", "Some", "Such", "That", "These", "Thing", "Things", "This",
    "Those", "What", "When", "Where", "Which", "Who", "Whole", "Whose", "Why",
    // Prepositions.
    "About", "Above", "Across", "After", "Against", "Along", "Among", "Around", "As", "At",
    "Before", "Behind", "Below", "Beneath", "Beside", "Between", "Beyond", "By", "Down", "During",
    "Except", "For", "From", "In", "Inside", "Into", "Like", "Near", "Of", "Off", "On", "Onto",
    "Out", "Over", "Past", "Since", "Through", "To", "Toward", "Towards", "Under", "Until", "Up",
    "Upon", "With", "Within", "Without",
    // Adverbs and the like: they say when, where or how, and never what.
    "Again", "Ago", "Almost", "Alone", "Already", "Also", "Apart", "Away", "Earlier", "Even",
    "Ever", "Far", "Here", "Later", "Never", "Next", "Now", "Often", "Once", "Only", "Rather",
    "Soon", "Still", "Then", "There", "Thus", "Together", "Too", "Twice", "Way", "Well",
    // Adjectives that leave their noun out.
    "Best", "Dirty", "Endless", "First", "Idle", "Last", "Loose", "Nearest", "Ready", "Recent",
    "Rest", "Special", "Unknown", "Valid", "Worst",
    // Verbs: functions are named by what they do, and types are not.
    "Are", "Be", "Become", "Begin", "Bring", "Choose", "Come", "Decide", "Did", "Do", "Does",
    "Expect", "Expects", "Find", "Forget", "Get", "Give", "Gives", "Go", "Had", "Has", "Have",
    "Interact", "Is", "Keep", "Keeps", "Know", "Lack", "Let", "Lose", "Make", "Makes", "Open",
    "Prepare", "Put", "Reads", "Remember", "Say", "Says", "See", "Seem", "Send", "Take", "Takes",
    "Tell", "Tells", "Think", "Wait", "Want", "Wants", "Was", "Were", "Write", "Writes",
    // Participles that end otherwise than in -ed and -ing.
    "Begun", "Bought", "Bound", "Broken", "Brought", "Built", "Caught", "Chosen", "Cut", "Done",
    "Drawn", "Driven", "Felt", "Found", "Given", "Gone", "Grown", "Heard", "Held", "Hidden",
    "Kept", "Known", "Laid", "Left", "Lent", "Lit", "Lost", "Made", "Meant", "Met", "Paid", "Read",
    "Run", "Said", "Seen", "Sent", "Shown", "Split", "Spoken", "Spread", "Stood", "Sunk", "Swept",
    "Taken", "Taught", "Thought", "Thrown", "Told", "Torn", "Won", "Worn", "Written",
    // Riddles: the field has another word.
    "Artist", "Dice", "Job", "Keeper", "Lab", "Lamp", "Lens", "Manner", "Moment", "Soup", "Station",
    "Team", "Teller", "Wardrobe", "Wish",
];

/// Nouns in -ed, -ing and -ly.
const NOUNS: &[&str] = &[
    "Assembly", "Binding", "Blending", "Crossing", "Drawing", "Easing", "Encoding", "Family",
    "Feed", "Finding", "Heading", "Lighting", "Listing", "Mapping", "Need", "Padding", "Painting",
    "Ring", "Rounding", "Seed", "Setting", "Shading", "Speed", "Spring", "String", "Thing",
    "Timing", "Varying", "Warning",
];

/// True if a type of this name would not be called what it is: one word that is no noun.
fn is_riddle(name: &str) -> bool {
    let is_one_word = !name.chars().skip(1).any(|letter| letter.is_ascii_uppercase());
    let has_ending = ["ed", "ing", "ly"].iter().any(|ending| name.ends_with(ending));
    is_one_word && (RIDDLES.contains(&name) || has_ending && !NOUNS.contains(&name))
}

/// The type name that a line declares.
fn declared(line: &str) -> Option<&str> {
    let mut words = line.split_whitespace().filter(|word| !word.starts_with("pub"));
    let keyword = words.next()?;
    if !matches!(keyword, "struct" | "enum" | "trait" | "type" | "union") {
        return None;
    }
    let name = words.next()?.split(['<', '(', ';', ':', '{', '=']).next()?;
    name.starts_with(|c: char| c.is_ascii_uppercase()).then_some(name)
}

/// Folders whose types are named by these rules.
const FOLDERS: [&str; 3] = ["src", "tests", "benches"];

/// Every type that the [`FOLDERS`] declare, with the files that declare it, by paths from `src/` or
/// the top.
fn declarations() -> BTreeMap<String, BTreeSet<String>> {
    let src = root().join("src");
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for path in FOLDERS.iter().flat_map(|folder| below(&root().join(folder))) {
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let file = path.strip_prefix(&src).or_else(|_| path.strip_prefix(root())).unwrap();
        let file = file.to_string_lossy().replace('\\', "/");
        for name in text.lines().filter_map(declared) {
            found.entry(name.to_owned()).or_default().insert(file.clone());
        }
    }
    found
}

#[test]
fn types_are_called_what_they_are() {
    let declarations = declarations();
    let riddles: BTreeSet<String> = declarations
        .iter()
        .filter(|(name, _)| is_riddle(name))
        .flat_map(|(name, files)| files.iter().map(move |file| format!("{file} {name}")))
        .collect();
    assert!(riddles.is_empty(), "a name says what the thing is, and these do not: {riddles:#?}");
}

/// The file that a path from `src/` or the top names, or the folder, where the path ends in `/`.
fn place_of(path: &str) -> Option<PathBuf> {
    let mut places = [root().join("src").join(path), root().join(path)].into_iter();
    places.find(|place| if path.ends_with('/') { place.is_dir() } else { place.is_file() })
}

/// True if a path from `src/` or the top is the path of a file in `src/`.
fn is_of_library(path: &str) -> bool {
    root().join("src").join(path).is_file()
}

/// Types, modules and files in the glossary's last column exist.
#[test]
fn the_glossary_names_what_there_is() {
    let text = fs::read_to_string(root().join("docs/glossary.md")).unwrap();
    let declarations = declarations();
    let mut words = 0;
    let mut last = String::new();
    for row in text.lines().filter(|line| {
        line.starts_with("| ") && !line.starts_with("| word |") && !line.starts_with("| ---")
    }) {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").map(str::trim).collect();
        let [word, meaning, carriers] = cells.as_slice() else { panic!("three cells: {row}") };
        assert!(!word.is_empty() && !meaning.is_empty(), "{row}");
        assert!(word.to_lowercase() > last, "`{word}` is out of order");
        last = word.to_lowercase();
        words += 1;
        let named = carriers.split('`').skip(1).step_by(2);
        for carrier in named {
            let is_there = if carrier.contains('/') {
                place_of(carrier).is_some()
            } else {
                declarations
                    .get(carrier)
                    .is_some_and(|files| files.iter().any(|file| is_of_library(file)))
            };
            assert!(is_there, "`{word}`: there is no `{carrier}`");
        }
    }
    assert!(words > 40, "{words} words");
}

/// Paths in the section "Where things are" of the library exist, and a name after the path of a
/// file is in that file.
#[test]
fn things_are_where_the_library_says() {
    let text = fs::read_to_string(root().join("src/lib.rs")).unwrap();
    let (_, section) = text.split_once("//! ## Where things are\n").expect("the section is there");
    let lines = section.lines().map_while(|line| line.strip_prefix("//!"));
    let section: String = lines.take_while(|line| !line.starts_with(" #")).collect();
    let mut paths = 0;
    let mut last = None;
    for word in section.split('`').skip(1).step_by(2) {
        if word.contains('/') {
            last = Some(place_of(word).unwrap_or_else(|| panic!("there is no `{word}`")));
            paths += 1;
            continue;
        }
        let file = last.as_ref().filter(|place| place.is_file());
        let file = file.unwrap_or_else(|| panic!("`{word}` stands after no path of a file"));
        let text = fs::read_to_string(file).unwrap();
        assert!(text.contains(word), "there is no `{word}` in {}", file.display());
    }
    assert!(paths > 30, "{paths} paths");
}

/// Words with which documentation does not begin: the subject comes first.
const NO_SUBJECTS: &[&str] = &[
    "As",
    "How",
    "It",
    "Its",
    "Something",
    "Such",
    "That",
    "These",
    "They",
    "This",
    "Those",
    "What",
    "Whatever",
    "Where",
    "Whether",
    "Which",
    "Who",
    "Whom",
    "Whose",
    "Why",
];

/// First word of a block of documentation that begins at a line; `before` is the line before it.
fn first_word<'l>(line: &'l str, before: &str) -> Option<&'l str> {
    let text = |line: &'l str| line.trim_start().strip_prefix("///");
    let is_within = before.trim_start().starts_with("///");
    let text = text(line).or_else(|| line.trim_start().strip_prefix("//!"))?;
    if is_within || before.trim_start().starts_with("//!") {
        return None;
    }
    text.split(|c: char| !c.is_alphanumeric()).find(|word| !word.is_empty())
}

#[test]
fn documentation_begins_with_its_subject() {
    let mut refused = Vec::new();
    for folder in FOLDERS {
        for path in below(&root().join(folder)) {
            if path.extension().is_none_or(|extension| extension != "rs") {
                continue;
            }
            let text = fs::read_to_string(&path).unwrap();
            let mut before = "";
            for (number, line) in text.lines().enumerate() {
                let word = first_word(line, before);
                if word.is_some_and(|word| NO_SUBJECTS.contains(&word)) {
                    refused.push(format!("{}:{}: {line}", path.display(), number + 1));
                }
                before = line;
            }
        }
    }
    assert!(refused.is_empty(), "say the noun first:\n{}", refused.join("\n"));
    assert_eq!(first_word("    /// What a look is.", ""), Some("What"));
    assert_eq!(first_word("//! What a look is.", "use x;"), Some("What"));
    assert_eq!(first_word("/// What a look is.", "/// A look."), None);
    assert_eq!(first_word("let what = 1;", ""), None);
}

#[test]
fn declarations_are_found() {
    assert_eq!(declared("pub(crate) struct Shown<'a> {"), Some("Shown"));
    assert_eq!(declared("type Of = u32;"), Some("Of"));
    assert_eq!(declared("    pub enum What {"), Some("What"));
    assert_eq!(declared("    type_of(One)"), None);
    assert_eq!(declared("/// struct Shown"), None);
    let declarations = declarations();
    assert!(declarations["Progress"].contains("language/progress.rs"));
    assert!(declarations["Ledger"].contains("tests/support/ledger.rs"));
}

#[test]
fn nouns_are_no_riddles() {
    for name in ["Shown", "Shaded", "Holding", "Toward", "Evenly", "Has", "Wardrobe"] {
        assert!(is_riddle(name), "{name}");
    }
    for name in ["Setting", "Feed", "Binding", "ExposedValue", "Shader", "Family"] {
        assert!(!is_riddle(name), "{name}");
    }
}
