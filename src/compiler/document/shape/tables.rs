//! Tables of docs/format.md.

use super::{ChoiceShape, FieldDefault, FieldKind, ObjectShape, number_name};
use crate::document::described::DescribedObject as _;
use crate::document::{Curve, HcbtfManifest, LightField, Look, Ramp, Scene, Shot};

/// Tables in Markdown, one for each kind of object, by the object's name, as docs/format.md has
/// them.
pub fn field_tables() -> Vec<(&'static str, String)> {
    let mut found = Shapes::default();
    for top in [Look::shape(), Scene::shape(), Shot::shape(), HcbtfManifest::shape()] {
        found.collect(top);
    }
    let choice = |choice: &'static ChoiceShape| match choice.name {
        "rule" => (choice.name, crate::document::hcbtf::rule::about::table()),
        name => (name, choice_table(choice)),
    };
    let objects = found.objects.into_iter().map(|shape| (shape.name, table(shape)));
    let choices = found.choices.into_iter().map(choice);
    objects.chain(choices).chain([("light targets", light_targets())]).collect()
}

/// List of the fields of lights that are targets.
fn light_targets() -> String {
    let names: Vec<String> = LightField::names().map(|name| format!("`{name}`")).collect();
    let (last, first) = names.split_last().expect("a light has fields");
    let words = format!("a field of a light: {} or {last}.", first.join(", "));
    list_item(&format!("`\"lights.key.direction\"`: {words}"))
}

/// An item of a list in Markdown, in lines of at most 100 characters.
fn list_item(words: &str) -> String {
    let mut lines = vec![String::from("-")];
    for word in words.split(' ') {
        let line = lines.last_mut().expect("there is a line");
        if line.chars().count() + 1 + word.chars().count() > 100 {
            lines.push(format!("  {word}"));
        } else {
            line.push(' ');
            line.push_str(word);
        }
    }
    lines.join("\n") + "\n"
}

/// Shapes of all objects and choices in a document, each once.
#[derive(Default)]
struct Shapes {
    objects: Vec<&'static ObjectShape>,
    choices: Vec<&'static ChoiceShape>,
}

impl Shapes {
    /// Collects a shape and the shapes in it.
    fn collect(&mut self, shape: &'static ObjectShape) {
        if self.objects.iter().any(|known| known.name == shape.name) {
            return;
        }
        self.objects.push(shape);
        self.collect_fields(shape);
    }

    fn collect_fields(&mut self, shape: &'static ObjectShape) {
        for field in shape.fields() {
            let mut inner = &field.kind;
            while let FieldKind::List(item, _) | FieldKind::Map(item, _) = inner {
                inner = item;
            }
            match inner {
                FieldKind::Object(shape) => self.collect(shape()),
                FieldKind::Choice(choice) => self.collect_choice(choice()),
                FieldKind::Value => {
                    self.collect(Curve::shape());
                    self.collect(Ramp::shape());
                }
                _ => {}
            }
        }
    }

    fn collect_choice(&mut self, choice: &'static ChoiceShape) {
        if self.choices.iter().all(|known| known.name != choice.name) {
            self.choices.push(choice);
            choice.objects.iter().for_each(|shape| self.collect_fields(shape()));
        }
    }
}

/// Table of the objects of a choice, by their words.
fn choice_table(choice: &'static ChoiceShape) -> String {
    let mut table = format!("| {} | fields |\n| --- | --- |\n", choice.name);
    for ((word, help), shape) in choice.words.iter().zip(choice.objects) {
        let fields = shape().fields().filter(|field| field.name != choice.tag).map(|field| {
            let default = match field.default {
                FieldDefault::Json(json) => format!(" (`{}`)", json()),
                _ => String::new(),
            };
            let help = field.help.trim_end_matches('.').replace('|', "\\|");
            format!("`{}`{default}, {}: {help}", field.name, kind_words(&field.kind))
        });
        let fields = fields.collect::<Vec<_>>().join("; ");
        table += &format!("| `{word}`: {} | {fields} |\n", help.trim().trim_end_matches('.'));
    }
    table
}

fn table(shape: &'static ObjectShape) -> String {
    let mut table =
        String::from("| field | takes | default | meaning |\n| --- | --- | --- | --- |\n");
    for field in shape.fields() {
        let default = match field.default {
            FieldDefault::Required => "required".to_owned(),
            FieldDefault::Json(json) => format!("`{}`", json()),
            FieldDefault::Words(words) => words.to_owned(),
        };
        let mut help = field.help.replace('|', "\\|");
        if let FieldKind::Word(words) = &field.kind
            && words.len() > 1
        {
            let all: Vec<String> =
                words.iter().map(|(word, meaning)| format!("`{word}`: {meaning}")).collect();
            help = format!("{help} {}.", all.join("; "));
        }
        table +=
            &format!("| `{}` | {} | {default} | {help} |\n", field.name, kind_words(&field.kind));
    }
    table
}

/// Values that a kind takes, in words.
pub(in crate::document) fn kind_words(kind: &FieldKind) -> String {
    match kind {
        FieldKind::Bool => "`true` or `false`".to_owned(),
        FieldKind::Number(bounds) => bounds.describe(),
        FieldKind::Numbers(least, most, bounds) => {
            let count =
                if least == most { format!("{least}") } else { format!("{least} to {most}") };
            let whole = if bounds.whole { "whole " } else { "" };
            format!(
                "{count} {whole}numbers from {} to {}",
                number_name(bounds.min),
                number_name(bounds.max)
            )
        }
        FieldKind::Direction => "3 numbers, not all 0".to_owned(),
        FieldKind::Color { alpha: false } => "a [color](#colors) without alpha".to_owned(),
        FieldKind::Color { alpha: true } | FieldKind::Backdrop => "a [color](#colors)".to_owned(),
        FieldKind::Rotation => "a [rotation](#rotations)".to_owned(),
        FieldKind::Text(most) => format!("a string of at most {most} bytes"),
        FieldKind::Slug => "an [id](#ids)".to_owned(),
        FieldKind::LightSet => "a [set of lights](#sets-of-lights)".to_owned(),
        FieldKind::ObjectSet => "a [set of objects](#sets-of-lights)".to_owned(),
        FieldKind::Word(words) => {
            words.iter().map(|(word, _)| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
        }
        FieldKind::Output => "`\"node.port\"` or `\"node\"`".to_owned(),
        FieldKind::OutputInGroups => {
            "`\"node.port\"`, `\"node\"` or `\"group/node.port\"`".to_owned()
        }
        FieldKind::Input => "`\"node.port\"`".to_owned(),
        FieldKind::Target => "a [target](#targets)".to_owned(),
        FieldKind::KeyDirection => {
            "`\"view\"`, `{\"light\": id}` or `{\"drivers\": [...]}`".to_owned()
        }
        FieldKind::Rate => "a number, or a fraction such as `\"24000/1001\"`".to_owned(),
        FieldKind::Value => "a [value](#values)".to_owned(),
        FieldKind::Looks => "a path, or an object of paths".to_owned(),
        FieldKind::Object(shape) => format!("{}, an object", linked(shape())),
        FieldKind::Choice(choice) => {
            let name = choice().name;
            format!("a [{name}](#{name}), an object")
        }
        FieldKind::Pair(item) => format!("2 lists of {}", kind_words(item)),
        FieldKind::List(item, most) => format!("a list of {}, at most {most}", plural(item)),
        FieldKind::Map(item, most) => {
            format!("an object of {} by id, at most {most}", plural(item))
        }
        FieldKind::TargetValues => {
            "an object of [values](#values) by [target](#targets), at most 10000".to_owned()
        }
    }
}

fn plural(kind: &FieldKind) -> String {
    match kind {
        FieldKind::Object(shape) => linked(shape()),
        FieldKind::Choice(choice) => format!("[{0}](#{0})", choice().name),
        FieldKind::Slug => "[ids](#ids)".to_owned(),
        FieldKind::Value => "[values](#values)".to_owned(),
        FieldKind::Numbers(2, 2, _) => "`[x, y]`".to_owned(),
        FieldKind::List(item, most) => format!("lists of {}, each of at most {most}", plural(item)),
        other => kind_words(other),
    }
}

fn linked(shape: &ObjectShape) -> String {
    format!("[{}](#{})", shape.name, shape.name.replace(' ', "-"))
}
