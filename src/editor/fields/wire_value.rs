//! Value of a wire at a pixel in few words, for the table of the probe and for the canvas.

use std::collections::HashMap;

use chiaro_locale::trn;
use eframe::egui::Color32;

use crate::ids::NodePath;
use crate::library::Type;
use crate::reference::WireValue;
use crate::state::session::Session;
use crate::values::number_text;

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

/// Readings of wires in the order of their computation: the last value of a node is its result.
pub(crate) fn readings(session: &Session, wires: &[WireValue]) -> WireReadings {
    let reading = |wire: &WireValue| WireReading {
        text: text_of(session, wire, &wire.single),
        color: color_of(&wire.single),
        is_finite: wire.is_finite(),
    };
    wires.iter().map(|wire| (wire.node.clone(), reading(wire))).collect()
}

/// Numbers of a wire as people write what they mean: degrees of an angle, the count of a profile's.
pub(crate) fn text_of(session: &Session, wire: &WireValue, numbers: &[f64]) -> String {
    match ValueMeaning::of(session, wire) {
        ValueMeaning::Angle => degrees(numbers).unwrap_or_else(|| short(numbers)),
        ValueMeaning::Profile if wire.is_finite() => {
            trn!(count = numbers.len(), "{count} number", "{count} numbers")
        }
        ValueMeaning::Numbers | ValueMeaning::Profile => short(numbers),
    }
}

/// Meaning of a wire's numbers, by which they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ValueMeaning {
    Numbers,
    /// Sine and cosine of half an angle.
    Angle,
    /// Numbers of a profile, which say little to people.
    Profile,
}

impl ValueMeaning {
    /// Meaning of a node's value, where its one output tells it.
    fn of(session: &Session, wire: &WireValue) -> Self {
        let node = session.look_with_library().node_at(&wire.node);
        let kind = node.and_then(|node| session.project.catalog.of(node));
        let output = kind.and_then(|kind| match kind.outputs.as_slice() {
            [output] => Some(&output.ty),
            _ => None,
        });
        match output {
            Some(Type::Angle) => Self::Angle,
            Some(Type::Prepared(_)) if wire.double.len() > 5 => Self::Profile,
            _ => Self::Numbers,
        }
    }
}

/// An angle in degrees, from the sine and the cosine of its half; `None` for other numbers.
fn degrees(numbers: &[f64]) -> Option<String> {
    let [sine, cosine] = *numbers else { return None };
    let angle = (2.0 * sine.atan2(cosine)).to_degrees();
    angle.is_finite().then(|| format!("{}°", number_text(angle, 4)))
}

/// Color of four or five scalars, which are a color with its alpha; `None` for other numbers.
pub(crate) fn color_of(numbers: &[f64]) -> Option<Color32> {
    let [r, g, b, a, ..] = *numbers else { return None };
    let byte = |x: f64| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let is_one = numbers.len() <= 5 && numbers.iter().all(|x| x.is_finite());
    is_one.then(|| Color32::from_rgba_unmultiplied(byte(r), byte(g), byte(b), byte(a)))
}

fn short(numbers: &[f64]) -> String {
    let text = |x: f64| match numbers.len() {
        _ if x.is_nan() => "NaN".to_owned(),
        _ if x.is_infinite() => if x > 0.0 { "inf" } else { "-inf" }.to_owned(),
        1 => number_text(x, 7),
        2 => number_text(x, 5),
        _ => number_text(x, 2),
    };
    numbers.iter().map(|&x| text(x)).collect::<Vec<_>>().join(" ")
}
