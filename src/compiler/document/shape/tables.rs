//! Tables of docs/format.md.

use super::{Default, Kind, Shape, say_number};
use crate::document::described::Described as _;
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
fn collect(shape: &'static Shape, found: &mut Vec<&'static Shape>) {
    if found.iter().any(|known| known.name == shape.name) {
        return;
    }
    found.push(shape);
    for field in shape.fields() {
        let inner = match &field.kind {
            Kind::List(item, _) | Kind::Map(item, _) => item,
            kind => kind,
        };
        match inner {
            Kind::Object(shape) => collect(shape(), found),
            Kind::Value => {
                collect(Curve::shape(), found);
                collect(Ramp::shape(), found);
            }
            _ => {}
        }
    }
}

fn table(shape: &'static Shape) -> String {
    let mut table =
        String::from("| field | takes | default | meaning |\n| --- | --- | --- | --- |\n");
    for field in shape.fields() {
        let default = match field.default {
            Default::Required => "required".to_owned(),
            Default::Json(json) => format!("`{}`", json()),
            Default::Words(words) => words.to_owned(),
        };
        let mut help = field.help.replace('|', "\\|");
        if let Kind::Word(words) = &field.kind
            && words.len() > 1
        {
            let all: Vec<String> =
                words.iter().map(|(word, meaning)| format!("`{word}`: {meaning}")).collect();
            help = format!("{help} {}.", all.join("; "));
        }
        table += &format!("| `{}` | {} | {default} | {help} |\n", field.name, say(&field.kind));
    }
    table
}

fn say(kind: &Kind) -> String {
    match kind {
        Kind::Bool => "`true` or `false`".to_owned(),
        Kind::Number(bounds) => bounds.say(),
        Kind::Numbers(least, most, bounds) => {
            let count =
                if least == most { format!("{least}") } else { format!("{least} to {most}") };
            format!("{count} numbers from {} to {}", say_number(bounds.min), say_number(bounds.max))
        }
        Kind::Direction => "3 numbers, not all 0".to_owned(),
        Kind::Color { alpha: false } => "a [color](#colors) without alpha".to_owned(),
        Kind::Color { alpha: true } | Kind::Backdrop => "a [color](#colors)".to_owned(),
        Kind::Rotation => "a [rotation](#rotations)".to_owned(),
        Kind::Text(most) => format!("a string of at most {most} bytes"),
        Kind::Slug => "an [id](#ids)".to_owned(),
        Kind::Word(words) => {
            words.iter().map(|(word, _)| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
        }
        Kind::Output => "`\"node.port\"` or `\"node\"`".to_owned(),
        Kind::Input => "`\"node.port\"`".to_owned(),
        Kind::Target => "a [target](#targets)".to_owned(),
        Kind::KeyDirection => "`\"view\"`, `{\"light\": id}` or `{\"drivers\": [...]}`".to_owned(),
        Kind::Value => "a [value](#values)".to_owned(),
        Kind::Looks => "a path, or an object of paths".to_owned(),
        Kind::Object(shape) => format!("{}, an object", linked(shape())),
        Kind::List(item, most) => format!("a list of {}, at most {most}", plural(item)),
        Kind::Map(item, most) => format!("an object of {} by id, at most {most}", plural(item)),
        Kind::TargetValues => {
            "an object of [values](#values) by [target](#targets), at most 10000".to_owned()
        }
    }
}

fn plural(kind: &Kind) -> String {
    match kind {
        Kind::Object(shape) => linked(shape()),
        Kind::Slug => "[ids](#ids)".to_owned(),
        Kind::Value => "[values](#values)".to_owned(),
        Kind::Numbers(..) => "`[x, y]`".to_owned(),
        other => say(other),
    }
}

fn linked(shape: &Shape) -> String {
    format!("[{}](#{})", shape.name, shape.name.replace(' ', "-"))
}
