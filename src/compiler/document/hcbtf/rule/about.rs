//! Descriptions of the rules for people, in one list: help on the command line, the table of
//! docs/format.md, the window.

use chiaro_locale::{Text, text, tr};
use serde_json::Value;

use super::Rule;
use crate::document::shape::{FieldDefault, FieldKind, ObjectShape, kind_words};

/// Description of a rule for people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RuleAbout {
    /// Word of the rule in files.
    pub word: &'static str,
    /// Label of the rule in the window.
    pub label: Text,
    /// Effect of the rule; begins with `fills` or `changes`, and ends without a full stop.
    pub does: Text,
}

/// All rules: those that fill, then those that change.
pub(super) const ABOUT: [RuleAbout; 12] = [
    RuleAbout { word: "copy", label: text!("Copy"), does: text!("fills with one painted sample") },
    RuleAbout {
        word: "lock",
        label: text!("Lock angles"),
        does: text!("fills with the nearest painted sample that is equal in all other angles"),
    },
    RuleAbout {
        word: "blend",
        label: text!("Blend"),
        does: text!(
            "fills with the mean of all painted samples, weighted by d^(-2 sharpness) and alpha; \
               d is the root of the sum \
               of the squared great-circle angles between the lights and between the views"
        ),
    },
    RuleAbout {
        word: "morph",
        label: text!("Morph"),
        does: text!(
            "fills with the two or three nearest painted samples, weighted as by `blend`, their \
               strokes moved toward each \
               other in place of faded; blended where nothing in them is alike"
        ),
    },
    RuleAbout {
        word: "mirror",
        label: text!("Highlight"),
        does: text!(
            "fills with one color where the light is less than `width` off the mirrored view; \
               its alpha fades outward as a \
               raised cosine"
        ),
    },
    RuleAbout {
        word: "specular",
        label: text!("Copy near the mirror"),
        does: text!(
            "fills with one painted sample where the light is at most `width` off the mirrored \
               view"
        ),
    },
    RuleAbout { word: "color", label: text!("Color"), does: text!("fills with one color") },
    RuleAbout {
        word: "strokes",
        label: text!("Strokes"),
        does: text!(
            "fills with strokes that stand on the tile, as each eye and each light see them \
               (docs/format.md, *Strokes*)"
        ),
    },
    RuleAbout {
        word: "relief",
        label: text!("Relief"),
        does: text!(
            "fills with a height field as each eye sees it under each light (docs/format.md, *A \
               relief*)"
        ),
    },
    RuleAbout {
        word: "lambert",
        label: text!("Darken by Lambert"),
        does: text!(
            "changes: mixed with the shadow's color by 1 - cos(theta) of the light, times \
               `amount`"
        ),
    },
    RuleAbout {
        word: "rotate",
        label: text!("Turn with the eye"),
        does: text!(
            "changes: the content turned with the view around the normal, `turns` times as fast; \
               Catmull-Rom's cubic kept \
               within the four nearest texels, exact at quarter turns of square tiles, wrapped \
               around where the tile repeats"
        ),
    },
    RuleAbout {
        word: "recolor",
        label: text!("Recolor"),
        does: text!(
            "changes: multiplied by a color, `from` at the normal and `to` at the horizon, or \
               `from` at step 0 and `to` \
               half a turn away; at the normal itself the middle of both"
        ),
    },
];

impl RuleAbout {
    /// Rule of this kind as read from a file that has its word alone.
    pub fn fresh(&self) -> Option<Rule> {
        Rule::of_word(self.word)
    }

    /// Fields of the rule, from the rows that it is read by.
    pub fn fields(&self) -> Vec<RuleField> {
        let choice = Rule::choice();
        let index = choice.words.iter().position(|(word, _)| *word == self.word);
        let shape: Option<&'static ObjectShape> = index.map(|index| choice.objects[index]());
        let fields = shape.into_iter().flat_map(ObjectShape::fields);
        let fields = fields.filter(|field| field.name != choice.tag).map(|field| {
            let takes = match field.kind {
                FieldKind::Object(_) | FieldKind::Choice(_) => None,
                FieldKind::List(FieldKind::Object(_), _) => None,
                _ => Some(kind_words(&field.kind)),
            };
            let default = match field.default {
                FieldDefault::Json(json) => serde_json::from_str(&json()).ok(),
                _ => None,
            };
            RuleField {
                name: field.name,
                takes,
                help: field.help,
                default: default.as_ref().and_then(told),
            }
        });
        fields.collect()
    }
}

/// Description of a field of a rule for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleField {
    /// Name of the field in files.
    pub name: &'static str,
    /// Numbers or words that the field takes; `None` for an object of fields of its own.
    pub takes: Option<String>,
    /// Meaning of the field, with its unit.
    pub help: &'static str,
    /// Default, where it has a short text.
    pub default: Option<String>,
}

impl RuleField {
    /// Line of the field, with all that is said of it, without a full stop.
    pub fn line(&self) -> String {
        let default = self.default.iter().map(|default| format!(" ({default})"));
        let takes = self.takes.iter().map(|takes| format!("; {takes}"));
        let help = self.help.trim_end_matches('.');
        format!(
            "`{}`{}: {help}{}",
            self.name,
            default.collect::<String>(),
            takes.collect::<String>()
        )
    }
}

/// Short text of a value, if there is one.
fn told(value: &Value) -> Option<String> {
    match value {
        Value::Number(number) => {
            number.as_f64().map(|number| format!("{}", (1e4 * number).round() / 1e4))
        }
        Value::String(word) => Some(word.clone()),
        Value::Array(items) if !items.is_empty() => {
            let items: Option<Vec<String>> = items.iter().map(told).collect();
            Some(items?.join(", "))
        }
        Value::Object(fields) if fields.contains_key("light") && fields.contains_key("view") => {
            Some(tr!("straight above").to_owned())
        }
        _ => None,
    }
}

/// Table of docs/format.md.
pub(in crate::document) fn table() -> String {
    let mut table =
        "| rule | in the window | fields, and what they are where left out | what it does |\n"
            .to_owned();
    table += "| --- | --- | --- | --- |\n";
    for about in Rule::ABOUT {
        let fields: Vec<String> = about.fields().iter().map(RuleField::line).collect();
        table += &format!(
            "| `{}` | {} | {} | {} |\n",
            about.word,
            about.label,
            fields.join("; "),
            about.does
        );
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_is_that_of_the_rules() {
        for about in Rule::ABOUT {
            let fresh = about
                .fresh()
                .unwrap_or_else(|| panic!("`{}` has a field without a default", about.word));
            assert_eq!((fresh.word(), fresh.about()), (about.word, about));
            assert!(
                about.does.english().starts_with(if fresh.fills() {
                    "fills "
                } else {
                    "changes: "
                }),
                "{}",
                about.word
            );
        }
        assert_eq!(Rule::choice().words.len(), Rule::ABOUT.len());
        let first = |index: usize| Rule::ABOUT[index].fields().swap_remove(0);
        assert_eq!((first(2).name, first(2).default.as_deref()), ("sharpness", Some("4")));
        assert_eq!(first(2).takes.as_deref(), Some("a number from 0 to 64"));
        assert_eq!(first(0).default.as_deref(), Some("straight above"));
        assert_eq!(first(1).default.as_deref(), Some("view_phi"));
        assert_eq!(
            first(7).line(),
            "`seed` (0): Seed of the random scatter; a whole number from 0 to 4294967295"
        );
    }
}
