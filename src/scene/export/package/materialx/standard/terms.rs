//! Terms: numbers and vectors as nodes of MaterialX give them, each once.
//!
//! Nodes give three numbers at most. A vector of four, most often a color with its opacity, is a
//! list of its numbers, and what is done to it is done to the first three and to the fourth: many
//! hosts take a fourth number for an opacity and treat it by itself.

use std::collections::HashMap;
use std::rc::Rc;

use super::operations::fold;

/// Most terms of a graph: beyond, nobody would read it and hosts would be slow.
const MAX_TERMS: usize = 12_000;

/// Place of a term in its list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct TermId(pub(super) usize);

/// Origin of a term.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Origin {
    /// Numbers, by their bits.
    Constant(Vec<u64>),
    /// A value of the surface or the view, by its name.
    Given(&'static str),
    /// An input of the look, by its place.
    Input(usize),
    /// A node of this kind.
    Node(&'static str),
    /// One number of a vector.
    Component(usize),
}

/// A number or a vector.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Term {
    pub(super) origin: Origin,
    pub(super) sources: Vec<TermId>,
    /// Count of numbers, 1 to 4.
    pub(super) width: usize,
}

/// A condition.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Truth {
    /// Known before.
    Known(bool),
    /// The first term is above (`ifgreater`), not below (`ifgreatereq`) or equal to (`ifequal`) the
    /// second.
    Test(&'static str, TermId, TermId),
    /// A boolean input is on.
    Switch(TermId),
    /// Not.
    Not(Rc<Self>),
    /// Both.
    And(Rc<Self>, Rc<Self>),
}

impl Truth {
    /// The opposite.
    pub(super) fn not(self) -> Self {
        match self {
            Self::Known(known) => Self::Known(!known),
            Self::Not(inner) => (*inner).clone(),
            other => Self::Not(Rc::new(other)),
        }
    }

    /// Both of two.
    pub(super) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Known(false), _) | (_, Self::Known(false)) => Self::Known(false),
            (Self::Known(true), it) | (it, Self::Known(true)) => it,
            (one, two) if one == two => one,
            (one, two) => Self::And(Rc::new(one), Rc::new(two)),
        }
    }

    /// One of two or both.
    pub(super) fn or(self, other: Self) -> Self {
        self.not().and(other.not()).not()
    }
}

/// All terms of a look.
#[derive(Debug, Default)]
pub(super) struct Terms {
    pub(super) list: Vec<Term>,
    /// Name of the value that a term is, as the look's source has it; empty for none.
    pub(super) names: Vec<String>,
    /// Name of the artist's node that a term belongs to; empty for none.
    pub(super) groups: Vec<String>,
    /// Artist's node that is followed now.
    pub(super) group: String,
    index: HashMap<Term, TermId>,
}

impl Terms {
    /// True if the graph has become too large.
    pub(super) fn is_full(&self) -> bool {
        self.list.len() > MAX_TERMS
    }

    fn add(&mut self, origin: Origin, sources: &[TermId], width: usize) -> TermId {
        let term = Term { origin, sources: sources.to_vec(), width };
        if let Some(known) = self.index.get(&term) {
            return *known;
        }
        let id = TermId(self.list.len());
        self.index.insert(term.clone(), id);
        self.list.push(term);
        self.names.push(String::new());
        self.groups.push(self.group.clone());
        id
    }

    pub(super) fn term(&self, id: TermId) -> &Term {
        &self.list[id.0]
    }

    pub(super) fn width(&self, id: TermId) -> usize {
        self.term(id).width
    }

    /// A vector of numbers that are known.
    pub(super) fn constant(&mut self, numbers: &[f64]) -> TermId {
        // One zero: negative zeros would only make further nodes.
        let bits = numbers.iter().map(|x| (x + 0.0).to_bits()).collect();
        self.add(Origin::Constant(bits), &[], numbers.len())
    }

    /// A number that is known.
    pub(super) fn number(&mut self, number: f64) -> TermId {
        self.constant(&[number])
    }

    /// A value of the surface or the view.
    pub(super) fn given(&mut self, name: &'static str, width: usize) -> TermId {
        self.add(Origin::Given(name), &[], width)
    }

    /// An input of the look.
    pub(super) fn input(&mut self, place: usize, width: usize) -> TermId {
        self.add(Origin::Input(place), &[], width)
    }

    /// Numbers of a constant.
    pub(super) fn known(&self, id: TermId) -> Option<Vec<f64>> {
        match &self.term(id).origin {
            Origin::Constant(bits) => Some(bits.iter().map(|x| f64::from_bits(*x)).collect()),
            _ => None,
        }
    }

    /// True if all numbers of a term are known to be `number`.
    pub(super) fn is_all(&self, id: TermId, number: f64) -> bool {
        self.known(id).is_some_and(|numbers| numbers.iter().all(|x| *x == number))
    }

    /// A number of a vector.
    pub(super) fn component(&mut self, id: TermId, place: usize) -> TermId {
        if self.width(id) == 1 {
            return id;
        }
        if let Some(numbers) = self.known(id) {
            return self.number(numbers[place]);
        }
        let term = self.term(id);
        match term.origin {
            Origin::Node("combine") => term.sources[place],
            // A number that was made a vector.
            Origin::Node("convert") if self.width(term.sources[0]) == 1 => term.sources[0],
            _ => self.add(Origin::Component(place), &[id], 1),
        }
    }

    /// A vector of numbers.
    pub(super) fn combine(&mut self, parts: &[TermId]) -> TermId {
        if let [one] = parts {
            return *one;
        }
        let known: Option<Vec<f64>> =
            parts.iter().map(|part| self.known(*part).map(|numbers| numbers[0])).collect();
        if let Some(numbers) = known {
            return self.constant(&numbers);
        }
        // A vector that was taken apart.
        let whole = self.term(parts[0]).sources.first().copied();
        let is_whole = |whole: &TermId| parts.len() < 4 && self.width(*whole) == parts.len();
        if let Some(whole) = whole.filter(is_whole) {
            let is_it = |(place, part): (usize, &TermId)| {
                let term = self.term(*part);
                term.origin == Origin::Component(place) && term.sources == [whole]
            };
            if parts.iter().enumerate().all(is_it) {
                return whole;
            }
        }
        self.add(Origin::Node("combine"), parts, parts.len())
    }

    /// A vector with the same number everywhere.
    pub(super) fn splat(&mut self, part: TermId, width: usize) -> TermId {
        match self.known(part) {
            _ if self.width(part) == width => part,
            Some(numbers) => self.constant(&vec![numbers[0]; width]),
            None if width == 4 => self.combine(&[part; 4]),
            None => self.add(Origin::Node("convert"), &[part], width),
        }
    }

    /// An input of another type as numbers.
    pub(super) fn converted(&mut self, input: TermId, width: usize) -> TermId {
        if width < 4 {
            return self.add(Origin::Node("convert"), &[input], width);
        }
        let parts = [0, 1, 2, 3].map(|place| self.component(input, place));
        self.combine(&parts)
    }

    /// The first three numbers of four, and the fourth; a number is both.
    fn split(&mut self, id: TermId) -> [TermId; 2] {
        if self.width(id) < 4 {
            return [id; 2];
        }
        let [x, y, z, w] = [0, 1, 2, 3].map(|place| self.component(id, place));
        [self.combine(&[x, y, z]), w]
    }

    /// Four numbers.
    fn joined(&mut self, first: TermId, last: TermId) -> TermId {
        let first = self.splat(first, 3);
        let [x, y, z] = [0, 1, 2].map(|place| self.component(first, place));
        self.combine(&[x, y, z, last])
    }

    /// The result of a node that works on each number by itself.
    pub(super) fn each(&mut self, kind: &'static str, sources: &[TermId]) -> TermId {
        let width = sources.iter().map(|id| self.width(*id)).max().unwrap_or(1);
        self.node(kind, sources, width)
    }

    /// The result of a node of this width.
    pub(super) fn node(&mut self, kind: &'static str, given: &[TermId], width: usize) -> TermId {
        let mut sources = given.to_vec();
        let known: Option<Vec<Vec<f64>>> = sources.iter().map(|id| self.known(*id)).collect();
        if let Some(numbers) = known.and_then(|numbers| fold(kind, &numbers)) {
            return self.constant(&numbers);
        }
        if sources.iter().any(|id| self.width(*id) == 4) {
            return self.node_of_four(kind, &sources);
        }
        if let [a, b] = sources[..] {
            if let Some(id) = self.without_effect(kind, a, b, width) {
                return id;
            }
            // Nodes take a number for the second of two, never for the first.
            let widths = [self.width(a), self.width(b)];
            if widths[0] < widths[1] {
                match kind {
                    "add" | "multiply" | "min" | "max" => sources.swap(0, 1),
                    _ => sources[0] = self.splat(a, widths[1]),
                }
            }
            if kind == "atan2" {
                sources[1] = self.splat(sources[1], width);
            }
            // The constant last, as people write it.
            if matches!(kind, "add" | "multiply" | "min" | "max" | "dotproduct")
                && self.known(sources[0]).is_some()
                && self.width(sources[0]) == self.width(sources[1])
            {
                sources.swap(0, 1);
            }
            // A vector of one number is the number.
            let same = self.known(sources[1]).filter(|numbers| numbers.len() > 1);
            if let Some(numbers) = same
                && ["add", "subtract", "multiply", "divide", "min", "max", "power", "modulo"]
                    .contains(&kind)
                && numbers.iter().all(|x| *x == numbers[0])
            {
                sources[1] = self.number(numbers[0]);
            }
        } else if sources.len() > 2 {
            // Bounds may be numbers if both are, and so may the share of a mix.
            let widths: Vec<usize> = sources.iter().map(|id| self.width(*id)).collect();
            let is_bounded_by_numbers = kind == "clamp" && widths[1..] == [1, 1];
            for (place, source) in sources.iter_mut().enumerate() {
                let is_number = match kind {
                    "mix" => place == 2,
                    _ => place > 0 && is_bounded_by_numbers,
                };
                if !is_number {
                    *source = self.splat(*source, width);
                }
            }
        }
        self.add(Origin::Node(kind), &sources, width)
    }

    /// The result of a node of four numbers, by those of three and of one.
    fn node_of_four(&mut self, kind: &'static str, sources: &[TermId]) -> TermId {
        let (mut first, mut last) = (Vec::new(), Vec::new());
        for source in sources {
            let [three, one] = self.split(*source);
            first.push(three);
            last.push(one);
        }
        match kind {
            "dotproduct" => {
                let (three, one) = (self.node(kind, &first, 1), self.each("multiply", &last));
                self.each("add", &[three, one])
            }
            "magnitude" => {
                let square = self.node("dotproduct", &[sources[0], sources[0]], 1);
                self.each("sqrt", &[square])
            }
            "normalize" => {
                let length = self.node("magnitude", sources, 1);
                self.each("divide", &[sources[0], length])
            }
            _ => {
                let (three, one) = (self.node(kind, &first, 3), self.node(kind, &last, 1));
                self.joined(three, one)
            }
        }
    }

    /// The operand that stays of a node that does nothing.
    fn without_effect(&mut self, kind: &str, a: TermId, b: TermId, width: usize) -> Option<TermId> {
        let one = match kind {
            "add" if self.is_all(a, 0.0) => b,
            "multiply" if self.is_all(a, 1.0) => b,
            "add" | "subtract" if self.is_all(b, 0.0) => a,
            "multiply" | "divide" | "power" if self.is_all(b, 1.0) => a,
            "multiply" if self.is_all(a, 0.0) || self.is_all(b, 0.0) => self.number(0.0),
            "subtract" if a == b => self.number(0.0),
            "subtract"
                if self.term(a).origin == Origin::Given("eye")
                    && self.term(b).origin == Origin::Given("position") =>
            {
                self.given("to_eye", 3)
            }
            _ => return None,
        };
        Some(self.splat(one, width))
    }

    /// A vector at length 1; the way to the eye is known at that length alone.
    pub(super) fn unit(&mut self, vector: TermId) -> TermId {
        let term = self.term(vector);
        match term.origin {
            Origin::Given("to_eye") => {
                let direction = self.given("view_direction", 3);
                let minus = self.number(-1.0);
                self.each("multiply", &[direction, minus])
            }
            // What has that length keeps it.
            Origin::Given("normal") | Origin::Node("normalize") => vector,
            _ if self.is_unit(vector) => vector,
            _ => {
                let width = term.width;
                self.node("normalize", &[vector], width)
            }
        }
    }

    /// True if a vector is known to have the length 1, but for rounding.
    fn is_unit(&self, vector: TermId) -> bool {
        if let Some(numbers) = self.known(vector) {
            return (numbers.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12;
        }
        let term = self.term(vector);
        match term.origin {
            Origin::Given("view_direction" | "normal") | Origin::Node("normalize") => true,
            Origin::Node("multiply") => {
                let turned = self.known(term.sources[1]).is_some_and(|by| by == [-1.0]);
                turned && self.is_unit(term.sources[0])
            }
            _ => false,
        }
    }

    /// One of two by a condition.
    pub(super) fn choose(&mut self, truth: &Truth, on: TermId, off: TermId) -> TermId {
        if on == off {
            return on;
        }
        let width = self.width(on).max(self.width(off));
        let (on, off) = (self.splat(on, width), self.splat(off, width));
        match truth {
            Truth::Known(true) => on,
            Truth::Known(false) => off,
            Truth::Not(inner) => self.choose(inner, off, on),
            Truth::And(one, two) => {
                let within = self.choose(two, on, off);
                self.choose(one, within, off)
            }
            _ if width == 4 => {
                let ([on, last_on], [off, last_off]) = (self.split(on), self.split(off));
                let (three, one) =
                    (self.choose(truth, on, off), self.choose(truth, last_on, last_off));
                self.joined(three, one)
            }
            Truth::Test(kind, a, b) => self.add(Origin::Node(kind), &[*a, *b, on, off], width),
            Truth::Switch(input) => self.add(Origin::Node("ifequal"), &[*input, on, off], width),
        }
    }

    /// A comparison of two numbers.
    pub(super) fn test(&mut self, kind: &'static str, a: TermId, b: TermId) -> Truth {
        if let (Some(one), Some(two)) = (self.known(a), self.known(b)) {
            let (one, two) = (one[0], two[0]);
            return Truth::Known(match kind {
                "ifgreater" => one > two,
                "ifgreatereq" => one >= two,
                _ => one == two,
            });
        }
        if a == b {
            return Truth::Known(kind != "ifgreater");
        }
        Truth::Test(kind, a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terms_are_made_once_and_folded() {
        let mut terms = Terms::default();
        let (two, three) = (terms.number(2.0), terms.number(3.0));
        let six = terms.each("multiply", &[two, three]);
        assert_eq!(terms.known(six), Some(vec![6.0]));
        let normal = terms.given("normal", 3);
        let parts: Vec<TermId> = (0..3).map(|place| terms.component(normal, place)).collect();
        assert_eq!(terms.combine(&parts), normal);
        let one = terms.each("multiply", &[normal, two]);
        assert_eq!(terms.each("multiply", &[two, normal]), one);
        assert_eq!(terms.term(one).width, 3);
        // Of four numbers, three and one.
        let parts = [0, 1, 2, 0].map(|place| terms.component(normal, place));
        let four = terms.combine(&parts);
        let doubled = terms.each("multiply", &[four, two]);
        let last = terms.component(doubled, 3);
        assert_eq!(terms.term(last).sources, [parts[0], two]);
        let first = [0, 1, 2].map(|place| terms.component(doubled, place));
        assert_eq!(terms.combine(&first), one);
        let zero = terms.number(0.0);
        let nothing = terms.each("multiply", &[normal, zero]);
        assert_eq!(terms.known(nothing), Some(vec![0.0; 3]));
    }

    #[test]
    fn the_way_to_the_eye_is_the_direction_of_view() {
        let mut terms = Terms::default();
        let (eye, position) = (terms.given("eye", 3), terms.given("position", 3));
        let way = terms.each("subtract", &[eye, position]);
        let unit = terms.unit(way);
        assert_eq!(terms.term(unit).origin, Origin::Node("multiply"));
        assert_eq!(terms.unit(unit), unit);
    }

    #[test]
    fn conditions_choose() {
        let mut terms = Terms::default();
        let (x, one, two) = (terms.input(0, 1), terms.number(1.0), terms.number(2.0));
        let above = terms.test("ifgreater", x, one);
        let chosen = terms.choose(&above.clone().not(), one, two);
        assert_eq!(terms.term(chosen).sources, [x, one, two, one]);
        assert_eq!(above.clone().and(Truth::Known(false)), Truth::Known(false));
        assert_eq!(above.clone().or(Truth::Known(false)), above);
    }
}
