//! What a row says of a field of a light.

use super::{Light, LightField, LightKind};
use crate::document::Value;
use crate::document::described::Described as _;
use crate::document::shape::{Bounds, Kind};

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

/// What is known of a field beyond its row in files.
pub(super) struct LightRow {
    /// What the window calls it.
    pub(super) label: &'static str,
    /// What the window says of it.
    pub(super) hint: &'static str,
    pub(super) quantity: LightQuantity,
    /// The kinds of lights that have it.
    pub(super) kinds: &'static [LightKind],
    /// Another field that it is at most.
    pub(super) within: Option<LightField>,
    /// What a shader is told that asks for `light.` and the field's name; `None` where none may.
    pub(super) shader: Option<&'static str>,
}

/// Where a light has a field.
pub(super) struct Lens {
    /// What files and targets call it.
    pub(super) name: &'static str,
    /// What node files call it.
    pub(super) word: &'static str,
    pub(super) numbers: fn(&Light) -> &[f64],
    pub(super) numbers_mut: fn(&mut Light) -> &mut [f64],
}

/// The numbers of a field.
pub(super) trait NumbersOf {
    fn numbers(&self) -> &[f64];
    fn numbers_mut(&mut self) -> &mut [f64];
}

impl NumbersOf for f64 {
    fn numbers(&self) -> &[f64] {
        std::slice::from_ref(self)
    }

    fn numbers_mut(&mut self) -> &mut [f64] {
        std::slice::from_mut(self)
    }
}

impl<const N: usize> NumbersOf for [f64; N] {
    fn numbers(&self) -> &[f64] {
        self
    }

    fn numbers_mut(&mut self) -> &mut [f64] {
        self
    }
}

impl LightField {
    /// The field that files call `name`.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.name() == name)
    }

    /// All names, in the order of the window.
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        Self::ALL.into_iter().map(Self::name)
    }

    /// What files and targets call it.
    pub fn name(self) -> &'static str {
        self.lens().name
    }

    /// What the window calls it.
    pub fn label(self) -> &'static str {
        self.row().label
    }

    /// What the window says of it, with its unit.
    pub fn help(self) -> &'static str {
        self.row().hint
    }

    /// What its value is.
    pub fn quantity(self) -> LightQuantity {
        self.row().quantity
    }

    /// Another field that it is at most: the full cone lies in the whole one.
    pub fn within(self) -> Option<Self> {
        self.row().within
    }

    /// `rad` of an angle, else nothing.
    pub fn unit(self) -> &'static str {
        if self.quantity() == LightQuantity::Angle { "rad" } else { "" }
    }

    /// The least and the greatest number that the format allows; `None` of what is no single
    /// number.
    pub fn range(self) -> Option<[f64; 2]> {
        self.bounds().map(|bounds| [bounds.min, bounds.max])
    }

    /// Whether the least number of [`range`](Self::range) itself is not allowed.
    pub fn is_above_range(self) -> bool {
        self.bounds().is_some_and(|bounds| bounds.above)
    }

    fn bounds(self) -> Option<Bounds> {
        match &Light::shape().field(self.name())?.1.kind {
            Kind::Number(bounds) => Some(*bounds),
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

    /// What is said to a shader that asks for it; `None` where none may.
    pub(super) fn shader_help(self) -> Option<&'static str> {
        self.row().shader
    }

    /// What node files call it.
    pub(super) fn word(self) -> &'static str {
        self.lens().word
    }

    /// Its numbers: one, or three.
    pub fn numbers(self, light: &Light) -> &[f64] {
        (self.lens().numbers)(light)
    }

    /// Its numbers, to be set.
    pub fn numbers_mut(self, light: &mut Light) -> &mut [f64] {
        (self.lens().numbers_mut)(light)
    }

    /// Its value.
    pub fn get(self, light: &Light) -> Value {
        match self.numbers(light) {
            [number] => Value::Number(*number),
            numbers => Value::Vector(numbers.to_vec()),
        }
    }

    /// Sets it to the first of these numbers, as many as it has; fewer change nothing.
    pub fn set(self, light: &mut Light, numbers: &[f64]) {
        let slot = self.numbers_mut(light);
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
        for field in LightField::ALL {
            assert_eq!(LightField::named(field.name()), Some(field));
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
            assert_eq!(field.range().is_some(), is_number, "{}", field.name());
        }
        let told = ["name", "type", "space"];
        let of_files =
            Light::shape().fields().map(|field| field.name).filter(|name| !told.contains(name));
        let (mut of_files, mut of_table): (Vec<_>, Vec<_>) =
            (of_files.collect(), LightField::names().collect());
        of_files.sort_unstable();
        of_table.sort_unstable();
        assert_eq!(of_files, of_table);
    }
}
