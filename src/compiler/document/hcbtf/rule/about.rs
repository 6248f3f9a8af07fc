//! Descriptions of the rules for people, in one list: help on the command line, the table of
//! docs/format.md, the window.

use serde_json::Value;

use super::Rule;

/// Description of a rule for people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RuleAbout {
    /// Word of the rule in files.
    pub word: &'static str,
    /// Label of the rule in the window.
    pub label: &'static str,
    /// Effect of the rule; begins with `fills` or `changes`, and ends without a full stop.
    pub does: &'static str,
    /// Fields of the rule in files, each with its meaning and bounds.
    pub fields: &'static [(&'static str, &'static str)],
}

const SHARPNESS: (&str, &str) =
    ("sharpness", "0 to 64; 1 is soft, at 8 nearly the nearest alone is seen");
const FROM: (&str, &str) = ("from", "a painted sample");
const WIDTH: (&str, &str) = ("width", "radians, 0 to pi");

/// All rules: those that fill, then those that change.
pub(super) const ABOUT: [RuleAbout; 12] = [
    RuleAbout {
        word: "copy",
        label: "Copy",
        does: "fills with one painted sample",
        fields: &[FROM],
    },
    RuleAbout {
        word: "lock",
        label: "Lock angles",
        does: "fills with the nearest painted sample that is equal in all other angles",
        fields: &[("angles", "some of `light_theta`, `light_phi`, `view_theta`, `view_phi`")],
    },
    RuleAbout {
        word: "blend",
        label: "Blend",
        does: "fills with the mean of all painted samples, weighted by d^(-2 sharpness) and alpha; \
               d is the root of the sum \
               of the squared great-circle angles between the lights and between the views",
        fields: &[SHARPNESS],
    },
    RuleAbout {
        word: "morph",
        label: "Morph",
        does: "fills with the two or three nearest painted samples, weighted as by `blend`, their \
               strokes moved toward each \
               other in place of faded; blended where nothing in them is alike",
        fields: &[SHARPNESS],
    },
    RuleAbout {
        word: "mirror",
        label: "Highlight",
        does: "fills with one color where the light is less than `width` off the mirrored view; \
               its alpha fades outward as a \
               raised cosine",
        fields: &[("color", "RGBA bytes"), WIDTH],
    },
    RuleAbout {
        word: "specular",
        label: "Copy near the mirror",
        does: "fills with one painted sample where the light is at most `width` off the mirrored \
               view",
        fields: &[FROM, WIDTH],
    },
    RuleAbout {
        word: "color",
        label: "Color",
        does: "fills with one color",
        fields: &[("color", "RGBA bytes")],
    },
    RuleAbout {
        word: "strokes",
        label: "Strokes",
        does: "fills with strokes that stand on the tile, as each eye and each light see them \
               (docs/format.md, *Strokes*)",
        fields: &[
            ("seed", "another number scatters anew"),
            ("ground", "what is seen between the strokes"),
            ("shadow", "the shadows that they cast"),
            ("bundles", "the strokes, by kind"),
        ],
    },
    RuleAbout {
        word: "relief",
        label: "Relief",
        does: "fills with a height field as each eye sees it under each light (docs/format.md, *A \
               relief*)",
        fields: &[
            ("seed", "another number scatters anew"),
            ("pattern", "what it is a relief of"),
            ("depth", "from the lowest to the highest in widths of the tile, 0 to 1"),
            ("pivot", "the height that stays when the eye moves, 0 to 1"),
            ("light", "the sun and the sky"),
            ("glint", "what shines"),
            ("finish", "how it is drawn"),
        ],
    },
    RuleAbout {
        word: "lambert",
        label: "Darken by Lambert",
        does: "changes: mixed with the shadow's color by 1 - cos(theta) of the light, times \
               `amount`",
        fields: &[("shadow", "RGB bytes"), ("amount", "0 to 1")],
    },
    RuleAbout {
        word: "rotate",
        label: "Turn with the eye",
        does: "changes: the content turned with the view around the normal, `turns` times as fast; \
               Catmull-Rom's cubic kept \
               within the four nearest texels, exact at quarter turns of square tiles, wrapped \
               around where the tile repeats",
        fields: &[("turns", "-1000 to 1000")],
    },
    RuleAbout {
        word: "recolor",
        label: "Recolor",
        does: "changes: multiplied by a color, `from` at the normal and `to` at the horizon, or \
               `from` at step 0 and `to` \
               half a turn away; at the normal itself the middle of both",
        fields: &[("angle", "one, as in `lock`"), ("from", "RGB bytes"), ("to", "RGB bytes")],
    },
];

impl RuleAbout {
    /// Rule of this kind as read from a file that has its word alone.
    pub fn fresh(&self) -> Option<Rule> {
        serde_json::from_value(serde_json::json!({ "rule": self.word })).ok()
    }

    /// Fields of the rule with their meanings and defaults; `None` where a default has no short
    /// text.
    pub fn defaults(&self) -> Vec<(&'static str, &'static str, Option<String>)> {
        let fresh =
            self.fresh().and_then(|rule| serde_json::to_value(rule).ok()).unwrap_or_default();
        self.fields
            .iter()
            .map(|(name, what)| (*name, *what, fresh.get(*name).and_then(told)))
            .collect()
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
            Some("straight above".to_owned())
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
        let field = |(name, what, default): (&str, &str, Option<String>)| {
            let default = default.map(|default| format!(" ({default})")).unwrap_or_default();
            format!("`{name}`{default}: {what}")
        };
        let fields: Vec<String> = about.defaults().into_iter().map(field).collect();
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
                about.does.starts_with(if fresh.fills() { "fills " } else { "changes: " }),
                "{}",
                about.word
            );
            let written = serde_json::to_value(&fresh).unwrap();
            let mut written: Vec<&str> = written
                .as_object()
                .unwrap()
                .keys()
                .map(String::as_str)
                .filter(|name| *name != "rule")
                .collect();
            let mut listed: Vec<&str> = about.fields.iter().map(|(name, _)| *name).collect();
            written.sort_unstable();
            listed.sort_unstable();
            assert_eq!(written, listed, "{}", about.word);
        }
        let blend = &Rule::ABOUT[2].defaults()[0];
        assert_eq!((blend.0, blend.2.as_deref()), ("sharpness", Some("4")));
        assert_eq!(Rule::ABOUT[0].defaults()[0].2.as_deref(), Some("straight above"));
        assert_eq!(Rule::ABOUT[1].defaults()[0].2.as_deref(), Some("view_phi"));
    }
}
