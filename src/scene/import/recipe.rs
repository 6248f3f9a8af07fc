//! Recipes: how nodes of another program are made of ours, as text.
//!
//! ```text
//! mix_values(a: bg|0, b: fg|0, factor: mix|0, clamped: false)
//! separate_vector(vector: texcoord|uv()).x
//! image(image: file, wrap: uaddressmode{periodic=repeat,clamp=clamp})
//! ```
//!
//! `kind(port: ..)` is a node of ours, `.x` one of its outputs. A bare name is an input of the
//! other program's node; `|` gives what it is where the file says nothing, and braces say which
//! words become which.

use crate::document::Value;

/// A recipe, read.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Recipe<'t> {
    /// A constant.
    Value(Value),
    /// An input of the other program's node.
    Input {
        /// Name of the input.
        name: &'t str,
        /// Words of the input, with ours.
        words: Vec<(&'t str, &'t str)>,
        /// Source where the file says nothing.
        otherwise: Option<Box<Self>>,
    },
    /// A node of ours.
    Node {
        /// Kind of the node.
        kind: &'t str,
        /// Inputs by port.
        inputs: Vec<(&'t str, Self)>,
        /// Output; empty for the first.
        output: &'t str,
    },
}

impl<'t> Recipe<'t> {
    /// Reads a recipe; `None` for a text that is none.
    pub(super) fn parse(text: &'t str) -> Option<Self> {
        let mut parser = Parser { text };
        let recipe = parser.recipe()?;
        parser.text.trim().is_empty().then_some(recipe)
    }

    /// Calls `visit` with the name of every input that the recipe reads.
    pub(super) fn each_input(&self, visit: &mut impl FnMut(&'t str)) {
        match self {
            Self::Value(_) => {}
            Self::Input { name, otherwise, .. } => {
                visit(name);
                if let Some(otherwise) = otherwise {
                    otherwise.each_input(visit);
                }
            }
            Self::Node { inputs, .. } => {
                inputs.iter().for_each(|(_, recipe)| recipe.each_input(visit));
            }
        }
    }
}

/// A reader of recipes; `text` is what is left.
struct Parser<'t> {
    text: &'t str,
}

impl<'t> Parser<'t> {
    fn recipe(&mut self) -> Option<Recipe<'t>> {
        self.space();
        if self.takes("[") {
            let (list, rest) = self.text.split_once(']')?;
            self.text = rest;
            let numbers: Result<Vec<f64>, _> = list.split(',').map(|n| n.trim().parse()).collect();
            return Some(Recipe::Value(Value::Vector(numbers.ok()?)));
        }
        if self.takes("\"") {
            let (word, rest) = self.text.split_once('"')?;
            self.text = rest;
            return Some(Recipe::Value(Value::Text(word.to_owned())));
        }
        if self.text.starts_with(|c: char| c.is_ascii_digit() || c == '-') {
            let number = self.while_in(|c| c.is_ascii_digit() || "+-.e".contains(c));
            return Some(Recipe::Value(Value::Number(number.parse().ok()?)));
        }
        match self.word()? {
            "true" => Some(Recipe::Value(Value::Bool(true))),
            "false" => Some(Recipe::Value(Value::Bool(false))),
            kind if self.takes("(") => self.node(kind),
            name => self.input(name),
        }
    }

    fn node(&mut self, kind: &'t str) -> Option<Recipe<'t>> {
        let mut inputs = Vec::new();
        while !self.takes(")") {
            let port = self.word()?;
            self.takes(":").then_some(())?;
            inputs.push((port, self.recipe()?));
            self.takes(",");
        }
        let output = if self.takes(".") { self.word()? } else { "" };
        Some(Recipe::Node { kind, inputs, output })
    }

    fn input(&mut self, name: &'t str) -> Option<Recipe<'t>> {
        let mut words = Vec::new();
        if self.takes("{") {
            let (list, rest) = self.text.split_once('}')?;
            self.text = rest;
            for pair in list.split(',') {
                let (from, to) = pair.split_once('=')?;
                words.push((from.trim(), to.trim()));
            }
        }
        let otherwise = if self.takes("|") { Some(Box::new(self.recipe()?)) } else { None };
        Some(Recipe::Input { name, words, otherwise })
    }

    fn word(&mut self) -> Option<&'t str> {
        self.space();
        let word = self.while_in(|c| c.is_ascii_alphanumeric() || c == '_');
        (!word.is_empty()).then_some(word)
    }

    fn while_in(&mut self, belongs: impl Fn(char) -> bool) -> &'t str {
        let end = self.text.find(|c| !belongs(c)).unwrap_or(self.text.len());
        let (found, rest) = self.text.split_at(end);
        self.text = rest;
        found
    }

    fn space(&mut self) {
        self.text = self.text.trim_start();
    }

    fn takes(&mut self, sign: &str) -> bool {
        self.space();
        let Some(rest) = self.text.strip_prefix(sign) else { return false };
        self.text = rest;
        true
    }
}
