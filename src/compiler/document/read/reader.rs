//! Typed access to the fields of a parsed document. Invalid values are reported with their places
//! and left out.

use std::borrow::Cow;
use std::collections::BTreeMap;

use chiaro_locale::{tr, tr_in};

use crate::diag::Diagnostic;
use crate::document::color::{parse_hex, srgb_to_linear};
use crate::document::hex::long_hex;
use crate::document::json::{JsonKind, Tree, ValueIndex};
use crate::document::problems::Problems;
use crate::document::shape::{self, NumberBounds, ObjectShape};
use crate::document::source::member_path;
use crate::document::{ColorSpace, UnknownFields};
use crate::ids::{is_slug, make_slug};

/// Step from a value to a value in it.
#[derive(Clone, Copy)]
pub(in crate::document) enum PathStep {
    Field(&'static str),
    Key(ValueIndex),
    Index(u32),
}

/// Reader of one document.
pub(in crate::document) struct Reader<'t> {
    pub(in crate::document) tree: &'t Tree,
    problems: &'t mut Problems,
    pub(in crate::document) path: Vec<PathStep>,
    /// Indices of the items kept in lists; see [`SourceMap`](crate::document::source::SourceMap).
    pub(in crate::document) kept: BTreeMap<String, Vec<u32>>,
    /// Color space of the document, which decides how `#rrggbb` is decoded.
    pub(in crate::document) color_space: ColorSpace,
    /// Number of drivers that decide between the direction keys of the set that is read; `None`
    /// where a direction does.
    pub(in crate::document) key_axes: Option<usize>,
}

/// Members of one object, by the fields of its shape.
pub(in crate::document) struct Fields {
    shape: &'static ObjectShape,
    at: ValueIndex,
    found: [Option<ValueIndex>; 24],
    /// Members that the shape does not know. Unknown fields of a field's own parts lie here too,
    /// under the field's name and the part's id, so that each part's type need not hold them.
    pub(in crate::document) unknown: UnknownFields,
}

impl Fields {
    /// Value of a field, if it is there.
    pub(in crate::document) fn get(&self, name: &str) -> Option<ValueIndex> {
        let (index, _) = self.shape.field(name).expect("a field of the shape");
        self.found[index]
    }

    /// Place of the object itself.
    pub(in crate::document) fn at(&self) -> ValueIndex {
        self.at
    }

    fn kind(&self, name: &str) -> &'static shape::FieldKind {
        &self.shape.field(name).expect("a field of the shape").1.kind
    }

    /// Keeps unknown fields of a field's value.
    pub(in crate::document) fn shadow(&mut self, name: &str, extras: UnknownFields) {
        if extras.is_empty() {
            return;
        }
        let of_field = self.unknown.entry(name).or_insert_with(|| UnknownFields::new().into());
        if let Some(of_field) = of_field.as_object_mut() {
            of_field.extend(extras);
        }
    }
}

impl<'t> Reader<'t> {
    pub(in crate::document) fn new(tree: &'t Tree, problems: &'t mut Problems) -> Self {
        Self {
            tree,
            problems,
            path: Vec::new(),
            kept: BTreeMap::new(),
            color_space: ColorSpace::Display,
            key_axes: None,
        }
    }

    /// Reports a problem at a value. A list or object without its end gets no further report: the
    /// missing end is its problem.
    pub(in crate::document) fn report(&mut self, at: ValueIndex, problem: Diagnostic) {
        if self.tree.is_cut(at) {
            return;
        }
        let path = self.json_path();
        let problem = if path.is_empty() { problem } else { problem.json_path(path) };
        self.problems.push(self.tree.start(at), problem);
    }

    /// JSON path of the reader's place, e.g. `nodes[3].values.offset`.
    pub(in crate::document) fn json_path(&self) -> String {
        self.path.iter().fold(String::new(), |path, step| match step {
            PathStep::Field(name) => member_path(&path, name),
            PathStep::Key(at) => member_path(&path, &self.tree.key(*at)),
            PathStep::Index(index) => format!("{path}[{index}]"),
        })
    }

    /// Reports a problem with the name of the member where the reader is.
    pub(in crate::document) fn report_name(&mut self, at: ValueIndex, problem: Diagnostic) {
        let path = self.json_path();
        self.problems.push(self.tree.key_start(at), problem.json_path(path));
    }

    /// Reports a problem with an item of the list where the reader is.
    pub(in crate::document) fn report_item(
        &mut self,
        index: u32,
        at: ValueIndex,
        problem: Diagnostic,
    ) {
        self.at_index(index as usize, |r| r.report(at, problem));
    }

    pub(in crate::document) fn wrong_type(&mut self, at: ValueIndex, expected: &str) {
        let kind = self.tree.kind(at);
        if kind == JsonKind::Bad {
            return; // The parser has reported it.
        }
        let mut problem = Diagnostic::error(
            "wrong-type",
            tr!("expected {expected}, found {found}", found = kind.noun()),
        );
        let is_item = matches!(self.path.last(), Some(PathStep::Index(_)));
        if kind == JsonKind::Null && !is_item {
            problem = problem.hint(tr!("leave the field out for its default"));
        } else if let Some(number) =
            self.tree.string(at).filter(|text| text.parse::<f64>().is_ok_and(f64::is_finite))
        {
            problem = problem.hint(tr!("write {number} without quotes"));
        }
        self.report(at, problem);
    }

    /// Members of an object; the unknown ones are warned about and kept.
    pub(in crate::document) fn object(
        &mut self,
        at: ValueIndex,
        shape: &'static ObjectShape,
    ) -> Option<Fields> {
        if self.tree.kind(at) != JsonKind::Object {
            self.wrong_type(at, &tr!("{noun} (an object)", noun = with_article(shape.name)));
            return None;
        }
        let mut fields = Fields { shape, at, found: [None; 24], unknown: UnknownFields::new() };
        let tree = self.tree;
        for member in tree.children(at) {
            let name = tree.key(member);
            match shape.field(&name) {
                Some((index, _)) if fields.found[index].is_none() => {
                    fields.found[index] = Some(member);
                }
                None if !fields.unknown.contains_key(&*name) => {
                    self.unknown_field(member, &name, shape);
                    fields.unknown.insert(name.into_owned(), tree.to_json(member));
                }
                _ => self.duplicate_key(member, &name),
            }
        }
        Some(fields)
    }

    fn unknown_field(&mut self, at: ValueIndex, name: &str, shape: &'static ObjectShape) {
        let message = tr!(
            "{noun} has no field `{name}`; it is kept as it is",
            noun = with_article(shape.name)
        );
        let known = shape.fields().map(|field| field.name);
        self.path.push(PathStep::Key(at));
        let problem = Diagnostic::warning("unknown-field", message);
        let is_told = self.problems.takes(&problem);
        self.report_name(at, if is_told { problem.suggest(name, known) } else { problem });
        self.path.pop();
    }

    pub(in crate::document) fn duplicate_key(&mut self, at: ValueIndex, name: &str) {
        let message = tr!("`{name}` is given twice; the first is used");
        self.path.push(PathStep::Key(at));
        self.report_name(at, Diagnostic::error("duplicate-key", message).hint(tr!("remove one")));
        self.path.pop();
    }

    /// Reads a field's value, if there is one; a missing field that is required is reported.
    pub(in crate::document) fn field<T>(
        &mut self,
        fields: &Fields,
        name: &'static str,
        read: impl FnOnce(&mut Self, ValueIndex, &'static shape::FieldKind) -> Option<T>,
    ) -> Option<T> {
        let Some(at) = fields.get(name) else {
            self.missing(fields, name);
            return None;
        };
        self.path.push(PathStep::Field(name));
        let value = read(self, at, fields.kind(name));
        self.path.pop();
        value
    }

    fn missing(&mut self, fields: &Fields, name: &'static str) {
        let Some((_, field)) = fields.shape.field(name) else { return };
        if matches!(field.default, shape::FieldDefault::Required) {
            let message =
                tr!("{noun} needs the field `{name}`", noun = with_article(fields.shape.name));
            self.report(
                fields.at,
                Diagnostic::error("missing-field", message).hint(format!("{name}: {}", field.help)),
            );
        }
    }

    pub(in crate::document) fn number_at(
        &mut self,
        at: ValueIndex,
        bounds: NumberBounds,
    ) -> Option<f64> {
        let Some(number) = self.tree.number(at) else {
            self.wrong_type(at, tr!("a number"));
            return None;
        };
        if !bounds.hold(number) {
            let problem = Diagnostic::error("out-of-range", tr!("{number} is out of range"));
            self.report(at, problem.hint(tr!("write {bounds}", bounds = bounds.describe())));
            return None;
        }
        Some(number)
    }

    pub(in crate::document) fn array_at<const N: usize>(
        &mut self,
        at: ValueIndex,
        bounds: NumberBounds,
    ) -> Option<[f64; N]> {
        self.numbers_at(at, N, N, bounds)?.try_into().ok()
    }

    /// Reads a list of `least` to `most` numbers.
    pub(in crate::document) fn numbers_at(
        &mut self,
        at: ValueIndex,
        least: usize,
        most: usize,
        bounds: NumberBounds,
    ) -> Option<Vec<f64>> {
        let expected =
            if least == most { tr!("{least} numbers") } else { tr!("{least} to {most} numbers") };
        if self.tree.kind(at) != JsonKind::List {
            self.wrong_type(at, &tr!("a list of {expected}"));
            return None;
        }
        let tree = self.tree;
        let count = tree.children(at).count();
        if !(least..=most).contains(&count) {
            self.report(
                at,
                Diagnostic::error("wrong-count", tr!("expected {expected}, found {count}")),
            );
            return None;
        }
        // Every number is read, so that all invalid ones are reported.
        let numbers: Vec<_> = tree
            .children(at)
            .enumerate()
            .map(|(index, item)| self.at_index(index, |r| r.number_at(item, bounds)))
            .collect();
        numbers.into_iter().collect()
    }

    /// Calls `read` one step further down, in an item of a list.
    pub(in crate::document) fn at_index<T>(
        &mut self,
        index: usize,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.path.push(PathStep::Index(index as u32));
        let value = read(self);
        self.path.pop();
        value
    }

    /// True for a direction whose length is not 0; a zero direction is reported.
    pub(in crate::document) fn is_direction(&mut self, at: ValueIndex, direction: &[f64]) -> bool {
        let is_zero = direction.iter().all(|x| x.abs() < 1e-12);
        if is_zero {
            let problem =
                Diagnostic::error("zero-vector", tr!("a direction of length 0 points nowhere"));
            self.report(at, problem.hint(tr!("write any other length, e.g. [0, 0, 1]")));
        }
        !is_zero
    }

    pub(in crate::document) fn text_at(
        &mut self,
        at: ValueIndex,
        most: usize,
    ) -> Option<Cow<'t, str>> {
        let Some(text) = self.tree.string(at) else {
            self.wrong_type(at, tr!("a string"));
            return None;
        };
        if text.len() > most {
            let message =
                tr!("the string has {bytes} bytes; at most {most} are read", bytes = text.len());
            self.report(at, Diagnostic::error("too-long", message));
            return None;
        }
        Some(text)
    }

    pub(in crate::document) fn slug_at(&mut self, at: ValueIndex) -> Option<String> {
        let text = self.text_at(at, shape::LONG)?;
        if is_slug(&text) {
            return Some(text.into_owned());
        }
        self.bad_slug(at, &text);
        None
    }

    fn bad_slug(&mut self, at: ValueIndex, text: &str) {
        let problem = Self::no_slug(text);
        self.report(at, problem);
    }

    pub(in crate::document) fn no_slug(text: &str) -> Diagnostic {
        let shown: String = text.chars().take(80).collect();
        let message = tr!(
            "`{shown}` is no id: one has 1 to 64 of a-z A-Z 0-9 _ - and begins with a letter or _"
        );
        let hint = tr!("write `{id}`", id = make_slug(text, |_| false));
        Diagnostic::error("bad-id", message).hint(hint)
    }

    /// Reads one of these words.
    pub(in crate::document) fn word_at(
        &mut self,
        at: ValueIndex,
        words: &'static [(&'static str, &'static str)],
    ) -> Option<Cow<'t, str>> {
        let text = self.text_at(at, shape::LONG)?;
        if words.iter().any(|(word, _)| *word == text) {
            return Some(text);
        }
        let shown: String = text.chars().take(80).collect();
        let all = words.iter().map(|(word, _)| format!("`{word}`")).collect::<Vec<_>>().join(", ");
        let problem = Diagnostic::error("unknown-word", tr!("`{shown}` is not one of {all}"));
        self.report(at, problem.suggest(&shown, words.iter().map(|(word, _)| *word)));
        None
    }

    /// Reads a color of three numbers, or with `alpha` of three or four.
    pub(in crate::document) fn color_at(
        &mut self,
        at: ValueIndex,
        alpha: bool,
    ) -> Option<Vec<f64>> {
        if let Some(text) = self.tree.string(at) {
            let text = long_hex(&text);
            let Some(hex) = parse_hex(&text).filter(|_| alpha || text.len() == 7) else {
                let hint = if alpha {
                    tr!("write \"#rrggbb\" or \"#rrggbbaa\"")
                } else {
                    tr!("write \"#rrggbb\"")
                };
                let shown: String = text.chars().take(40).collect();
                let problem = Diagnostic::error("bad-color", tr!("`{shown}` is no color"));
                self.report(at, problem.hint(tr!("{hint}, or the numbers [r, g, b]")));
                return None;
            };
            let space = self.color_space;
            let channel = |x: f64| if space == ColorSpace::Linear { srgb_to_linear(x) } else { x };
            let mut color: Vec<f64> = hex[..3].iter().map(|&x| channel(x)).collect();
            color.extend((text.len() == 9).then_some(hex[3]));
            return Some(color);
        }
        if self.tree.kind(at) != JsonKind::List {
            self.wrong_type(at, tr!("a color: [r, g, b] or \"#rrggbb\""));
            return None;
        }
        self.numbers_at(at, 3, if alpha { 4 } else { 3 }, shape::FAR)
    }
}

/// Name with `a` or `an` before it.
pub(in crate::document) fn with_article(name: &str) -> String {
    let article = match name {
        "hcbtf" => return tr!("a painted surface (HCBTF)").to_owned(),
        _ if name.starts_with(['a', 'e', 'i', 'o', 'u']) => "an",
        _ => "a",
    };
    tr_in("part", &format!("{article} {name}")).to_owned()
}
