//! Tables of docs/format.md.

use super::{FieldDefault, FieldKind, ObjectShape, number_name};
use crate::document::described::DescribedObject as _;
use crate::document::{Curve, LightField, Look, Ramp, Scene};

/// Tables in Markdown, one for each kind of object, by the object's name, as docs/format.md has
/// them.
pub fn field_tables() -> Vec<(&'static str, String)> {
    let mut shapes = Vec::new();
    for top in [Look::shape(), Scene::shape()] {
        collect(top, &mut shapes);
    }
    let rules = ("hcbtf-rules", crate::document::hcbtf::rule::about::table());
    let targets = ("light targets", light_targets());
    shapes.into_iter().map(|shape| (shape.name, table(shape))).chain([rules, targets]).collect()
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

/// Collects the shape and the shapes of all objects in it, each once.
fn collect(shape: &'static ObjectShape, found: &mut Vec<&'static ObjectShape>) {
    if found.iter().any(|known| known.name == shape.name) {
        return;
    }
    found.push(shape);
    for field in shape.fields() {
        let inner = match &field.kind {
            FieldKind::List(item, _) | FieldKind::Map(item, _) => item,
            kind => kind,
        };
        match inner {
            FieldKind::Object(shape) => collect(shape(), found),
            FieldKind::Value => {
                collect(Curve::shape(), found);
                collect(Ramp::shape(), found);
            }
            _ => {}
        }
    }
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

fn kind_words(kind: &FieldKind) -> String {
    match kind {
        FieldKind::Bool => "`true` or `false`".to_owned(),
        FieldKind::Number(bounds) => bounds.describe(),
        FieldKind::Numbers(least, most, bounds) => {
            let count =
                if least == most { format!("{least}") } else { format!("{least} to {most}") };
            format!(
                "{count} numbers from {} to {}",
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
        FieldKind::Word(words) => {
            words.iter().map(|(word, _)| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
        }
        FieldKind::Output => "`\"node.port\"` or `\"node\"`".to_owned(),
        FieldKind::Input => "`\"node.port\"`".to_owned(),
        FieldKind::Target => "a [target](#targets)".to_owned(),
        FieldKind::KeyDirection => {
            "`\"view\"`, `{\"light\": id}` or `{\"drivers\": [...]}`".to_owned()
        }
        FieldKind::Value => "a [value](#values)".to_owned(),
        FieldKind::Looks => "a path, or an object of paths".to_owned(),
        FieldKind::Object(shape) => format!("{}, an object", linked(shape())),
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
        FieldKind::Slug => "[ids](#ids)".to_owned(),
        FieldKind::Value => "[values](#values)".to_owned(),
        FieldKind::Numbers(..) => "`[x, y]`".to_owned(),
        other => kind_words(other),
    }
}

fn linked(shape: &ObjectShape) -> String {
    format!("[{}](#{})", shape.name, shape.name.replace(' ', "-"))
}
