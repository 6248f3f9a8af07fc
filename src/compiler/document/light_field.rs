//! The fields of a light that artists, keys, scenes and exported shaders set: one table, from which
//! the file format, the checks, the window and the exports take what they say of a field.

use super::shape::{self, Kind};
use super::{Light, LightKind, Value};
use LightKind::{Directional, Point, Spot};

/// A field of a light that can be set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LightField {
    /// Toward a directional light.
    Direction,
    /// Where a point or spot light is.
    Position,
    /// The way a spot light shines.
    Aim,
    /// The half-angle of a spot light's full cone.
    Inner,
    /// The half-angle at which nothing of a spot light is left.
    Outer,
    /// The light's color.
    Color,
    /// A factor on the color.
    Intensity,
    /// The distance at which half of a point or spot light's intensity is left.
    HalfDistance,
    /// The distance beyond which nothing of a point or spot light is left.
    Range,
}

/// What the value of a field is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightQuantity {
    /// Three numbers of which only the way that they point counts.
    Direction,
    /// Three numbers in scene units.
    Position,
    /// Straight RGB in the look's color space.
    Color,
    /// A factor without a unit.
    Factor,
    /// An angle in radians.
    Angle,
    /// A length in scene units; 0 switches what it bounds off.
    Distance,
}

/// A row of the table.
struct Row {
    field: LightField,
    name: &'static str,
    label: &'static str,
    /// What the window says of it.
    help: &'static str,
    quantity: LightQuantity,
    kinds: &'static [LightKind],
}

const ANY: &[LightKind] = &[Directional, Point, Spot];
const PLACED: &[LightKind] = &[Point, Spot];

/// In the order of [`LightField`], which is that of the window.
#[rustfmt::skip]
static ROWS: [Row; 9] = [
    Row {
        field: LightField::Direction, name: "direction", label: "Direction",
        help: "Toward the light. The middle is toward you, the inner ring sideways, the rim \
               behind.",
        quantity: LightQuantity::Direction, kinds: &[Directional],
    },
    Row {
        field: LightField::Position, name: "position", label: "Position",
        help: "In scene units",
        quantity: LightQuantity::Position, kinds: PLACED,
    },
    Row {
        field: LightField::Aim, name: "aim", label: "Aim",
        help: "From the light outward",
        quantity: LightQuantity::Direction, kinds: &[Spot],
    },
    Row {
        field: LightField::Inner, name: "inner", label: "Full cone",
        help: "Half-angle of full light",
        quantity: LightQuantity::Angle, kinds: &[Spot],
    },
    Row {
        field: LightField::Outer, name: "outer", label: "Whole cone",
        help: "Half-angle at which nothing is left",
        quantity: LightQuantity::Angle, kinds: &[Spot],
    },
    Row {
        field: LightField::Color, name: "color", label: "Color",
        help: "Of the light",
        quantity: LightQuantity::Color, kinds: ANY,
    },
    Row {
        field: LightField::Intensity, name: "intensity", label: "Intensity",
        help: "A factor on the color",
        quantity: LightQuantity::Factor, kinds: ANY,
    },
    Row {
        field: LightField::HalfDistance, name: "half_distance", label: "Half distance",
        help: "How far from the light half its intensity is left, in scene units; 0 for no fading",
        quantity: LightQuantity::Distance, kinds: PLACED,
    },
    Row {
        field: LightField::Range, name: "range", label: "Range",
        help: "How far from the light nothing is left, in scene units; 0 for no end",
        quantity: LightQuantity::Distance, kinds: PLACED,
    },
];

impl LightField {
    /// All of them, in the order of the window.
    pub const ALL: [Self; 9] = [
        Self::Direction,
        Self::Position,
        Self::Aim,
        Self::Inner,
        Self::Outer,
        Self::Color,
        Self::Intensity,
        Self::HalfDistance,
        Self::Range,
    ];

    fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// The field that files call `name`.
    pub fn named(name: &str) -> Option<Self> {
        ROWS.iter().find(|row| row.name == name).map(|row| row.field)
    }

    /// All names, in the order of the window.
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        ROWS.iter().map(|row| row.name)
    }

    /// What files and targets call it.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// What the window calls it.
    pub fn label(self) -> &'static str {
        self.row().label
    }

    /// What the window says of it, with its unit.
    pub fn help(self) -> &'static str {
        self.row().help
    }

    /// What its value is.
    pub fn quantity(self) -> LightQuantity {
        self.row().quantity
    }

    /// `rad` of an angle, else nothing.
    pub fn unit(self) -> &'static str {
        if self.quantity() == LightQuantity::Angle { "rad" } else { "" }
    }

    /// The least and the greatest number that the format allows; `None` of what is no single
    /// number.
    pub fn range(self) -> Option<[f64; 2]> {
        match &shape::LIGHT.field(self.name())?.1.kind {
            Kind::Number(bounds) => Some([bounds.min, bounds.max]),
            _ => None,
        }
    }

    /// Whether a light of this kind has it.
    pub fn is_of(self, kind: LightKind) -> bool {
        self.row().kinds.contains(&kind)
    }

    /// The fields that a light of this kind has.
    pub fn of(kind: LightKind) -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(move |field| field.is_of(kind))
    }

    /// Its value.
    pub fn get(self, light: &Light) -> Value {
        match self {
            Self::Direction => Value::Vector(light.direction.to_vec()),
            Self::Position => Value::Vector(light.position.to_vec()),
            Self::Aim => Value::Vector(light.aim.to_vec()),
            Self::Color => Value::Vector(light.color.to_vec()),
            Self::Intensity => Value::Number(light.intensity),
            Self::Inner => Value::Number(light.inner),
            Self::Outer => Value::Number(light.outer),
            Self::HalfDistance => Value::Number(light.half_distance),
            Self::Range => Value::Number(light.range),
        }
    }

    /// Sets it to the first of these numbers, as many as it has; fewer change nothing.
    pub fn set(self, light: &mut Light, numbers: &[f64]) {
        let slot: &mut [f64] = match self {
            Self::Direction => &mut light.direction,
            Self::Position => &mut light.position,
            Self::Aim => &mut light.aim,
            Self::Color => &mut light.color,
            Self::Intensity => std::slice::from_mut(&mut light.intensity),
            Self::Inner => std::slice::from_mut(&mut light.inner),
            Self::Outer => std::slice::from_mut(&mut light.outer),
            Self::HalfDistance => std::slice::from_mut(&mut light.half_distance),
            Self::Range => std::slice::from_mut(&mut light.range),
        };
        if let Some(numbers) = numbers.get(..slot.len()) {
            slot.copy_from_slice(numbers);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_has_every_field_that_files_have_in_its_place() {
        for (field, row) in LightField::ALL.into_iter().zip(&ROWS) {
            assert_eq!((field, LightField::named(row.name)), (row.field, Some(field)));
            let mut light = Light::default();
            field.set(&mut light, &[0.25, 0.5, 0.75]);
            let wanted = match field.quantity() {
                LightQuantity::Direction | LightQuantity::Position | LightQuantity::Color => {
                    Value::Vector(vec![0.25, 0.5, 0.75])
                }
                _ => Value::Number(0.25),
            };
            assert_eq!(field.get(&light), wanted);
            let is_number = matches!(wanted, Value::Number(_));
            assert_eq!(field.range().is_some(), is_number, "{}", row.name);
        }
        let names: Vec<String> = LightField::names().map(|name| format!("`{name}`")).collect();
        let (last, first) = names.split_last().unwrap();
        let told = format!("a field of a light: {} or {last}.", first.join(", "));
        assert!(
            include_str!("../../../docs/format.md").contains(&told),
            "docs/format.md is to say: {told}"
        );
        let told = ["name", "type", "space"];
        let of_files =
            shape::LIGHT.fields.iter().map(|field| field.name).filter(|name| !told.contains(name));
        let (mut of_files, mut of_table): (Vec<_>, Vec<_>) =
            (of_files.collect(), LightField::names().collect());
        of_files.sort_unstable();
        of_table.sort_unstable();
        assert_eq!(of_files, of_table);
    }
}
