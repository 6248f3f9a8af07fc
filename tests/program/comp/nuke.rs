//! Scripts of Nuke, read and computed: nodes that lie on a stack, as its manual says.
//!
//! Of each class only the knobs are known that a document may use; whatever else stands in a script
//! is a fault.

use std::collections::HashMap;

use chiaro::film::exr::ExrContent;

use super::numbers;

/// Classes, each with its knobs beside name, label, place and font.
const CLASSES: [(&str, &[&str]); 12] = [
    (
        "Root",
        &[
            "project_directory",
            "frame",
            "first_frame",
            "last_frame",
            "lock_range",
            "fps",
            "format",
            "colorManagement",
            "workingSpaceLUT",
            "monitorLut",
            "floatLut",
        ],
    ),
    ("BackdropNode", &["tile_color", "bdwidth", "bdheight"]),
    (
        "Read",
        &[
            "file_type",
            "file",
            "format",
            "first",
            "last",
            "origfirst",
            "origlast",
            "origset",
            "raw",
        ],
    ),
    ("Dot", &[]),
    ("Shuffle2", &["fromInput1", "in1", "fromInput2", "mappings"]),
    ("Multiply", &["channels", "value"]),
    ("Merge2", &["operation", "output"]),
    ("Unpremult", &["channels"]),
    ("Premult", &["channels"]),
    ("Expression", &["expr0", "expr1", "expr2"]),
    ("Write", &["channels", "file", "file_type", "raw", "datatype", "create_directories"]),
    ("Cryptomatte", &["matteOutput", "lastSelectedCryptoLayerName"]),
];

const OF_ALL: [&str; 6] = ["inputs", "name", "label", "xpos", "ypos", "note_font_size"];

/// A node with its inputs, by their places in the script.
#[derive(Clone, Debug)]
pub(super) struct NukeNode {
    pub(super) class: String,
    knobs: HashMap<String, String>,
    inputs: Vec<usize>,
}

impl NukeNode {
    /// The value of a knob; empty where the script says none.
    pub(super) fn knob(&self, name: &str) -> &str {
        self.knobs.get(name).map_or("", String::as_str)
    }
}

/// A script, in whose order each node comes after its inputs.
#[derive(Debug)]
pub(super) struct NukeScript {
    pub(super) nodes: Vec<NukeNode>,
    layers: Vec<String>,
}

type Channels = HashMap<String, Vec<f64>>;

impl NukeScript {
    /// Reads a script.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let mut script = Self { nodes: Vec::new(), layers: Vec::new() };
        let mut stack: Vec<usize> = Vec::new();
        let mut variables: HashMap<String, usize> = HashMap::new();
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            if line.starts_with('#') || line.starts_with("version ") {
                continue;
            }
            if let Some(layer) = line.strip_prefix("add_layer {") {
                let layer = layer.strip_suffix('}').ok_or("add_layer is not closed")?;
                let mut words = layer.split(' ');
                let name = words.next().unwrap_or_default();
                if !words.all(|channel| channel.starts_with(&format!("{name}."))) {
                    return Err(format!("channels of another layer: {line}"));
                }
                script.layers.push(name.to_owned());
            } else if let Some(name) = line.strip_prefix("set ") {
                let name = name.strip_suffix(" [stack 0]").ok_or("a set of something else")?;
                let top = stack.last().ok_or("a set on an empty stack")?;
                variables.insert(name.to_owned(), *top);
            } else if let Some(name) = line.strip_prefix("push $") {
                stack.push(*variables.get(name).ok_or_else(|| format!("{name} is not set"))?);
            } else if let Some(class) = line.strip_suffix(" {") {
                let node = script.node_of(class, &mut lines, &mut stack)?;
                script.nodes.push(node);
                if class != "Root" {
                    stack.push(script.nodes.len() - 1);
                }
            } else {
                return Err(format!("no statement: {line}"));
            }
        }
        let mut names: Vec<&str> = script.nodes.iter().map(|node| node.knob("name")).collect();
        names.sort_unstable();
        let count = names.len();
        names.dedup();
        if names.len() < count {
            return Err("two nodes have one name".to_owned());
        }
        Ok(script)
    }

    fn node_of<'t>(
        &self,
        class: &str,
        lines: &mut impl Iterator<Item = &'t str>,
        stack: &mut Vec<usize>,
    ) -> Result<NukeNode, String> {
        let known = CLASSES.iter().find(|(name, _)| *name == class);
        let (_, own) = known.ok_or_else(|| format!("no class {class}"))?;
        let mut knobs = HashMap::new();
        loop {
            let line = lines.next().ok_or("a node is not closed")?;
            if line == "}" {
                break;
            }
            let (knob, value) =
                line.trim_start().split_once(' ').ok_or_else(|| format!("no value: {line}"))?;
            if !own.contains(&knob) && !OF_ALL.contains(&knob) {
                return Err(format!("{class} has no knob {knob}"));
            }
            knobs.insert(knob.to_owned(), value_of(value)?);
        }
        let count: usize = knobs.get("inputs").map_or(Ok(1), |text| text.parse()).unwrap();
        let mut inputs = Vec::new();
        for _ in 0..count {
            inputs.push(stack.pop().ok_or_else(|| format!("{class} finds no input"))?);
        }
        Ok(NukeNode { class: class.to_owned(), knobs, inputs })
    }

    #[track_caller]
    pub(super) fn node(&self, name: &str) -> &NukeNode {
        let found = self.nodes.iter().find(|node| node.knob("name") == name);
        found.unwrap_or_else(|| panic!("no node {name}"))
    }

    pub(super) fn set(&mut self, name: &str, knob: &str, value: &str) {
        let node = self.nodes.iter_mut().find(|node| node.knob("name") == name).unwrap();
        assert!(node.knobs.insert(knob.to_owned(), value.to_owned()).is_some(), "{name}.{knob}");
    }

    /// Result of the script, of a file: red, green, blue and alpha.
    pub(super) fn result(&self, content: &ExrContent) -> Result<[Vec<f64>; 4], String> {
        let mut made: Vec<Channels> = Vec::new();
        for node in &self.nodes {
            let input = |at: usize| made[node.inputs[at]].clone();
            let channels = match node.class.as_str() {
                "Root" | "BackdropNode" => Channels::new(),
                "Read" => self.read(node, content)?,
                "Dot" | "Cryptomatte" | "Write" => input(0),
                "Shuffle2" => shuffled(node, &input(0))?,
                "Multiply" => multiplied(node, input(0))?,
                "Merge2" => merged(node, input(0), &input(1))?,
                "Unpremult" => {
                    by_alpha(input(0), |color, a| if a > 0.0 { color / a } else { color })
                }
                "Premult" => by_alpha(input(0), |color, alpha| color * alpha),
                "Expression" => computed(node, input(0))?,
                other => return Err(format!("{other} is not computed")),
            };
            made.push(channels);
        }
        let at = self.nodes.iter().position(|node| node.class == "Write").ok_or("no Write")?;
        let of = |name: &str| made[at].get(name).cloned().unwrap_or_default();
        Ok(["rgba.red", "rgba.green", "rgba.blue", "rgba.alpha"].map(of))
    }

    /// Layers of a file that the script knows, as numbers that no curve has touched.
    fn read(&self, node: &NukeNode, content: &ExrContent) -> Result<Channels, String> {
        if node.knob("raw") != "true" {
            return Err("the picture is read through a curve".to_owned());
        }
        let words = [("R", "red"), ("G", "green"), ("B", "blue"), ("A", "alpha")];
        let mut read = Channels::new();
        for (name, _) in &content.channels {
            let (layer, channel) = name.rsplit_once('.').unwrap_or(("rgba", name));
            let is_known = layer == "rgba" || self.layers.iter().any(|known| known == layer);
            let word = words.iter().find(|(letter, _)| *letter == channel);
            if let (true, Some((_, word))) = (is_known, word) {
                let numbers = numbers(content, name).iter().map(|x| f64::from(*x)).collect();
                read.insert(format!("{layer}.{word}"), numbers);
            }
        }
        Ok(read)
    }
}

/// A value without quotes and escapes; braces are balanced.
fn value_of(text: &str) -> Result<String, String> {
    let Some(quoted) = text.strip_prefix('"') else {
        let depth = text.chars().try_fold(0_i32, |depth, c| match c {
            '{' => Some(depth + 1),
            '}' if depth == 0 => None,
            '}' => Some(depth - 1),
            _ => Some(depth),
        });
        let is_one = text.starts_with('{') || !text.contains(' ');
        let whole = (depth == Some(0) && is_one).then(|| text.trim_matches(['{', '}']).to_owned());
        return whole.ok_or_else(|| format!("no value: {text}"));
    };
    let quoted = quoted.strip_suffix('"').ok_or_else(|| format!("an open text: {text}"))?;
    let mut value = String::new();
    let mut characters = quoted.chars();
    while let Some(c) = characters.next() {
        match c {
            '"' | '[' | ']' | '$' => return Err(format!("`{c}` is evaluated: {text}")),
            '\\' => match characters.next() {
                Some('n') => value.push('\n'),
                Some(c) => value.push(c),
                None => return Err(format!("an open text: {text}")),
            },
            c => value.push(c),
        }
    }
    Ok(value)
}

fn shuffled(node: &NukeNode, input: &Channels) -> Result<Channels, String> {
    let mut words = node.knob("mappings").split(' ');
    let count: usize = words.next().and_then(|count| count.parse().ok()).ok_or("no mappings")?;
    let words: Vec<&str> = words.collect();
    if words.len() != 6 * count {
        return Err("mappings have six words each".to_owned());
    }
    let pixels = input["rgba.red"].len();
    let mut made = input.clone();
    for mapping in words.chunks(6) {
        let numbers = match mapping[0] {
            "black" => vec![0.0; pixels],
            name if name.starts_with(&format!("{}.", node.knob("in1"))) => {
                input.get(name).cloned().ok_or_else(|| format!("no channel {name}"))?
            }
            other => return Err(format!("{other} is not of the layer")),
        };
        made.insert(mapping[3].to_owned(), numbers);
    }
    Ok(made)
}

const COLORS: [&str; 3] = ["rgba.red", "rgba.green", "rgba.blue"];

fn multiplied(node: &NukeNode, mut input: Channels) -> Result<Channels, String> {
    let gains: Vec<f64> = node.knob("value").split(' ').flat_map(str::parse).collect();
    let ([r, g, b, _], "rgb") = (gains.as_slice(), node.knob("channels")) else {
        return Err("a gain is four numbers, for colors".to_owned());
    };
    for (color, gain) in COLORS.iter().zip([r, g, b]) {
        input.get_mut(*color).ok_or("no color")?.iter_mut().for_each(|x| *x *= gain);
    }
    Ok(input)
}

/// `b` is the first input, whose other channels stay.
fn merged(node: &NukeNode, mut b: Channels, a: &Channels) -> Result<Channels, String> {
    let sign = match (node.knob("operation"), node.knob("output")) {
        ("plus", "rgb") => 1.0,
        ("from", "rgb") => -1.0,
        other => return Err(format!("{other:?} is not computed")),
    };
    for color in COLORS {
        let of_a = &a[color];
        let of_b = b.get_mut(color).ok_or("no color")?;
        of_b.iter_mut().zip(of_a).for_each(|(b, a)| *b += sign * a);
    }
    Ok(b)
}

fn by_alpha(mut input: Channels, change: impl Fn(f64, f64) -> f64) -> Channels {
    let alpha = input["rgba.alpha"].clone();
    for color in COLORS {
        let numbers = input.get_mut(color).expect("a color");
        numbers.iter_mut().zip(&alpha).for_each(|(x, alpha)| *x = change(*x, *alpha));
    }
    input
}

fn computed(node: &NukeNode, mut input: Channels) -> Result<Channels, String> {
    for (color, (knob, name)) in COLORS.iter().zip([("expr0", 'r'), ("expr1", 'g'), ("expr2", 'b')])
    {
        let expression = node.knob(knob).to_owned();
        for x in input.get_mut(*color).ok_or("no color")? {
            let mut rest = Expression { text: &expression, name, value: *x };
            *x = rest.ternary()?;
            if !rest.text.trim().is_empty() {
                return Err(format!("`{}` is left of {expression}", rest.text));
            }
        }
    }
    Ok(input)
}

/// The rest of an expression of one channel.
struct Expression<'t> {
    text: &'t str,
    name: char,
    value: f64,
}

impl Expression<'_> {
    fn takes(&mut self, word: &str) -> bool {
        self.text = self.text.trim_start();
        let rest = self.text.strip_prefix(word);
        rest.map(|rest| self.text = rest).is_some()
    }

    fn ternary(&mut self) -> Result<f64, String> {
        let left = self.sum()?;
        if !self.takes("<=") {
            return Ok(left);
        }
        let is_below = left <= self.sum()?;
        if !self.takes("?") {
            return Err("a comparison without a choice".to_owned());
        }
        let yes = self.sum()?;
        if !self.takes(":") {
            return Err("a choice without its other side".to_owned());
        }
        let no = self.sum()?;
        Ok(if is_below { yes } else { no })
    }

    fn sum(&mut self) -> Result<f64, String> {
        let mut sum = self.product()?;
        loop {
            if self.takes("+") {
                sum += self.product()?;
            } else if self.takes("-") {
                sum -= self.product()?;
            } else {
                return Ok(sum);
            }
        }
    }

    fn product(&mut self) -> Result<f64, String> {
        let mut product = self.atom()?;
        loop {
            if self.takes("*") {
                product *= self.atom()?;
            } else if self.takes("/") {
                product /= self.atom()?;
            } else {
                return Ok(product);
            }
        }
    }

    fn atom(&mut self) -> Result<f64, String> {
        if self.takes("pow(") {
            let base = self.sum()?;
            let is_two = self.takes(",");
            let exponent = self.sum()?;
            return (is_two && self.takes(")"))
                .then(|| base.powf(exponent))
                .ok_or("pow".to_owned());
        }
        if self.takes("(") {
            let inner = self.sum()?;
            return self.takes(")").then_some(inner).ok_or("an open parenthesis".to_owned());
        }
        if self.takes(&self.name.to_string()) {
            return Ok(self.value);
        }
        let is_digit = |c: char| c.is_ascii_digit() || c == '.';
        let end = self.text.find(|c| !is_digit(c)).unwrap_or(self.text.len());
        let (number, rest) = self.text.split_at(end);
        self.text = rest;
        number.parse().map_err(|_| format!("no number: {number}{rest}"))
    }
}
