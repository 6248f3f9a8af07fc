//! Form of the rows of a light's fields. The rows themselves, with defaults and bounds, are in
//! `light` (`mod.rs`).

use chiaro_locale::Text;

use super::{Light, LightField, LightKind};
use crate::document::Value;
use crate::document::described::DescribedObject as _;
use crate::document::shape::{FieldKind, NumberBounds};

/// Quantity of a field's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightQuantity {
    /// Direction: three numbers whose length does not matter.
    Direction,
    /// Position: three numbers, in scene units.
    Position,
    /// Color: straight RGB in the look's color space.
    Color,
    /// Factor without a unit.
    Factor,
    /// Angle, in radians.
    Angle,
    /// Distance in scene units; 0 switches its effect off.
    Distance,
}

/// Properties of a field beyond its row in files.
pub(super) struct LightRow {
    /// Label in the window.
    pub(super) label: Text,
    /// Help text in the window.
    pub(super) hint: Text,
    pub(super) quantity: LightQuantity,
    /// Kinds of lights that have the field.
    pub(super) kinds: &'static [LightKind],
    /// Another field whose value is the upper bound of this one.
    pub(super) within: Option<LightField>,
    /// Help text for shaders that ask for `light.` and the field's name; `None` where no shader
    /// may.
    pub(super) shader: Option<&'static str>,
}

/// Access to a field of a light.
pub(super) struct FieldAccess {
    /// Name in files and targets.
    pub(super) name: &'static str,
    /// Word in node files.
    pub(super) word: &'static str,
    pub(super) numbers: fn(&Light) -> &[f64],
    pub(super) numbers_mut: fn(&mut Light) -> &mut [f64],
}

/// Numbers of a field's type.
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
    /// Field with a `name` in files.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.name() == name)
    }

    /// Names of all fields, in the order of the window.
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        Self::ALL.into_iter().map(Self::name)
    }

    /// Name of the field in files and targets.
    pub fn name(self) -> &'static str {
        self.lens().name
    }

    /// Label of the field in the window.
    pub fn label(self) -> &'static str {
        self.label_text().tr()
    }

    /// The same, for files and search.
    pub fn label_text(self) -> Text {
        self.row().label
    }

    /// Help text of the field in the window, with its unit.
    pub fn help(self) -> &'static str {
        self.help_text().tr()
    }

    /// The same, for files and search.
    pub fn help_text(self) -> Text {
        self.row().hint
    }

    /// Quantity of the field's value.
    pub fn quantity(self) -> LightQuantity {
        self.row().quantity
    }

    /// Another field whose value is the upper bound of this one: the full cone lies in the whole
    /// one.
    pub fn within(self) -> Option<Self> {
        self.row().within
    }

    /// Unit of the field: `rad` of an angle, else empty.
    pub fn unit(self) -> &'static str {
        if self.quantity() == LightQuantity::Angle { "rad" } else { "" }
    }

    /// Least and greatest number that the format allows; `None` where the field is no single
    /// number.
    pub fn range(self) -> Option<[f64; 2]> {
        self.bounds().map(|bounds| [bounds.min, bounds.max])
    }

    /// True if the least number of [`range`](Self::range) itself is not allowed.
    pub fn is_above_range(self) -> bool {
        self.bounds().is_some_and(|bounds| bounds.above)
    }

    fn bounds(self) -> Option<NumberBounds> {
        match &Light::shape().field(self.name())?.1.kind {
            FieldKind::Number(bounds) => Some(*bounds),
            _ => None,
        }
    }

    /// True if lights of this kind have the field.
    pub fn is_of(self, kind: LightKind) -> bool {
        self.row().kinds.contains(&kind)
    }

    /// Fields that a light of this kind has.
    pub fn of(kind: LightKind) -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(move |field| field.is_of(kind))
    }

    /// Help text for shaders that ask for the field; `None` where no shader may.
    pub(super) fn shader_help(self) -> Option<&'static str> {
        self.row().shader
    }

    /// Word of the field in node files.
    pub(super) fn word(self) -> &'static str {
        self.lens().word
    }

    /// Numbers of the field: one, or three.
    pub fn numbers(self, light: &Light) -> &[f64] {
        (self.lens().numbers)(light)
    }

    /// Numbers of the field, to be set.
    pub fn numbers_mut(self, light: &mut Light) -> &mut [f64] {
        (self.lens().numbers_mut)(light)
    }

    /// Value of the field.
    pub fn get(self, light: &Light) -> Value {
        match self.numbers(light) {
            [number] => Value::Number(*number),
            numbers => Value::Vector(numbers.to_vec()),
        }
    }

    /// Sets the field to the first of these numbers, as many as the field has; fewer change
    /// nothing.
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
        let told = ["name", "type", "groups", "space", "aimed_at"];
        let of_files =
            Light::shape().fields().map(|field| field.name).filter(|name| !told.contains(name));
        let (mut of_files, mut of_table): (Vec<_>, Vec<_>) =
            (of_files.collect(), LightField::names().collect());
        of_files.sort_unstable();
        of_table.sort_unstable();
        assert_eq!(of_files, of_table);
    }
}
