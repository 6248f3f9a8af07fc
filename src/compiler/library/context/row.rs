//! Rows of the table of contexts.

use glam::DMat3;

use super::Rate;
use super::sample::{ContextSample, SurfacePart, SurfacePoint};
use crate::document::{LightInput, LightQuantity, MAX_INTENSITY, MAX_LIGHT_COLOR};
use crate::interp::{Scalar, Value};

/// Row of the table of contexts.
#[derive(Clone, Copy, Debug)]
pub struct ContextRow {
    /// Word that node files use; also the variable's name in generated source.
    pub word: &'static str,
    /// WGSL type.
    pub ty: &'static str,
    /// Description with space and unit: a phrase for docs and tooltips.
    pub help: &'static str,
    /// Source of the value.
    pub source: ContextSource,
    /// Name for people on a node, where it differs from the word.
    pub label: Option<&'static str>,
    /// Word of the context that replaces this one in the balanced tier of the node that is the
    /// measure itself.
    pub balanced: Option<&'static str>,
    /// Word of the context that replaces this one in the fast tier.
    pub fast: Option<&'static str>,
    /// Bounds of each of the context's numbers.
    pub bounds: ContextBounds,
    /// Value where a look is evaluated without a scene.
    pub sample: ContextSample,
}

/// Source of a context's value. All requirements follow from the source: vertex attributes,
/// varyings, bindings, passes, and the functions of the library that an expression calls.
#[derive(Clone, Copy, Debug)]
pub enum ContextSource {
    /// Expression at each fragment of a mesh. The expression may read the uniforms `view` and
    /// `object`, the varyings of `in`, the unit `normal` toward the seen side, and call the
    /// functions of `shaders/lib`.
    Fragment {
        /// WGSL expression.
        wgsl: &'static str,
        /// True if the value is found from the derivatives of the fragment's own normal. Such a
        /// value is 0 in the modules that draw normals.
        is_derived: bool,
    },
    /// First result of a pass before the look, and 0 in the modules that draw normals.
    Pass {
        /// Slug of the pass.
        pass: &'static str,
        /// Value as an expression of `texel`, the result at the fragment's pixel, with the words of
        /// [`Fragment`](Self::Fragment).
        wgsl: &'static str,
    },
    /// Number that the host knows before any fragment runs.
    Host {
        /// Rate at which the number changes.
        rate: Rate,
        /// Function that computes the value.
        value: fn(&HostSurroundings) -> Value,
        /// Description of the value for a host that runs an exported look.
        meaning: &'static str,
    },
    /// Property of the light that the node names, which the host computes.
    Light(LightInput),
    /// Resource that the executor binds for the whole scene: it is passed to functions and is no
    /// number. Its variable has the context's word for its name.
    Scene {
        /// Slug of the pass that draws it, if one does.
        pass: Option<&'static str>,
    },
}

/// The host's knowledge of the frame and the object before any fragment runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostSurroundings {
    /// Rotation from world to camera axes.
    pub camera_from_world: DMat3,
    /// Width and height of the viewport, in pixels.
    pub viewport: [f64; 2],
    /// Time of the frame, in seconds.
    pub time: f64,
    /// Number of frames since the start of the time range.
    pub frame: f64,
    /// Number of the object, counted from 0.
    pub object_id: f64,
}

/// Bounds of each number of a context, whatever the scene: a promise to shaders, which whoever
/// gives the numbers keeps, so that no fragment asks again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContextBounds {
    /// A finite number of f32.
    Finite,
    /// From -1 to 1: a component of a unit vector or of a rotation, or a cosine.
    Unit,
    /// From -1 to 1: a component of a vector that is unit, shorter, or 0.
    UnitOrShorter,
    /// Count from 0, within the whole numbers that f32 holds exactly.
    Count,
    /// No farther from 0 than this, but for rounding: what loaders of meshes and the bounds of
    /// scenes leave.
    Within(f64),
    /// No farther from 0 than this number of f32: what a pass or a function clamps to.
    Clamped(f64),
    /// Intensity of a light, which the host clamps.
    Intensity,
    /// Color of a light, which the host clamps.
    Color,
}

/// Factor by which a rounding may leave the bounds of what is no clamp.
const ROUNDED: f64 = 1.001;

/// Greatest component of unit vectors and rotations, with their roundings.
const UNIT: f64 = 1.0 + 2e-6;

impl ContextBounds {
    /// Least and greatest number.
    pub fn limits(self) -> [f64; 2] {
        let around_zero = |most: f64| [-most, most];
        match self {
            Self::Finite => around_zero(f64::from(f32::MAX)),
            Self::Unit | Self::UnitOrShorter => around_zero(UNIT),
            Self::Count => [0.0, f64::from(1_u32 << 24)],
            Self::Within(most) => around_zero(most * ROUNDED),
            Self::Clamped(most) => around_zero(most),
            Self::Intensity => [0.0, MAX_INTENSITY * ROUNDED],
            Self::Color => around_zero(MAX_LIGHT_COLOR * ROUNDED),
        }
    }

    /// The number as shaders are promised it: the nearest within the limits, and 0 in the place of
    /// NaN.
    pub fn kept(self, number: f64) -> f64 {
        let [least, most] = self.limits();
        if number.is_nan() { 0.0 } else { number.clamp(least, most) }
    }

    /// Every number of a value as shaders are promised it.
    pub fn kept_value(self, value: Value) -> Value {
        let kept = |scalar: Scalar| match scalar {
            Scalar::Float(x) => Scalar::Float(self.kept(x)),
            other => other,
        };
        match value {
            Value::Float(x) => Value::Float(self.kept(x)),
            Value::Vector(scalars) => Value::Vector(scalars.into_iter().map(kept).collect()),
            Value::Matrix { columns, components } => Value::Matrix {
                columns,
                components: components.into_iter().map(|x| self.kept(x)).collect(),
            },
            other => other,
        }
    }
}

impl ContextRow {
    const fn new(
        word: &'static str,
        ty: &'static str,
        source: ContextSource,
        help: &'static str,
    ) -> Self {
        Self {
            word,
            ty,
            help,
            source,
            label: None,
            balanced: None,
            fast: None,
            bounds: ContextBounds::Finite,
            sample: ContextSample::None(&[]),
        }
    }

    /// Row of a context that is an expression at each fragment.
    pub(super) const fn fragment(
        word: &'static str,
        ty: &'static str,
        wgsl: &'static str,
        help: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Fragment { wgsl, is_derived: false }, help)
    }

    /// Row of a context that is found from the derivatives of the fragment's own normal.
    pub(super) const fn derived(
        word: &'static str,
        ty: &'static str,
        wgsl: &'static str,
        help: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Fragment { wgsl, is_derived: true }, help)
    }

    /// Row of a context that a pass serves: the pass's slug, and the value as an expression of
    /// `texel`.
    pub(super) const fn of_pass(
        word: &'static str,
        ty: &'static str,
        (pass, wgsl): (&'static str, &'static str),
        help: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Pass { pass, wgsl }, help)
    }

    /// Row of a context that the host knows.
    pub(super) const fn host(
        word: &'static str,
        ty: &'static str,
        (rate, value): (Rate, fn(&HostSurroundings) -> Value),
        help: &'static str,
        meaning: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Host { rate, value, meaning }, help)
    }

    /// Row of a resource of the whole scene.
    pub(super) const fn scene(word: &'static str, ty: &'static str, help: &'static str) -> Self {
        Self::new(word, ty, ContextSource::Scene { pass: None }, help)
    }

    /// Row of a resource of the whole scene that the pass with the same name draws.
    pub(super) const fn scene_pass(
        word: &'static str,
        ty: &'static str,
        help: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Scene { pass: Some(word) }, help)
    }

    /// Row of an input from a light, built from the light input's own description.
    pub(super) fn light(input: LightInput) -> Self {
        let is_intensity = matches!(
            input,
            LightInput::Field(field) if field.quantity() == LightQuantity::Factor
        );
        let bounds = match input {
            _ if is_intensity => ContextBounds::Intensity,
            LightInput::Field(field) if field.quantity() == LightQuantity::Color => {
                ContextBounds::Color
            }
            _ if input.is_unit() => ContextBounds::Unit,
            _ => ContextBounds::Finite,
        };
        let source = ContextSource::Light(input);
        Self::new(input.word(), input.wgsl_type(), source, input.help()).within(bounds)
    }

    /// Row with a name for people.
    pub(super) const fn labeled(self, label: &'static str) -> Self {
        Self { label: Some(label), ..self }
    }

    /// Row with replacements in the balanced tier of the measure's own node, and in the fast tier.
    pub(super) const fn cheaper(
        self,
        balanced: Option<&'static str>,
        fast: Option<&'static str>,
    ) -> Self {
        Self { balanced, fast, ..self }
    }

    /// Row with numbers that lie within bounds.
    pub(super) const fn within(self, bounds: ContextBounds) -> Self {
        Self { bounds, ..self }
    }

    /// Row with a sample value that follows from parts of the surface.
    pub(super) const fn sampled(
        self,
        parts: &'static [SurfacePart],
        value: fn(&SurfacePoint) -> Value,
    ) -> Self {
        Self { sample: ContextSample::Of { parts, value }, ..self }
    }

    /// Row with sample numbers of its own: the defaults, and the range in which they usually lie.
    pub(super) const fn given(
        self,
        default: &'static [f64],
        range: (Option<f64>, Option<f64>),
    ) -> Self {
        Self { sample: ContextSample::Own { default, range }, ..self }
    }

    /// Row of a value that the host computes from parts of a sample.
    pub(super) const fn follows(self, parts: &'static [SurfacePart]) -> Self {
        Self { sample: ContextSample::None(parts), ..self }
    }
}
