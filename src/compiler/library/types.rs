//! Types of ports, and the conversions between them.

use std::fmt;

use chiaro_locale::{Text, text};

use crate::document::{LightField, LightQuantity};

/// Type of a port.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Type {
    /// `f32`
    Float,
    /// `i32`
    Int,
    /// `bool`
    Bool,
    /// `vec2f`
    Vec2,
    /// `vec3f`
    Vec3,
    /// `vec4f`
    Vec4,
    /// `Color`: straight RGBA.
    Color,
    /// `Composite`: premultiplied RGBA, the stack of layers below.
    Composite,
    /// `mat3x3f`
    Mat3,
    /// `Angle`: u in [0, pi], given by the sine and cosine of its half.
    Angle,
    /// `Light`: a light as it arrives at a point.
    Light,
    /// `Curve`: a free function of one number.
    Curve,
    /// `Ramp`: a color along one number.
    Ramp,
    /// `texture_2d<f32>` with a sampler.
    Image,
    /// `texture_2d_array<f32>` with a sampler: a hand-painted 6D texture.
    Hcbtf,
    /// `Casters`: the triangles of all objects that cast shadows, which the scene gives.
    Casters,
    /// `ShadowMaps`: what lights see first, which a pass draws.
    ShadowMaps,
    /// Choice: one of a few words, known when the look is compiled.
    Choice,
    /// Id of a light of the look.
    LightName,
    /// Text: the source of a custom node.
    Text,
    /// Struct of a node file's own, made by its `prepare`.
    Prepared(String),
}

impl Type {
    /// Type of a light's field.
    pub fn of_light_field(field: LightField) -> Self {
        match field.quantity() {
            LightQuantity::Direction | LightQuantity::Position => Self::Vec3,
            LightQuantity::Color => Self::Color,
            LightQuantity::Factor | LightQuantity::Angle | LightQuantity::Distance => Self::Float,
        }
    }

    /// Type that a signature's text names; any other name is a struct of the file.
    pub fn from_wgsl(text: &str) -> Self {
        match text {
            "f32" => Self::Float,
            "i32" => Self::Int,
            "bool" => Self::Bool,
            "vec2f" | "vec2<f32>" => Self::Vec2,
            "vec3f" | "vec3<f32>" => Self::Vec3,
            "vec4f" | "vec4<f32>" => Self::Vec4,
            "Color" => Self::Color,
            "Composite" => Self::Composite,
            "mat3x3f" | "mat3x3<f32>" => Self::Mat3,
            "Angle" => Self::Angle,
            "Light" => Self::Light,
            "Curve" => Self::Curve,
            "Ramp" => Self::Ramp,
            "texture_2d<f32>" => Self::Image,
            "texture_2d_array<f32>" => Self::Hcbtf,
            "Casters" => Self::Casters,
            "ShadowMaps" => Self::ShadowMaps,
            other => Self::Prepared(other.to_owned()),
        }
    }

    /// Name of the type in WGSL; empty for a type that never reaches WGSL.
    pub fn wgsl(&self) -> &str {
        match self {
            Self::Float => "f32",
            Self::Int => "i32",
            Self::Bool => "bool",
            Self::Vec2 => "vec2f",
            Self::Vec3 => "vec3f",
            Self::Vec4 | Self::Color | Self::Composite => "vec4f",
            Self::Mat3 => "mat3x3f",
            Self::Angle => "Angle",
            Self::Light => "Light",
            Self::Curve => "Curve",
            Self::Ramp => "Ramp",
            Self::Image => "texture_2d<f32>",
            Self::Hcbtf => "texture_2d_array<f32>",
            Self::Casters => "Casters",
            Self::ShadowMaps => "ShadowMaps",
            Self::Choice | Self::LightName | Self::Text => "",
            Self::Prepared(name) => name,
        }
    }

    /// True for what the scene gives: no wire, value or uniform can hold it.
    pub fn is_scene_resource(&self) -> bool {
        matches!(self, Self::Casters | Self::ShadowMaps)
    }

    /// Number of components, for types of numbers; `None` for others.
    pub fn width(&self) -> Option<usize> {
        Some(match self {
            Self::Float | Self::Int | Self::Bool => 1,
            Self::Vec2 => 2,
            Self::Vec3 => 3,
            Self::Vec4 | Self::Color | Self::Composite => 4,
            _ => return None,
        })
    }

    /// True for a type whose value is always known when the look is compiled, and is never wired.
    pub fn is_setting(&self) -> bool {
        matches!(self, Self::Choice | Self::LightName | Self::Text) || self.is_texture()
    }

    /// True for a file that is bound as a texture.
    pub fn is_texture(&self) -> bool {
        matches!(self, Self::Image | Self::Hcbtf)
    }

    /// Conversion of a value of this type to type `to`; `None` where there is none.
    pub fn convert_to(&self, to: &Self) -> Option<Conversion> {
        use Type::{Angle, Bool, Color, Composite, Float, Int, Vec2, Vec3, Vec4};
        if self == to {
            return Some(Conversion::None);
        }
        let template = match (self, to) {
            (Int, Float) => "f32($)",
            (Bool, Float) => "select(0.0, 1.0, $)",
            (Float, Int) => "int_of($)",
            (Float, Bool) => "($ > 0.5)",
            (Bool, Int) => "select(0, 1, $)",
            (Float, Vec2) => "vec2f($)",
            (Float, Vec3) => "vec3f($)",
            (Float, Vec4) => "vec4f($)",
            (Float, Color | Composite) => "vec4f(vec3f($), 1.0)",
            (Vec2, Vec3) => "vec3f($, 0.0)",
            (Vec2, Vec4) => "vec4f($, 0.0, 0.0)",
            (Vec2, Color | Composite) => "vec4f($, 0.0, 1.0)",
            (Vec3 | Vec4, Vec2) => "$.xy",
            (Vec3, Vec4) => "vec4f($, 0.0)",
            (Vec3, Color | Composite) => "vec4f($, 1.0)",
            (Vec4 | Color, Vec3) => "$.xyz",
            (Color, Vec2) => "$.xy",
            (Vec4, Color) | (Color, Vec4) => "$",
            (Color | Vec4, Composite) => "premultiplied($)",
            (Composite, Color | Vec4) => "straight($)",
            (Composite, Vec3) => "straight($).xyz",
            (Color, Float) => "luminance($)",
            (Composite, Float) => "luminance(straight($))",
            (Angle, Float) => "angle_radians($)",
            (Float, Angle) => "angle_of($)",
            _ => return None,
        };
        Some(Conversion::Template(template))
    }

    /// True if the conversion keeps all information.
    pub fn converts_without_loss(&self, to: &Self) -> bool {
        use Type::{Angle, Bool, Color, Composite, Float, Int, Vec2, Vec3, Vec4};
        self == to
            || matches!(
                (self, to),
                (Int | Bool, Float)
                    | (Float | Int | Bool, Vec2 | Vec3 | Vec4 | Color | Composite | Angle)
                    | (Vec2, Vec3 | Vec4 | Color)
                    | (Vec3, Vec4 | Color | Composite)
                    | (Vec4, Color | Composite)
                    | (Color, Vec4 | Composite)
                    | (Composite, Color | Vec4)
                    | (Angle, Float)
            )
    }

    /// Name of the type in the language that is spoken; `Display` writes it in English.
    pub fn label(&self) -> &str {
        self.name(Text::tr)
    }

    fn name(&self, told: fn(Text) -> &'static str) -> &str {
        told(match self {
            Self::Float => text!("type" => "float"),
            Self::Int => text!("type" => "integer"),
            Self::Bool => text!("type" => "switch"),
            // Words of code, which are the same in every language.
            Self::Vec2 => return "vec2",
            Self::Vec3 => return "vec3",
            Self::Vec4 => return "vec4",
            Self::Prepared(name) => return name,
            Self::Color => text!("type" => "color"),
            Self::Composite => text!("type" => "composite"),
            Self::Mat3 => text!("type" => "matrix"),
            Self::Angle => text!("type" => "angle"),
            Self::Light => text!("type" => "light"),
            Self::Curve => text!("type" => "curve"),
            Self::Ramp => text!("type" => "ramp"),
            Self::Image => text!("type" => "image"),
            Self::Hcbtf => text!("type" => "painted surface"),
            Self::Casters => text!("type" => "casters"),
            Self::ShadowMaps => text!("type" => "shadow maps"),
            Self::Choice => text!("type" => "choice"),
            Self::LightName => text!("type" => "light's id"),
            Self::Text => text!("type" => "text"),
        })
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name(Text::english))
    }
}

/// Conversion of a value to another type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Conversion {
    /// Value as it stands.
    None,
    /// WGSL expression with `$` for the value. Functions in it come from
    /// `shaders/lib/convert.wgsl`.
    Template(&'static str),
}

impl Conversion {
    /// WGSL expression for `value` converted.
    pub fn apply(self, value: &str) -> String {
        match self {
            Self::None => value.to_owned(),
            Self::Template(template) => template.replace('$', value),
        }
    }
}
