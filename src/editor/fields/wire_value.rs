//! Value of a wire at a pixel in few words, for the table of the probe and for the canvas.

use std::collections::{HashMap, HashSet};

use eframe::egui::Color32;

use crate::catalog::wires::WirePart;
use crate::ids::{NodeId, NodePath};
use crate::reference::WireValue;
use crate::state::reading::LookWithLibrary;

/// Values of nodes at the pixel that is probed, by path.
pub(crate) type WireReadings = HashMap<NodePath, WireReading>;

/// Value of a node at the pixel that is probed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WireReading {
    pub(crate) text: String,
    /// Color of a value that is one.
    pub(crate) color: Option<Color32>,
    /// True if all numbers are finite.
    pub(crate) is_finite: bool,
}

/// Readings of wires in the order of their computation: the last result of a node, or else its last
/// value. The Output has values after the color that it gives, such as its id.
pub(crate) fn readings(look: LookWithLibrary<'_>, wires: &[WireValue]) -> WireReadings {
    let reading = |wire: &WireValue| WireReading {
        text: text_of(look, wire, &wire.single),
        color: color_of(look, wire, &wire.single),
        is_finite: wire.is_finite(),
    };
    let mut readings = WireReadings::new();
    let mut with_result: HashSet<&NodePath> = HashSet::new();
    for wire in wires {
        let is_result = matches!(part_of(look, wire), WirePart::Result(_) | WirePart::Output(_));
        if is_result {
            with_result.insert(&wire.node);
        }
        if is_result || !with_result.contains(&wire.node) {
            readings.insert(wire.node.clone(), reading(wire));
        }
    }
    readings
}

/// Numbers of a wire as people write what they mean.
pub(crate) fn text_of(look: LookWithLibrary<'_>, wire: &WireValue, numbers: &[f64]) -> String {
    part_of(look, wire).text(numbers)
}

/// Color in the numbers of a wire; `None` where there is none.
pub(crate) fn color_of(
    look: LookWithLibrary<'_>,
    wire: &WireValue,
    numbers: &[f64],
) -> Option<Color32> {
    let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let [r, g, b, a] = part_of(look, wire).color(numbers)?.map(byte);
    Some(Color32::from_rgba_unmultiplied(r, g, b, a))
}

/// Names of the rows of wires, no two of which are alike: titles of nodes along their paths, with
/// a number where a node before has the title; the part of the node; the one light that the value
/// is about.
pub(crate) fn row_names<'w>(look: LookWithLibrary<'_>, wires: &'w [WireValue]) -> Vec<String> {
    let mut outer: HashMap<String, Vec<&NodeId>> = HashMap::new();
    let mut given: HashMap<String, usize> = HashMap::new();
    let mut name = |wire: &'w WireValue| {
        let mut name = look.title_of_path(&wire.node);
        if let Some(id) = wire.node.outermost() {
            let title = look.title(id);
            let namesakes = outer.entry(title.clone()).or_default();
            let number = namesakes.iter().position(|other| *other == id);
            if number.is_none() {
                namesakes.push(id);
            }
            let number = number.unwrap_or(namesakes.len() - 1);
            if number > 0 {
                name.insert_str(title.len(), &format!(" {}", number + 1));
            }
        }
        if let Some(part) = part_of(look, wire).label() {
            name = format!("{name}: {part}");
        }
        if let Some(light) = &wire.light {
            name = format!("{name} · {}", look.light_name(light));
        }
        let before = given.entry(name.clone()).or_default();
        *before += 1;
        if *before > 1 { format!("{name} ({before})") } else { name }
    };
    wires.iter().map(&mut name).collect()
}

/// Part of a node that a wire's value is.
fn part_of<'a>(look: LookWithLibrary<'a>, wire: &WireValue) -> WirePart<'a> {
    let kind = look.node_at(&wire.node).and_then(|node| look.catalog.of(node));
    kind.map_or(WirePart::Numbers, |kind| WirePart::of(kind, &wire.name, wire.double.len()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalog::Catalog;
    use crate::document::Look;
    use crate::library::Library;

    const LOOK: &str = r#"{"lights": {"key": {"name": "Sun"}}, "nodes": [
      {"id": "base", "kind": "base"}, {"id": "rim", "kind": "light_layer", "name": "Rim"},
      {"id": "rim_2", "kind": "light_layer", "name": "Rim"}, {"id": "own", "kind": "missing"},
      {"id": "output", "kind": "output"}]}"#;

    fn wire(path: &str, name: &str, numbers: &[f64]) -> WireValue {
        WireValue {
            draw: 0,
            node: NodePath::parse(path),
            light: None,
            name: name.to_owned(),
            single: numbers.to_vec(),
            double: numbers.to_vec(),
        }
    }

    fn with_look<T>(test: impl FnOnce(LookWithLibrary<'_>) -> T) -> T {
        let look = Look::read(LOOK, "test").value.unwrap();
        let library = Library::built_in();
        let mut catalog = Catalog::new(library);
        catalog.sync(&look, library);
        test(LookWithLibrary { look: &look, catalog: &catalog, library })
    }

    #[test]
    fn rows_of_wires_have_names_of_their_own() {
        let of_light = |wire: WireValue| WireValue { light: Some("key".into()), ..wire };
        let wires = [
            wire("base", "base_color", &[1.0; 4]),
            wire("base", "base_2", &[1.0; 4]),
            wire("rim/color", "rim_color_convex", &[1.0; 4]),
            wire("rim/color", "rim_color", &[1.0; 4]),
            wire("rim_2/color", "rim_color_2", &[1.0; 4]),
            of_light(wire("rim/angle", "rim_angle", &[0.5, 0.5])),
            wire("own", "own", &[1.0]),
            wire("own", "own_2", &[1.0]),
        ];
        let names = with_look(|look| row_names(look, &wires));
        let color = "Convex/concave color";
        let expected = [
            "Base: Color".to_owned(),
            "Base".to_owned(),
            format!("Rim / {color}: Convex"),
            format!("Rim / {color}"),
            format!("Rim 2 / {color}"),
            "Rim / Parametrization · Sun".to_owned(),
            "own".to_owned(),
            "own (2)".to_owned(),
        ];
        assert_eq!(names, expected);
    }

    #[test]
    fn readings_are_in_peoples_words() {
        let (sine, cosine) = 20f64.to_radians().sin_cos();
        let wires = [
            wire("rim/angle", "rim_angle", &[sine, cosine]),
            wire("rim/tone", "rim_tone_shape", &[1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]),
            wire("rim/lit", "rim_lit", &[1.0, 0.5, 0.0, 1.0, 0.25]),
            wire("own", "own", &[f64::NAN]),
            wire("output", "output", &[1.0, 0.5, 0.0, 1.0]),
            wire("output", "output_cutoff", &[0.0]),
            wire("output", "output_id", &[0.0]),
            wire("output", "output_2", &[0.0]),
        ];
        let readings = with_look(|look| readings(look, &wires));
        let text = |path: &str| readings[&NodePath::parse(path)].text.as_str();
        assert_eq!(text("rim/angle"), "40°");
        assert_eq!(text("rim/tone"), "hard edge at 0°");
        assert_eq!(text("rim/lit"), "Color #ff8000 · Tone 0.25");
        assert_eq!(text("own"), "NaN");
        assert_eq!(text("output"), "#ff8000", "the color, and not the cut-off or the id after it");
        let lit = &readings[&NodePath::parse("rim/lit")];
        assert_eq!(lit.color, Some(Color32::from_rgb(255, 128, 0)));
        assert!(lit.is_finite && !readings[&NodePath::parse("own")].is_finite);
    }
}
