//! Value of a document as one that a wedge varies.

use crate::document::{ColorSpace, Target, Value};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::library::Type;
use crate::state::runs::Variation;
use crate::widgets::color;

/// A variation of a value around what it is now; `None` for what no wedge varies, such as a value
/// within a group.
pub(crate) fn variation_of(owned: OwnedKeys<'_>, target: &Target) -> Option<Variation> {
    let name = match target {
        Target::Input { node, port } => match node.ids() {
            [node] => format!("{node}.{port}"),
            _ => return None,
        },
        Target::Light { light, field } => format!("{light}.{field}"),
    };
    let port = owned.keys.base.port_at(target)?;
    let now = owned.keys.value_now(target)?;
    match (&port.ty, &now) {
        (Type::Color | Type::Composite, now) => {
            // Lights of scenes are told as they are shown, whatever the looks choose.
            let space = match owned.owner {
                Owner::Scene => ColorSpace::Display,
                Owner::Look => owned.session.look().color_space,
            };
            let [r, g, b, _] = color::encoded(now.color_in(space)?, space);
            Some(Variation::of_color(name, [r, g, b]))
        }
        (Type::Float | Type::Angle | Type::Int, Value::Number(number)) => {
            Some(Variation::around(name, *number, port.unit == "rad"))
        }
        _ => None,
    }
}
