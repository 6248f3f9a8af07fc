//! What shaders may ask of a light: most fields as they are, and what is made of several.

use super::{LightField, LightQuantity};

/// What a node may ask of the light that it names, in world space and ready for use: `from=light.`
/// and the word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LightInput {
    /// A field whose row lets shaders ask for it.
    Field(LightField),
    /// The direction of a directional light as the artist gave it.
    OwnDirection,
    /// The light's own frame.
    OwnFromWorld,
    /// Both cones of a spot light.
    Cone,
    /// Half distance and range.
    Fading,
}

/// What is known of an input.
struct InputRow {
    word: &'static str,
    wgsl: &'static str,
    help: &'static str,
    /// The field after which it is listed.
    after: LightField,
    is_unit: bool,
}

impl LightInput {
    /// Those that are made of several fields.
    const MADE: [Self; 4] = [Self::OwnDirection, Self::OwnFromWorld, Self::Cone, Self::Fading];

    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        let asked = LightField::ALL.into_iter().filter(|field| field.shader_help().is_some());
        asked.map(Self::Field).chain(Self::MADE)
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
            Self::OwnDirection => InputRow {
                word: "light.own_direction",
                wgsl: "vec3f",
                help: "unit, toward a directional light, in the light's own frame",
                after: LightField::Direction,
                is_unit: true,
            },
            Self::OwnFromWorld => InputRow {
                word: "light.own_from_world",
                wgsl: "mat3x3f",
                help: "rotation from world space to the light's own frame",
                after: LightField::Aim,
                is_unit: true,
            },
            Self::Cone => InputRow {
                word: "light.cone",
                wgsl: "vec2f",
                help: "cosines of a spot light's inner and outer half-angles; the inner at most \
                       the outer angle",
                after: LightField::Intensity,
                is_unit: true,
            },
            Self::Fading => InputRow {
                word: "light.fading",
                wgsl: "vec2f",
                help: "half distance and range; 0 for none",
                after: LightField::HalfDistance,
                is_unit: false,
            },
        }
    }

    /// The word that node files use.
    pub fn word(self) -> &'static str {
        self.row().word
    }

    /// Its WGSL type.
    pub fn wgsl_type(self) -> &'static str {
        self.row().wgsl
    }

    /// What it is, with its space and unit: a phrase for docs, tooltips and exports.
    pub fn help(self) -> &'static str {
        self.row().help
    }

    /// Whether each of its numbers lies in [-1, 1].
    pub fn is_unit(self) -> bool {
        self.row().is_unit
    }

    /// Where it is listed among its like.
    fn place(self) -> (LightField, bool) {
        (self.row().after, !matches!(self, Self::Field(_)))
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
