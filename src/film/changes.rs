//! Values that shots change, as people read them: colors as the fields of the window have them, and
//! what groups of the library say.

use serde_json::Value as Json;

use crate::catalog::values;
use crate::document::{ColorSpace, Look, Target, json_of_value, linear_to_srgb, read_hex};
use crate::frame::ValueChange;
use crate::library::Library;

/// Ends of the names of fields that hold colors.
const COLORS: [&str; 3] = ["color", "tint", "backdrop"];
/// Colors of a scene that are given as they are shown, whatever its looks compute in.
const AS_SHOWN: [&str; 2] = ["backdrop", "outlines.color"];

/// The space of the numbers of a color that a shot changes, where its look, or the looks that its
/// light shines on, compute in `space`; `None` where the value is no color.
pub fn color_space(change: &ValueChange, space: ColorSpace) -> Option<ColorSpace> {
    let name = change.target.rsplit('.').next().unwrap_or_default();
    let is_named = COLORS.iter().any(|color| name.ends_with(color));
    if !(is_named || is_hex(&change.from) || is_hex(&change.to)) {
        return None;
    }
    let is_shown = change.look.is_none() && AS_SHOWN.contains(&change.target.as_str());
    Some(if is_shown { ColorSpace::Display } else { space })
}

/// Value before a change of a look, as files have it: where the look says nothing about a node
/// within a group of the library, that of the group. Null where the node has its own default.
pub fn value_before(change: &ValueChange, look: &Look, library: &Library) -> Json {
    let of_group = || {
        let Some(Target::Input { node, port }) = Target::parse(&change.target) else { return None };
        let (_, found) = library.node_of(look, node.ids()).filter(|_| node.parent().is_some())?;
        found.values.get(&port).map(json_of_value)
    };
    match &change.from {
        Json::Null => of_group().unwrap_or(Json::Null),
        from => from.clone(),
    }
}

/// True for a color in hexadecimal.
pub fn is_hex(value: &Json) -> bool {
    value.as_str().and_then(read_hex).is_some()
}

/// A color as the window's fields have it, `#ff8000`; `None` for what no screen shows.
pub fn color_text(numbers: &[Json], space: ColorSpace) -> Option<String> {
    let numbers: Option<Vec<f64>> = numbers.iter().map(Json::as_f64).collect();
    let (rgb, a) = match numbers?[..] {
        [r, g, b] => ([r, g, b], 1.0),
        [r, g, b, a] => ([r, g, b], a),
        _ => return None,
    };
    let [r, g, b] = match space {
        ColorSpace::Display => rgb,
        ColorSpace::Linear => rgb.map(linear_to_srgb),
    };
    let is_shown = [r, g, b, a].iter().all(|x| (0.0..=1.0).contains(x));
    is_shown.then(|| values::hex([r, g, b, a]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_group_of_the_library_says_stood_before_a_change() {
        let text = r#"{"nodes": [{"id": "spot", "kind": "gobo"}, {"id": "rim", "kind": "blend",
            "values": {"mode": "multiply"}}]}"#;
        let (look, library) = (Look::read(text, "").value.unwrap(), Library::built_in());
        let before = |target: &str, from: Json| {
            let change = ValueChange {
                look: Some("look.json".to_owned()),
                target: target.to_owned(),
                from,
                to: Json::from("mirror"),
                is_keyed: false,
                step: 1,
                by: "shot.json".into(),
                json_path: "overrides[0]".to_owned(),
                stands: true,
            };
            value_before(&change, &look, library)
        };
        assert_eq!(before("spot/picture.wrap", Json::Null), "clamp");
        assert_eq!(before("spot/picture.wrap", Json::from("repeat")), "repeat", "another shot's");
        assert_eq!(before("spot/picture.filter", Json::Null), Json::Null, "the node's own default");
        assert_eq!(before("rim.mode", Json::Null), Json::Null, "the look has the change already");
    }
}
