//! Inputs from lights: most fields of a light as they are, and values computed from several.

use super::{LightField, LightKind, LightQuantity, LightValues};
use crate::interp::Value;

/// Input from the light that a node names, in world space and ready for use: `from=light.` and the
/// word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LightInput {
    /// Field whose row lets shaders ask for it.
    Field(LightField),
    /// Input that is computed from several fields.
    Computed(ComputedInput),
}

/// Input that is computed from several fields: the number of its row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ComputedInput(u8);

/// Properties of an input.
#[derive(Clone, Copy)]
struct InputRow {
    word: &'static str,
    wgsl: &'static str,
    help: &'static str,
    /// Field after which the input is listed.
    after: LightField,
    is_unit: bool,
}

/// Row of the table of inputs that are computed from several fields.
struct ComputedRow {
    input: InputRow,
    value: fn(&LightValues) -> Value,
    /// Value where the light does not reach; `None` where that makes no difference.
    unlit: Option<&'static [f64]>,
}

/// Table of the inputs that are computed from several fields.
const COMPUTED: &[ComputedRow] = &[
    ComputedRow {
        input: InputRow {
            word: "light.own_direction",
            wgsl: "vec3f",
            help: "unit, toward a directional light, in the light's own frame",
            after: LightField::Direction,
            is_unit: true,
        },
        value: |light| Value::vec(&light.own_direction.to_array()),
        unlit: None,
    },
    ComputedRow {
        input: InputRow {
            word: "light.own_from_world",
            wgsl: "mat3x3f",
            help: "rotation from world space to the light's own frame",
            after: LightField::Aim,
            is_unit: true,
        },
        value: |light| Value::matrix(&light.own_from_world.to_cols_array_2d()),
        unlit: None,
    },
    ComputedRow {
        input: InputRow {
            word: "light.cone",
            wgsl: "vec2f",
            help: "cosines of a spot light's inner and outer half-angles; the inner at most the \
                   outer angle",
            after: LightField::Intensity,
            is_unit: true,
        },
        value: |light| Value::vec(&light.cone),
        unlit: None,
    },
    ComputedRow {
        input: InputRow {
            word: "light.fading",
            wgsl: "vec2f",
            help: "half distance and range; 0 for none",
            after: LightField::HalfDistance,
            is_unit: false,
        },
        value: |light| Value::vec(&[light.world.half_distance, light.world.range]),
        unlit: None,
    },
    ComputedRow {
        input: InputRow {
            word: "light.source",
            wgsl: "vec4f",
            help: "the light's place and 1; of a directional light the unit direction toward it \
                   and 0; world space",
            after: LightField::Position,
            is_unit: false,
        },
        value: |light| {
            let (at, w) = match light.kind {
                LightKind::Directional => (light.direction(), 0.0),
                LightKind::Point | LightKind::Spot => (light.position(), 1.0),
            };
            Value::vec(&at.extend(w).to_array())
        },
        unlit: None,
    },
    ComputedRow {
        input: InputRow {
            word: "light.casters",
            wgsl: "f32",
            help: "what casts this light's shadows onto the object: the texel of a tree over \
                   objects, twice, or -2 where none does, and 1 more where the object casts them \
                   onto itself; -2 for no shadows",
            after: LightField::Intensity,
            is_unit: false,
        },
        value: |light| Value::Float(light.casters),
        unlit: Some(&[LightValues::NO_CASTERS]),
    },
    ComputedRow {
        input: InputRow {
            word: LightInput::SHADOW_MAP,
            wgsl: "vec4f",
            help: "where this light's shadow map shows what casts its shadows onto the object: the \
                   map's middle across the light's way, half of its side, and its first layer; of \
                   a lamp both of the cube's faces at depth 1; a layer of -1 for no shadows",
            after: LightField::Intensity,
            is_unit: false,
        },
        value: |light| Value::vec(&light.shadow_map),
        unlit: Some(&LightValues::NO_SHADOW_MAP),
    },
];

impl LightInput {
    /// Word of the place of a light's shadow map.
    const SHADOW_MAP: &str = "light.shadow_map";

    /// All inputs.
    pub fn all() -> impl Iterator<Item = Self> {
        let asked = LightField::ALL.into_iter().filter(|field| field.shader_help().is_some());
        let computed = (0..COMPUTED.len()).map(|index| ComputedInput(index as u8));
        asked.map(Self::Field).chain(computed.map(Self::Computed))
    }

    /// True if the input tells what casts the light's shadows: for rays, or on a map.
    pub fn is_shadow(self) -> bool {
        self.word() == "light.casters" || self.is_shadow_map()
    }

    /// True if the input tells where the light's shadow map is.
    pub fn is_shadow_map(self) -> bool {
        self.word() == Self::SHADOW_MAP
    }

    fn row(self) -> InputRow {
        match self {
            Self::Field(field) => {
                let quantity = field.quantity();
                let is_vector = matches!(
                    quantity,
                    LightQuantity::Direction | LightQuantity::Position | LightQuantity::Color
                );
                InputRow {
                    word: field.word(),
                    wgsl: if is_vector { "vec3f" } else { "f32" },
                    help: field.shader_help().unwrap_or_default(),
                    after: field,
                    is_unit: quantity == LightQuantity::Direction,
                }
            }
            Self::Computed(ComputedInput(index)) => COMPUTED[usize::from(index)].input,
        }
    }

    /// Value of the input from a light.
    pub fn value(self, light: &LightValues) -> Value {
        match self {
            Self::Field(field) => match field.numbers(&light.world) {
                [number] => Value::Float(*number),
                numbers => Value::vec(numbers),
            },
            Self::Computed(ComputedInput(index)) => (COMPUTED[usize::from(index)].value)(light),
        }
    }

    /// Numbers of the input where the light does not reach: no intensity, no shadows; `None` for
    /// an input that is what it is all the same.
    pub fn unlit(self) -> Option<&'static [f64]> {
        match self {
            Self::Field(LightField::Intensity) => Some(&[0.0]),
            Self::Field(_) => None,
            Self::Computed(ComputedInput(index)) => COMPUTED[usize::from(index)].unlit,
        }
    }

    /// Inputs that are known where the light does not reach.
    pub fn all_unlit() -> impl Iterator<Item = Self> {
        Self::all().filter(|input| input.unlit().is_some())
    }

    /// Word that node files use.
    pub fn word(self) -> &'static str {
        self.row().word
    }

    /// WGSL type of the input.
    pub fn wgsl_type(self) -> &'static str {
        self.row().wgsl
    }

    /// Description with space and unit: a phrase for docs, tooltips and exports.
    pub fn help(self) -> &'static str {
        self.row().help
    }

    /// True if each number of the input lies in [-1, 1].
    pub fn is_unit(self) -> bool {
        self.row().is_unit
    }

    /// Sort key of the input in lists.
    fn place(self) -> (LightField, u8) {
        let number = match self {
            Self::Field(_) => 0,
            Self::Computed(ComputedInput(index)) => index + 1,
        };
        (self.row().after, number)
    }
}

impl Ord for LightInput {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.place().cmp(&other.place())
    }
}

impl PartialOrd for LightInput {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
