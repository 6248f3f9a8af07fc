//! Sets of lights and of objects, as expressions over ids, names and groups.
//!
//! ```text
//! set    = product (("|" | "-") product)*     both or either; the first without the second
//! product = term ("&" term)*                  both, before | and -
//! term   = "*"                                all
//!        | id                                 the one of that id; * and ? stand for any letters
//!        | "name"                             those of that name, in double quotes
//!        | group:NAME                         those of that group; * and ? as in ids
//!        | {source}                           what the set was before
//!        | "(" set ")"
//! ```
//!
//! An id may hold `-`, so a `-` that takes away stands apart from words. The empty text is the
//! empty set.

use std::collections::BTreeSet;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::marker::PhantomData;

use chiaro_locale::{Text, text, tr};
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use super::light::Light;
use super::scene::Object;
use crate::diag::Diagnostic;
use crate::ids::{LightGroup, LightId, ObjectId, is_slug};

/// Member of sets: what ids, names and groups stand for.
pub trait SetMember {
    /// Ids of members.
    type Id: Clone + Ord + Hash + AsRef<str>;
    /// Word for a member.
    const WORD: Text;
    /// A group of members in messages.
    const GROUP: Text;
    /// A member that has a name in messages.
    const NAMED: Text;
    /// Members that a set may name, in words.
    const TERMS: Text;
    /// Example of a set, in words.
    const EXAMPLE: Text;
    /// Code of an error of what is no set.
    const BAD: &'static str;
    /// Code of a warning of a term that names none.
    const UNKNOWN: &'static str;

    /// Name of the member; empty for none.
    fn name(&self) -> &str;

    /// Groups of the member.
    fn groups(&self) -> &[LightGroup];
}

impl SetMember for Light {
    type Id = LightId;
    const WORD: Text = text!("light");
    const GROUP: Text = text!("group of lights");
    const NAMED: Text = text!("light of the name");
    const TERMS: Text = text!("a light or a group");
    const EXAMPLE: Text = text!("for example `key | group:rim - group:set`, or `*`");
    const BAD: &'static str = "bad-light-set";
    const UNKNOWN: &'static str = "unknown-light";

    fn name(&self) -> &str {
        &self.name
    }

    fn groups(&self) -> &[LightGroup] {
        &self.groups
    }
}

/// Objects have ids alone.
impl SetMember for Object {
    type Id = ObjectId;
    const WORD: Text = text!("object");
    const GROUP: Text = text!("group of objects");
    const NAMED: Text = text!("object of the name");
    const TERMS: Text = text!("an object");
    const EXAMPLE: Text = text!("for example `floor | wall-*`, or `*`");
    const BAD: &'static str = "bad-object-set";
    const UNKNOWN: &'static str = "unknown-object";

    fn name(&self) -> &str {
        ""
    }

    fn groups(&self) -> &[LightGroup] {
        &[]
    }
}

/// Set of lights.
pub type LightSet = MemberSet<Light>;

/// Set of objects.
pub type ObjectSet = MemberSet<Object>;

/// Set with the text that says it.
#[derive(Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
#[serde(bound(serialize = "", deserialize = "M: SetMember"))]
pub struct MemberSet<M> {
    text: String,
    /// The expression with operators behind their operands.
    steps: Vec<SetStep>,
    member: PhantomData<fn() -> M>,
}

impl<M> Clone for MemberSet<M> {
    fn clone(&self) -> Self {
        Self { text: self.text.clone(), steps: self.steps.clone(), member: PhantomData }
    }
}

impl<M> PartialEq for MemberSet<M> {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl<M> Eq for MemberSet<M> {}

impl<M> Hash for MemberSet<M> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.text.hash(state);
    }
}

/// Step of an expression in postfix order.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum SetStep {
    Term(SetTerm),
    Operator(SetOperator),
}

/// Operator between two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum SetOperator {
    Union,
    Difference,
    Intersection,
}

impl SetOperator {
    /// True if it is applied before `other`, which stands to its left.
    fn binds_more(self, other: Self) -> bool {
        self == Self::Intersection && other != Self::Intersection
    }

    fn apply<I: Clone + Ord>(self, a: &BTreeSet<I>, b: &BTreeSet<I>) -> BTreeSet<I> {
        match self {
            Self::Union => a | b,
            Self::Difference => a - b,
            Self::Intersection => a & b,
        }
    }
}

/// Name of members in a set.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum SetTerm {
    /// All members: `*`.
    All,
    /// Members of the set that was there before: `{source}`.
    Source,
    /// Members of an id, in which `*` and `?` stand for any letters.
    Id(String),
    /// Members of a name, in double quotes.
    Name(String),
    /// Members of a group, in which `*` and `?` stand for any letters.
    Group(String),
}

impl SetTerm {
    /// True if a member is named.
    fn names<M: SetMember>(&self, id: &M::Id, member: &M) -> bool {
        match self {
            Self::All => true,
            Self::Source => false,
            Self::Id(pattern) => matches(pattern, id.as_ref()),
            Self::Name(name) => member.name() == name,
            Self::Group(pattern) => {
                member.groups().iter().any(|group| matches(pattern, group.as_str()))
            }
        }
    }

    /// The word as it is written, without quotes and `group:`.
    pub fn word(&self) -> &str {
        match self {
            Self::All => "*",
            Self::Source => SOURCE,
            Self::Id(word) | Self::Name(word) | Self::Group(word) => word,
        }
    }
}

impl fmt::Display for SetTerm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Name(name) => write!(f, "\"{name}\""),
            Self::Group(group) => write!(f, "{GROUP}{group}"),
            _ => f.write_str(self.word()),
        }
    }
}

const SOURCE: &str = "{source}";
const GROUP: &str = "group:";

/// Reason why a text is no set.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", tr!("{reason} at character {place}", place = at + 1))]
pub struct SetError {
    /// Number of characters before the problem.
    pub at: usize,
    /// The reason, in a phrase.
    pub reason: String,
}

impl<M> MemberSet<M> {
    fn new(text: String, steps: Vec<SetStep>) -> Self {
        Self { text, steps, member: PhantomData }
    }

    /// The set of all.
    pub fn all() -> Self {
        Self::new("*".to_owned(), vec![SetStep::Term(SetTerm::All)])
    }

    /// The empty set.
    pub fn none() -> Self {
        Self::new(String::new(), Vec::new())
    }

    /// The set of what was there before.
    pub fn source() -> Self {
        Self::new(SOURCE.to_owned(), vec![SetStep::Term(SetTerm::Source)])
    }

    /// True if the set has no members, whichever there are: it says nothing.
    pub fn is_none(&self) -> bool {
        self.steps.is_empty()
    }

    /// True if the set has all, whichever there are.
    pub fn is_all(&self) -> bool {
        self.text == "*"
    }

    /// The expression as it was written.
    pub fn text(&self) -> &str {
        &self.text
    }
}

impl<M: SetMember> MemberSet<M> {
    /// Reads an expression.
    ///
    /// # Errors
    /// What is wrong in the text, and where.
    pub fn parse(text: &str) -> Result<Self, SetError> {
        let steps = SetReader::new(text, M::TERMS).steps()?;
        Ok(Self::new(text.to_owned(), steps))
    }

    /// Ids of the set's own among all members; `source` is what the set was before.
    pub fn of(&self, all: &IndexMap<M::Id, M>, source: &BTreeSet<M::Id>) -> BTreeSet<M::Id> {
        let mut open: Vec<BTreeSet<M::Id>> = Vec::new();
        for step in &self.steps {
            let found = match step {
                SetStep::Term(SetTerm::Source) => source.clone(),
                SetStep::Term(term) => {
                    let named = all.iter().filter(|(id, member)| term.names(*id, *member));
                    named.map(|(id, _)| id.clone()).collect()
                }
                SetStep::Operator(operator) => {
                    let (b, a) = (open.pop().unwrap_or_default(), open.pop().unwrap_or_default());
                    operator.apply(&a, &b)
                }
            };
            open.push(found);
        }
        open.pop().unwrap_or_default()
    }

    /// The set with another in the place of `{source}`.
    #[must_use]
    pub fn with_source(&self, source: &Self) -> Self {
        if !self.steps.contains(&SetStep::Term(SetTerm::Source)) {
            return self.clone();
        }
        let inner = match source.text.trim() {
            "" => "(* - *)".to_owned(),
            text if source.steps.len() == 1 => text.to_owned(),
            text => format!("({text})"),
        };
        // Names stand between quotes, and stay as they are.
        let part = |(index, part): (usize, &str)| {
            if index % 2 == 0 { part.replace(SOURCE, &inner) } else { part.to_owned() }
        };
        let text = self.text.split('"').enumerate().map(part).collect::<Vec<_>>().join("\"");
        Self::parse(&text).unwrap_or_else(|_| self.clone())
    }

    /// The set without the members of another.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        if self.is_none() || other.is_none() {
            return self.clone();
        }
        let text = format!("({}) - ({})", self.text.trim(), other.text.trim());
        Self::parse(&text).unwrap_or_else(|_| self.clone())
    }

    /// The set with the members of a term, too.
    #[must_use]
    pub fn with(&self, term: &SetTerm) -> Self {
        self.extended(SetOperator::Union, term)
    }

    /// The set without the members of a term, among all: the term goes, and where others still name
    /// some of its members, these are taken away.
    #[must_use]
    pub fn without(&self, term: &SetTerm, all: &IndexMap<M::Id, M>) -> Self {
        let left = self.terms_of_union().map(|mut terms| {
            terms.retain(|own| *own != term);
            let nothing = Self::none();
            terms.into_iter().fold(nothing, |set, own| set.with(own))
        });
        let left = left.unwrap_or_else(|| self.clone());
        let still = left.of(all, &BTreeSet::new());
        let is_still = |(id, member): (&M::Id, &M)| term.names(id, member) && still.contains(id);
        if all.iter().any(is_still) { left.extended(SetOperator::Difference, term) } else { left }
    }

    fn extended(&self, operator: SetOperator, term: &SetTerm) -> Self {
        let mut steps = self.steps.clone();
        let is_first = steps.is_empty();
        steps.push(SetStep::Term(term.clone()));
        let text = if is_first {
            term.to_string()
        } else {
            steps.push(SetStep::Operator(operator));
            let sign = if operator == SetOperator::Difference { '-' } else { '|' };
            format!("{} {sign} {term}", self.text.trim())
        };
        Self::new(text, steps)
    }

    /// Terms of a set that is nothing but terms joined by `|`.
    fn terms_of_union(&self) -> Option<Vec<&SetTerm>> {
        let is_union = |step: &SetStep| match step {
            SetStep::Term(_) => true,
            SetStep::Operator(operator) => *operator == SetOperator::Union,
        };
        let terms = self.steps.iter().filter_map(|step| match step {
            SetStep::Term(term) => Some(term),
            SetStep::Operator(_) => None,
        });
        self.steps.iter().all(is_union).then(|| terms.collect())
    }

    /// Terms that name none of all members.
    pub fn idle_terms<'s>(
        &'s self,
        all: &'s IndexMap<M::Id, M>,
    ) -> impl Iterator<Item = &'s SetTerm> + 's {
        let terms = self.steps.iter().filter_map(|step| match step {
            SetStep::Term(SetTerm::All | SetTerm::Source) | SetStep::Operator(_) => None,
            SetStep::Term(term) => Some(term),
        });
        terms.filter(|term| !all.iter().any(|(id, member)| term.names(id, member)))
    }

    /// Warnings of terms that name none of all members; `whose` begins them: whose set it is.
    pub fn idle_warnings(&self, whose: &str, all: &IndexMap<M::Id, M>) -> Vec<Diagnostic> {
        let groups = || all.values().flat_map(SetMember::groups).map(AsRef::as_ref);
        let names = || all.values().map(SetMember::name).filter(|name| !name.is_empty());
        let idle = |term: &SetTerm| {
            let (what, known): (Text, Vec<&str>) = match term {
                SetTerm::Group(_) => (M::GROUP, groups().collect()),
                SetTerm::Name(_) => (M::NAMED, names().collect()),
                _ => (M::WORD, all.keys().map(AsRef::as_ref).collect()),
            };
            let word = term.word();
            let message = tr!("{whose} names the {what} `{word}`, which there is not");
            let warning = Diagnostic::warning(M::UNKNOWN, message);
            // Whoever renamed a light writes its name.
            let is_named = |(_, member): &(&M::Id, &M)| member.name().eq_ignore_ascii_case(word);
            match all.iter().find(is_named).filter(|_| matches!(term, SetTerm::Id(_))) {
                Some((id, member)) => {
                    let (name, id) = (member.name(), id.as_ref());
                    warning.hint(tr!("write `{id}`, or the name in quotes: `\"{name}\"`"))
                }
                None => warning.suggest(word, known),
            }
        };
        self.idle_terms(all).map(idle).collect()
    }
}

impl<M> fmt::Debug for MemberSet<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "MemberSet({:?})", self.text)
    }
}

impl<M: SetMember> TryFrom<String> for MemberSet<M> {
    type Error = SetError;

    fn try_from(text: String) -> Result<Self, SetError> {
        Self::parse(&text)
    }
}

impl<M> From<MemberSet<M>> for String {
    fn from(set: MemberSet<M>) -> Self {
        set.text
    }
}

/// True if `text` is what `pattern` says, where `*` stands for any letters and `?` for one.
fn matches(pattern: &str, text: &str) -> bool {
    let (pattern, text) = (pattern.as_bytes(), text.as_bytes());
    // Where the last `*` stands, and where the text went on behind what it stood for.
    let (mut p, mut t, mut star) = (0, 0, None);
    while t < text.len() {
        match pattern.get(p) {
            Some(b'*') => {
                star = Some((p, t));
                p += 1;
            }
            Some(letter) if *letter == b'?' || *letter == text[t] => {
                p += 1;
                t += 1;
            }
            _ => {
                let Some((at, from)) = star else { return false };
                star = Some((at, from + 1));
                p = at + 1;
                t = from + 1;
            }
        }
    }
    pattern[p..].iter().all(|letter| *letter == b'*')
}

/// Part of the text of a set.
enum SetToken {
    Term(SetTerm),
    Operator(SetOperator),
    Open,
    Close,
}

/// Operator, or parenthesis with its place, that waits for its right side.
#[derive(Clone, Copy)]
enum WaitingMark {
    Operator(SetOperator),
    Open(usize),
}

/// Reader of an expression: operators wait until what stands to their right is read.
struct SetReader<'t> {
    text: &'t str,
    /// Terms that there may be, in words.
    terms: Text,
    /// Bytes that were read.
    read: usize,
    steps: Vec<SetStep>,
    waiting: Vec<WaitingMark>,
}

impl<'t> SetReader<'t> {
    fn new(text: &'t str, terms: Text) -> Self {
        Self { text, terms, read: 0, steps: Vec::new(), waiting: Vec::new() }
    }

    fn error(&self, at: usize, reason: impl Into<String>) -> SetError {
        SetError { at: self.text[..at].chars().count(), reason: reason.into() }
    }

    fn steps(mut self) -> Result<Vec<SetStep>, SetError> {
        let mut wants_term = true;
        loop {
            self.read += self.rest().len() - self.rest().trim_start().len();
            let at = self.read;
            let Some(token) = self.token()? else { break };
            match token {
                SetToken::Term(term) if wants_term => {
                    self.steps.push(SetStep::Term(term));
                    wants_term = false;
                }
                SetToken::Open if wants_term => self.waiting.push(WaitingMark::Open(at)),
                SetToken::Term(_) | SetToken::Open => {
                    return Err(self.error(at, tr!("`|`, `-` or `&` is missing")));
                }
                SetToken::Operator(_) | SetToken::Close if wants_term => {
                    return Err(self.error(at, tr!("{terms} is missing", terms = self.terms)));
                }
                SetToken::Operator(operator) => {
                    self.finish(|waiting| !operator.binds_more(waiting));
                    self.waiting.push(WaitingMark::Operator(operator));
                    wants_term = true;
                }
                SetToken::Close => {
                    self.finish(|_| true);
                    if self.waiting.pop().is_none() {
                        return Err(self.error(at, tr!("this `)` closes nothing")));
                    }
                }
            }
        }
        // An empty text is the set of no lights.
        if wants_term && !(self.steps.is_empty() && self.waiting.is_empty()) {
            return Err(self.error(self.text.len(), tr!("{terms} is missing", terms = self.terms)));
        }
        self.finish(|_| true);
        match self.waiting.pop() {
            Some(WaitingMark::Open(at)) => Err(self.error(at, tr!("this `(` is not closed"))),
            _ => Ok(self.steps),
        }
    }

    /// Appends waiting operators, up to the parenthesis, as long as they are to be applied.
    fn finish(&mut self, is_applied: impl Fn(SetOperator) -> bool) {
        while let Some(WaitingMark::Operator(operator)) = self.waiting.last().copied() {
            if !is_applied(operator) {
                return;
            }
            self.steps.push(SetStep::Operator(operator));
            self.waiting.pop();
        }
    }

    fn rest(&self) -> &'t str {
        &self.text[self.read..]
    }

    /// The next part of the text; `None` at its end.
    fn token(&mut self) -> Result<Option<SetToken>, SetError> {
        let (rest, at) = (self.rest(), self.read);
        let Some(first) = rest.chars().next() else { return Ok(None) };
        let mark = match first {
            '|' => Some(SetToken::Operator(SetOperator::Union)),
            '-' => Some(SetToken::Operator(SetOperator::Difference)),
            '&' => Some(SetToken::Operator(SetOperator::Intersection)),
            '(' => Some(SetToken::Open),
            ')' => Some(SetToken::Close),
            _ => None,
        };
        if let Some(mark) = mark {
            self.read += first.len_utf8();
            return Ok(Some(mark));
        }
        let term = if rest.starts_with(SOURCE) {
            self.read += SOURCE.len();
            SetTerm::Source
        } else if first == '"' {
            SetTerm::Name(self.quoted()?)
        } else {
            match self.word().strip_prefix(GROUP) {
                Some("") if self.rest().starts_with('"') => {
                    return Err(self.error(self.read, tr!("groups are written without quotes")));
                }
                Some(group) => SetTerm::Group(self.checked(group, at + GROUP.len())?),
                None => match &self.text[at..self.read] {
                    "*" => SetTerm::All,
                    word => SetTerm::Id(self.checked(word, at)?),
                },
            }
        };
        Ok(Some(SetToken::Term(term)))
    }

    /// The letters up to the next mark or white space.
    fn word(&mut self) -> &'t str {
        let rest = self.rest();
        let ends = |letter: char| letter.is_whitespace() || "|&()\"{}".contains(letter);
        let length = rest.find(ends).unwrap_or(rest.len());
        // A mark that begins nothing is a word of its own, to be refused.
        let length = length.max(rest.chars().next().map_or(0, char::len_utf8));
        self.read += length;
        &rest[..length]
    }

    /// A name up to the closing quote.
    fn quoted(&mut self) -> Result<String, SetError> {
        let (inside, at) = (&self.rest()[1..], self.read);
        let length =
            inside.find('"').ok_or_else(|| self.error(at, tr!("this `\"` is not closed")))?;
        self.read += length + 2;
        Ok(inside[..length].to_owned())
    }

    /// A word that can be an id, whatever `*` and `?` in it stand for.
    fn checked(&self, word: &str, at: usize) -> Result<String, SetError> {
        if is_slug(&word.replace(['*', '?'], "_")) {
            return Ok(word.to_owned());
        }
        let reason = if word.is_empty() {
            tr!("a group is missing").to_owned()
        } else {
            tr!("`{word}` is no id; write a name with other letters in double quotes")
        };
        Err(self.error(at, reason))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn lights() -> IndexMap<LightId, Light> {
        let light = |name: &str, groups: &[&str]| Light {
            name: name.to_owned(),
            groups: groups.iter().map(|group| LightGroup::new(*group)).collect(),
            ..Light::default()
        };
        IndexMap::from([
            ("key".into(), light("Key light", &["set", "sun"])),
            ("fill".into(), light("", &["set"])),
            ("rim-left".into(), light("Rim", &["rim"])),
            ("rim-right".into(), light("Rim", &["rim", "set"])),
            ("eye".into(), light("", &[])),
        ])
    }

    fn ids(text: &str) -> String {
        let source = BTreeSet::from(["eye".into(), "key".into()]);
        let set = LightSet::parse(text).unwrap_or_else(|why| panic!("{text}: {why}"));
        assert_eq!(set.text(), text);
        let found = set.of(&lights(), &source);
        found.iter().map(LightId::as_str).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn sets_are_said_by_ids_names_and_groups() {
        for (text, expected) in [
            ("", ""),
            ("  ", ""),
            ("*", "eye fill key rim-left rim-right"),
            ("key", "key"),
            ("rim-left|key", "key rim-left"),
            ("\"Rim\"", "rim-left rim-right"),
            ("group:rim", "rim-left rim-right"),
            ("rim-*", "rim-left rim-right"),
            ("?ey", "key"),
            ("group:s*", "fill key rim-right"),
            ("key | group:rim - group:set", "rim-left"),
            ("key | (group:rim - group:set)", "key rim-left"),
            ("* - group:set", "eye rim-left"),
            ("* - (key | fill) - eye", "rim-left rim-right"),
            ("key | group:rim & group:set", "key rim-right"),
            ("{source}", "eye key"),
            ("{source} | fill - key", "eye fill"),
            ("nobody", ""),
        ] {
            assert_eq!(ids(text), expected, "{text}");
        }
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        for (text, at, reason) in [
            ("key |", 5, "a light or a group is missing"),
            ("| key", 0, "a light or a group is missing"),
            ("key fill", 4, "`|`, `-` or `&` is missing"),
            ("(key | fill", 0, "this `(` is not closed"),
            ("()", 1, "a light or a group is missing"),
            ("(", 1, "a light or a group is missing"),
            ("key)", 3, "this `)` closes nothing"),
            ("\"Key", 0, "this `\"` is not closed"),
            ("group:", 6, "a group is missing"),
            ("group:\"a b\"", 6, "groups are written without quotes"),
            ("kéy", 0, "`kéy` is no id; write a name with other letters in double quotes"),
            ("é | {sauce}", 0, "`é` is no id; write a name with other letters in double quotes"),
            ("key | {sauce}", 6, "`{` is no id; write a name with other letters in double quotes"),
        ] {
            let found = LightSet::parse(text).expect_err(text);
            assert_eq!(found, SetError { at, reason: reason.to_owned() }, "{text}");
        }
    }

    #[test]
    fn a_term_that_is_taken_out_leaves_no_trace() {
        let lights = lights();
        let [key, set] = [SetTerm::Id("key".to_owned()), SetTerm::Group("set".to_owned())];
        let none = LightSet::none();
        let both = none.with(&key).with(&set);
        assert_eq!(both.text(), "key | group:set");
        // The key light is of the set, too.
        assert_eq!(both.without(&key, &lights).text(), "group:set - key");
        assert_eq!(both.without(&set, &lights).text(), "key - group:set");
        assert_eq!(none.with(&key).without(&key, &lights), none);
        assert_eq!(LightSet::all().without(&set, &lights).text(), "* - group:set");
    }

    #[test]
    fn terms_that_name_nothing_are_found() {
        let set = LightSet::parse("kye | group:rims - \"Rim\" & * | {source}").unwrap();
        let lights = lights();
        let found: Vec<String> = set.idle_terms(&lights).map(SetTerm::to_string).collect();
        assert_eq!(found, ["kye", "group:rims"]);
    }

    #[test]
    fn who_writes_a_name_without_quotes_is_told_so() {
        let hints = |text: &str| {
            let warnings = LightSet::parse(text).unwrap().idle_warnings("it", &lights());
            warnings.into_iter().map(|one| one.hints.concat()).collect::<Vec<_>>()
        };
        assert_eq!(hints("rim"), ["write `rim-left`, or the name in quotes: `\"Rim\"`"]);
        assert_eq!(hints("kye"), ["did you mean `eye` or `key`?"]);
    }

    /// A set with its members by the algebra of sets, written down for each pair of operands.
    fn expressions() -> impl Strategy<Value = (String, BTreeSet<LightId>)> {
        let set = |ids: &[&str]| -> BTreeSet<LightId> {
            ids.iter().map(|id| LightId::from(*id)).collect()
        };
        let terms = prop::sample::select(vec![
            ("*".to_owned(), set(&["key", "fill", "rim-left", "rim-right", "eye"])),
            ("key".to_owned(), set(&["key"])),
            ("\"Rim\"".to_owned(), set(&["rim-left", "rim-right"])),
            ("group:set".to_owned(), set(&["key", "fill", "rim-right"])),
            ("{source}".to_owned(), set(&["eye", "key"])),
            ("missing".to_owned(), set(&[])),
        ]);
        terms.prop_recursive(6, 48, 2, |inner| {
            let operator = prop::sample::select(vec!['|', '-', '&']);
            (inner.clone(), operator, inner).prop_map(|((a, x), operator, (b, y))| {
                let members = match operator {
                    '|' => x.union(&y).cloned().collect(),
                    '-' => x.difference(&y).cloned().collect(),
                    _ => x.intersection(&y).cloned().collect(),
                };
                (format!("({a}) {operator} ({b})"), members)
            })
        })
    }

    proptest! {
        #[test]
        fn sets_are_those_of_their_algebra((text, members) in expressions()) {
            let source = BTreeSet::from(["eye".into(), "key".into()]);
            let set = LightSet::parse(&text).unwrap();
            prop_assert_eq!(set.of(&lights(), &source), members);
        }

        #[test]
        fn a_set_in_the_place_of_its_source_is_what_it_was(
            (outer, _) in expressions(),
            (inner, members) in expressions(),
            name in prop::sample::select(vec!["", " | \"{source}\""]),
        ) {
            let [outer, inner] = [outer + name, inner].map(|text| LightSet::parse(&text).unwrap());
            let source = BTreeSet::from(["eye".into(), "key".into()]);
            let both = outer.with_source(&inner);
            prop_assert_eq!(both.of(&lights(), &source), outer.of(&lights(), &members));
            let less = outer.minus(&inner).of(&lights(), &source);
            prop_assert_eq!(less, &outer.of(&lights(), &source) - &members);
        }

        #[test]
        fn laws_of_sets_hold(sets in [expressions(), expressions(), expressions()]) {
            let [a, b, c] = sets.map(|(text, _)| text);
            for (one, other) in [
                (format!("({a}) - ({b})"), format!("({a}) & (* - ({b}))")),
                (format!("* - (({a}) | ({b}))"), format!("(* - ({a})) & (* - ({b}))")),
                (format!("({a}) & (({b}) | ({c}))"), format!("({a}) & ({b}) | ({a}) & ({c})")),
                (format!("({a}) - ({b}) - ({c})"), format!("({a}) - (({b}) | ({c}))")),
                (format!("({a}) | ({b}) & ({c})"), format!("({a}) | (({b}) & ({c}))")),
            ] {
                prop_assert_eq!(ids(&one), ids(&other), "{} and {}", one, other);
            }
        }

        #[test]
        fn terms_are_put_in_and_taken_out(
            (text, _) in expressions(),
            term in prop::sample::select(vec![
                SetTerm::Id("key".to_owned()),
                SetTerm::Group("set".to_owned()),
                SetTerm::Name("Rim".to_owned()),
            ]),
        ) {
            let lights = lights();
            let set = LightSet::parse(&text).unwrap();
            let of = |set: &LightSet| set.of(&lights, &BTreeSet::new());
            let own = of(&LightSet::none().with(&term));
            let (with, without) = (set.with(&term), set.without(&term, &lights));
            prop_assert_eq!(of(&with), &of(&set) | &own);
            prop_assert_eq!(of(&without), &of(&set) - &own);
            for made in [with, without] {
                prop_assert_eq!(&LightSet::parse(made.text()).unwrap(), &made);
            }
        }

        #[test]
        fn no_text_is_too_odd(text in ".{0,40}") {
            drop(LightSet::parse(&text));
        }

        #[test]
        fn patterns_match_as_they_read(pattern in "[ab?*]{0,7}", text in "[ab]{0,8}") {
            fn by_the_letter(pattern: &[u8], text: &[u8]) -> bool {
                match (pattern, text) {
                    ([], []) => true,
                    ([b'*', rest @ ..], _) => {
                        (0..=text.len()).any(|skipped| by_the_letter(rest, &text[skipped..]))
                    }
                    ([letter, rest @ ..], [first, others @ ..]) => {
                        (*letter == b'?' || letter == first) && by_the_letter(rest, others)
                    }
                    _ => false,
                }
            }
            let expected = by_the_letter(pattern.as_bytes(), text.as_bytes());
            prop_assert_eq!(matches(&pattern, &text), expected);
        }
    }
}
