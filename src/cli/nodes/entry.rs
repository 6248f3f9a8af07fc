//! Documentation of one kind of node, be it a file, a group or the custom node.

use crate::document::{Tier, Value};
use crate::library::{
    CATEGORIES, CUSTOM_CODE, CUSTOM_KIND, Fallback, GroupDef, Input, Library, NodeDef, Output,
    Preset, TierError, Treatment, Type,
};

/// Documentation of one kind of node.
#[derive(Debug)]
pub(super) struct NodeEntry {
    pub(super) kind: String,
    pub(super) label: String,
    pub(super) category: String,
    /// Paragraphs, with an empty line between them.
    pub(super) help: String,
    /// Inputs that a document can give.
    pub(super) inputs: Vec<Input>,
    pub(super) outputs: Vec<Output>,
    pub(super) presets: Vec<Preset>,
    pub(super) sources: Vec<String>,
    /// Wider types that the node works in if its wires have them.
    pub(super) widths: Vec<Type>,
    pub(super) tiers: Vec<Tier>,
    pub(super) errors: Vec<TierError>,
    pub(super) is_group: bool,
}

impl NodeEntry {
    /// The words that the inputs offer.
    pub(super) fn choices(&self) -> impl Iterator<Item = &str> {
        self.inputs.iter().flat_map(|input| input.options.iter().map(|(word, _)| word.as_str()))
    }

    /// True if `choice` is a word that one of the inputs offers.
    pub(super) fn offers(&self, choice: &str) -> bool {
        self.choices().any(|word| word == choice)
    }
}

/// All kinds of the library, by category: those of [`CATEGORIES`] in their order, then others by
/// name.
pub(super) fn entries(library: &Library) -> Vec<NodeEntry> {
    let groups = library.groups.values().map(|group| of_group(group, library));
    let mut entries: Vec<NodeEntry> =
        groups.chain(library.nodes.values().map(|def| of_node(def))).collect();
    entries.push(custom());
    let rank = |entry: &NodeEntry| {
        CATEGORIES.iter().position(|known| *known == entry.category).unwrap_or(usize::MAX)
    };
    entries.sort_by(|a, b| (rank(a), &a.category).cmp(&(rank(b), &b.category)));
    entries
}

fn of_node(def: &NodeDef) -> NodeEntry {
    let mut widths: Vec<Type> = Vec::new();
    for variant in &def.variants {
        widths.extend(variant.width.clone().filter(|width| !widths.contains(width)));
    }
    let mut outputs = def.outputs.clone();
    if def.special == Treatment::Output {
        // The Output is what the window shows; no wire leaves it.
        outputs.clear();
    }
    NodeEntry {
        kind: def.kind.clone(),
        label: def.label.clone(),
        category: def.category.clone(),
        help: def.help.clone(),
        inputs: def.visible_inputs().cloned().collect(),
        outputs,
        presets: def.presets.clone(),
        sources: def.sources.clone(),
        widths,
        tiers: def.tiers(),
        errors: def.errors.clone(),
        is_group: false,
    }
}

fn of_group(group: &GroupDef, library: &Library) -> NodeEntry {
    let ports = group.ports(library);
    let definition = &group.definition;
    NodeEntry {
        kind: group.id.clone(),
        label: if definition.label.is_empty() {
            group.id.clone()
        } else {
            definition.label.clone()
        },
        category: group.category.clone(),
        help: definition.help.clone(),
        inputs: ports.inputs,
        outputs: ports.outputs,
        presets: Vec::new(),
        sources: Vec::new(),
        widths: Vec::new(),
        tiers: vec![Tier::Exact],
        errors: Vec::new(),
        is_group: true,
    }
}

/// The custom node, whose WGSL is one of its values.
fn custom() -> NodeEntry {
    let code = Input {
        name: CUSTOM_CODE.into(),
        label: "Code".to_owned(),
        help: "WGSL with one function; its parameters become inputs, its result the output."
            .to_owned(),
        ty: Type::Text,
        fallback: Fallback::Value(Value::Text(String::new())),
        min: None,
        max: None,
        unit: String::new(),
        widget: String::new(),
        options: Vec::new(),
        hidden: false,
        light_feed: None,
    };
    let help = "A node of your own, written in the look itself. Its first function is the node: \
                parameters are inputs, \
                the result is the output `value`, or each member of a struct is an output.";
    NodeEntry {
        kind: CUSTOM_KIND.to_owned(),
        label: "Custom WGSL".to_owned(),
        category: "utility".to_owned(),
        help: help.to_owned(),
        inputs: vec![code],
        outputs: Vec::new(),
        presets: Vec::new(),
        sources: Vec::new(),
        widths: Vec::new(),
        tiers: vec![Tier::Exact],
        errors: Vec::new(),
        is_group: false,
    }
}

/// Default of an unwired input without a value, as a document writes it.
pub(super) fn default_text(input: &Input) -> String {
    match &input.fallback {
        Fallback::Wire => "must be wired".to_owned(),
        Fallback::Context(context) => format!("from={}", context.word()),
        Fallback::Same(other) => format!("same={other}"),
        Fallback::Value(Value::Text(text)) if text.is_empty() => "none".to_owned(),
        Fallback::Value(value) => value_text(value, &input.unit),
    }
}

/// The value as a document writes it; angles also in degrees.
pub(super) fn value_text(value: &Value, unit: &str) -> String {
    let json = json_text(value);
    match value {
        Value::Number(x) if unit == "rad" && *x != 0.0 => {
            format!("{json} ({}°)", number(x.to_degrees()))
        }
        _ => json,
    }
}

/// The value as JSON.
pub(super) fn json_text(value: &Value) -> String {
    match value {
        Value::Number(x) => number(*x),
        Value::Vector(v) => {
            format!("[{}]", v.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", "))
        }
        other => serde_json::to_string(other).unwrap_or_default(),
    }
}

/// The range from the least to the greatest value.
pub(super) fn range_text(input: &Input) -> String {
    match (input.min, input.max) {
        (Some(min), Some(max)) => format!("{} to {}", number(min), number(max)),
        (Some(min), None) => format!("{} or more", number(min)),
        (None, Some(max)) => format!("{} or less", number(max)),
        (None, None) => String::new(),
    }
}

/// The number with four decimals, which are more than people type.
fn number(x: f64) -> String {
    let rounded = (x * 1e4).round() / 1e4;
    if rounded == 0.0 && x != 0.0 { format!("{x:e}") } else { rounded.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_a_hand_types_them() {
        use std::f64::consts::FRAC_PI_2;
        assert_eq!(value_text(&Value::Number(FRAC_PI_2), "rad"), "1.5708 (90°)");
        assert_eq!(value_text(&Value::Vector(vec![0.1, 1.0, 0.25]), ""), "[0.1, 1, 0.25]");
        assert_eq!(number(1e-6), "1e-6");
        assert_eq!(json_text(&Value::Bool(true)), "true");
    }

    #[test]
    fn categories_come_in_the_palettes_order_and_others_after_them() {
        let entries = entries(Library::built_in());
        let mut found: Vec<&str> = entries.iter().map(|entry| entry.category.as_str()).collect();
        found.dedup();
        assert_eq!(found, [CATEGORIES.as_slice(), &["utility"]].concat());
    }

    #[test]
    fn everything_of_the_library_has_one_entry() {
        let library = Library::built_in();
        let entries = entries(library);
        assert_eq!(entries.len(), library.nodes.len() + library.groups.len() + 1);
        assert_eq!(
            (entries[0].category.as_str(), entries[0].kind.as_str()),
            ("layer", "light_layer")
        );
        // Hidden inputs are not for the reader.
        assert!(entries.iter().flat_map(|entry| &entry.inputs).all(|input| !input.hidden));
    }
}
