//! Lights, and the table of their fields.
//!
//! A field of a light that artists, keys, scenes and exported shaders set is one row below: its
//! type and bounds in files, its default, the kinds of lights that have it, its label and help in
//! the window, and, where shaders may ask for it, their help text. The reader, the writer, the
//! schema, docs/format.md, keys, the lights panel, the host's uniforms and exports go by the row.

mod field;
mod input;
mod layer;
mod link;
mod master;
mod mix;
mod values;

use chiaro_locale::{Text, text};
use serde::{Deserialize, Serialize};

use super::described::described;
use super::shape::{FAR, FieldKind, LINE, NumberBounds, POSITIVE};
use super::word::WordChoice as _;
use crate::ids::{LightGroup, LightId, ObjectId};
use LightKind::{Directional, Point, Spot};
use LightQuantity::{Angle, Color, Direction, Distance, Factor, Position};
use field::{FieldAccess, LightRow, NumbersOf as _};

pub use field::LightQuantity;
pub use input::LightInput;
pub use layer::{LayerLink, NodeLinks};
pub use link::{LightLink, LightRelation, LinkRule, ShadowLink};
pub use master::{GroupMaster, MAX_EXPOSURE};
pub use mix::LightOut;
pub use values::{
    AimPlaces, LightFrames, LightValues, MAX_INTENSITY, MAX_LIGHT_COLOR, MIN_LIGHT_DISTANCE,
    ObjectFrame,
};

const ANY: &[LightKind] = &[Directional, Point, Spot];
const PLACED: &[LightKind] = &[Point, Spot];

/// Defaults of the properties that a row leaves out.
const ROW: LightRow = LightRow {
    label: Text::new(""),
    hint: Text::new(""),
    quantity: Factor,
    kinds: ANY,
    within: None,
    shader: None,
};

/// Makes the type of lights, the enum of their fields, and the table of these, from the rows.
macro_rules! light_fields {
    ($(
        $(#[doc = $help:literal])+
        $variant:ident $field:ident: $ty:ty = $default:expr, $kind:expr $(, by $codec:ident)?;
        { $($row:tt)* }
    )*) => {
        described! {
            /// A light, of a look or of a scene.
            #[serde(default)]
            pub struct Light("light", Line) {
                /// Artist's name of the light; empty for the id.
                #[serde(skip_serializing_if = "String::is_empty")]
                name: String = String::new(), FieldKind::Text(LINE);
                /// Type of the light.
                #[serde(rename = "type")]
                kind as "type": LightKind = LightKind::Directional,
                    FieldKind::Word(LightKind::WORDS);
                /// Groups that the light belongs to.
                #[serde(skip_serializing_if = "Vec::is_empty")]
                groups: Vec<LightGroup> = Vec::new(), FieldKind::List(&FieldKind::Slug, 64);
                /// The frame of `direction`, `position` and `aim`.
                space: LightSpace = LightSpace::Illumination, FieldKind::Word(LightSpace::WORDS);
                /// Object that the light is aimed at: from `position` toward the middle of the
                /// object's box, in place of `aim` and `direction`.
                #[serde(skip_serializing_if = "Option::is_none")]
                aimed_at: Option<ObjectId> = None, FieldKind::Slug, words "none";
                $($(#[doc = $help])+ $field: $ty = $default, $kind $(, by $codec)?;)*
            }
        }

        /// A field of a light that can be set.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum LightField {
            $($(#[doc = $help])+ $variant,)*
        }

        impl LightField {
            const COUNT: usize = [$(stringify!($variant)),*].len();

            /// All of them, in the order of the window.
            pub const ALL: [Self; Self::COUNT] = [$(Self::$variant),*];

            fn row(self) -> &'static LightRow {
                match self {
                    $(Self::$variant => {
                        const { &LightRow { $($row)* ..ROW } }
                    })*
                }
            }

            fn lens(self) -> FieldAccess {
                match self {
                    $(Self::$variant => FieldAccess {
                        name: stringify!($field),
                        word: concat!("light.", stringify!($field)),
                        numbers: |light| light.$field.numbers(),
                        numbers_mut: |light| light.$field.numbers_mut(),
                    },)*
                }
            }
        }
    };
}

light_fields! {
    /// Directional lights: toward the light; any length but 0.
    Direction direction: [f64; 3] = [0.0, 0.0, 1.0], FieldKind::Direction;
    {
        label: text!("Direction"),
        hint: text!("Toward the light. The middle is toward you, the inner ring sideways, the rim \
         behind."),
        quantity: Direction,
        kinds: &[Directional],
        shader: Some("unit, toward a directional light, world space"),
    }

    /// Point and spot lights, and directional ones that are aimed at an object: where it is, in
    /// scene units.
    Position position: [f64; 3] = [0.0, 0.0, 3.0], FieldKind::Numbers(3, 3, FAR);
    {
        label: text!("Position"),
        hint: text!("In scene units"),
        quantity: Position,
        kinds: PLACED,
        shader: Some("world space"),
    }

    /// Spot lights: the way it shines, from the light outward; any length but 0.
    Aim aim: [f64; 3] = [0.0, 0.0, -1.0], FieldKind::Direction;
    {
        label: text!("Aim"),
        hint: text!("From the light outward"),
        quantity: Direction,
        kinds: &[Spot],
        shader: Some("unit, the way a spot light shines, world space"),
    }

    /// Spot lights: the half-angle of the full cone, in radians; at most `outer`.
    Inner inner: f64 = 0.35, FieldKind::Number(NumberBounds::new(0.0, std::f64::consts::PI));
    {
        label: text!("Full cone"),
        hint: text!("Half-angle of full light"),
        quantity: Angle,
        kinds: &[Spot],
        within: Some(LightField::Outer),
    }

    /// Spot lights: the half-angle at which nothing is left, in radians.
    Outer outer: f64 = 0.5, FieldKind::Number(NumberBounds::above(0.0, std::f64::consts::PI));
    {
        label: text!("Whole cone"),
        hint: text!("Half-angle at which nothing is left"),
        quantity: Angle,
        kinds: &[Spot],
    }

    /// Straight RGB in the look's color space.
    Color color: [f64; 3] = [1.0; 3], FieldKind::Color { alpha: false };
    {
        label: text!("Color"),
        hint: text!("Of the light"),
        quantity: Color,
        shader: Some("straight RGB in the look's color space"),
    }

    /// A factor.
    Intensity intensity: f64 = 1.0, FieldKind::Number(POSITIVE);
    {
        label: text!("Intensity"),
        hint: text!("A factor on the color"),
        quantity: Factor,
        shader: Some("0 or more"),
    }

    /// Point and spot lights: the distance at which half the intensity is left, in scene units; 0
    /// for no fading, and 1e-30 for less than that.
    HalfDistance half_distance: f64 = 0.0, FieldKind::Number(POSITIVE);
    {
        label: text!("Half distance"),
        hint: text!("How far from the light half its intensity is left, in scene units; 0 for no \
                     fading"),
        quantity: Distance,
        kinds: PLACED,
    }

    /// Point and spot lights: the distance beyond which nothing is left, in scene units; 0 for no
    /// end, and 1e-30 for less than that.
    Range range: f64 = 0.0, FieldKind::Number(POSITIVE);
    {
        label: text!("Range"),
        hint: text!("How far from the light nothing is left, in scene units; 0 for no end"),
        quantity: Distance,
        kinds: PLACED,
    }
}

impl Light {
    /// True if a field decides what the light does: one of its kind has it, and nothing that the
    /// light is aimed at stands in for it.
    pub fn has(&self, field: LightField) -> bool {
        match (field, self.kind, &self.aimed_at) {
            (LightField::Position, LightKind::Directional, Some(_)) => true,
            (LightField::Direction, LightKind::Directional, Some(_))
            | (LightField::Aim, LightKind::Spot, Some(_)) => false,
            _ => field.is_of(self.kind),
        }
    }

    /// Fields that decide what the light does, in the order of the window.
    pub fn fields(&self) -> impl Iterator<Item = LightField> {
        LightField::ALL.into_iter().filter(|field| self.has(*field))
    }

    /// Number that belongs to a light by its id, from 0 to 1 without it: it stays when other lights
    /// come and go (docs/math.md 6.6).
    pub fn number_of(id: &LightId) -> f64 {
        let mut hash = 0x811c_9dc5_u32;
        for byte in id.as_str().bytes() {
            hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
        // Ids that differ in their last letter alone are to be far apart.
        hash = (hash ^ hash >> 16).wrapping_mul(0x85eb_ca6b);
        hash = (hash ^ hash >> 13).wrapping_mul(0xc2b2_ae35);
        hash ^= hash >> 16;
        // An f32 holds 24 bits.
        f64::from(hash >> 8) / f64::from(1_u32 << 24)
    }

    /// Name that people read: the artist's, or the id.
    pub fn display_name<'l>(&'l self, id: &'l LightId) -> &'l str {
        if self.name.is_empty() { id.as_str() } else { &self.name }
    }
}

/// Kind of a light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LightKind {
    /// Directional light: the same direction everywhere, as in the BADF paper.
    #[default]
    Directional,
    /// Point light: at a position, shining everywhere.
    Point,
    /// Spot light: at a position, shining into a cone.
    Spot,
}

/// Frame that a light's vectors are given in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LightSpace {
    /// Illumination frame: the BADF paper's L.
    #[default]
    Illumination,
    /// World frame.
    World,
    /// Camera frame: x right, y up, z toward the viewer.
    Camera,
    /// Frame of the object that is lit: a light goes along with each object, for it alone. The
    /// origin is the middle of the object's box; axes are the object's, the unit is the scene's.
    Object,
}
