//! What a row of the table of contexts says.

use glam::DMat3;

use super::Rate;
use super::sample::{ContextSample, SurfacePart, SurfacePoint};
use crate::document::{LightInput, LightQuantity};
use crate::interp::Value;

/// A row of the table of contexts.
#[derive(Clone, Copy, Debug)]
pub struct ContextRow {
    /// The word that node files use; also the variable's name in generated source.
    pub word: &'static str,
    /// The WGSL type.
    pub ty: &'static str,
    /// What it is, with its space and unit: a phrase for docs and tooltips.
    pub help: &'static str,
    /// Where its value comes from.
    pub source: ContextSource,
    /// What people call it on a node, where that is not the word.
    pub label: Option<&'static str>,
    /// The word of the context that stands for it in the balanced tier of the node that is the
    /// measure itself.
    pub balanced: Option<&'static str>,
    /// The word of the context that stands for it in the fast tier.
    pub fast: Option<&'static str>,
    /// What each of its numbers may be.
    pub bounds: Bounds,
    /// Its value where a look is evaluated without a scene.
    pub sample: ContextSample,
}

/// Where a context's value comes from. Everything that is needed for it follows: vertex attributes,
/// varyings, bindings, passes, and the functions of the library that an expression calls.
#[derive(Clone, Copy, Debug)]
pub enum ContextSource {
    /// An expression at each fragment of a mesh. It may read the uniforms `view` and `object`, the
    /// varyings of `in`, the unit `normal` toward the seen side, and call whatever is in
    /// `shaders/lib`.
    Fragment {
        /// The expression.
        wgsl: &'static str,
        /// Whether it is found from the derivatives of the fragment's own normal. Such a value is 0
        /// in the modules that draw normals.
        is_derived: bool,
    },
    /// The first result of a pass before the look, and 0 in the modules that draw normals.
    Pass {
        /// The pass, by its slug.
        pass: &'static str,
        /// The value as an expression of `texel`, the result at the fragment's pixel, with the
        /// words of [`Fragment`](Self::Fragment).
        wgsl: &'static str,
    },
    /// A number that the host knows before any fragment runs.
    Host {
        /// How often it changes.
        rate: Rate,
        /// The value.
        value: fn(&HostSurroundings) -> Value,
        /// What a host that runs an exported look has to give.
        meaning: &'static str,
    },
    /// What the light that the node names gives, which the host computes.
    Light(LightInput),
}

/// What a host knows of the frame and the object before any fragment runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostSurroundings {
    /// The rotation from world to camera axes.
    pub camera_from_world: DMat3,
    /// Width and height in pixels.
    pub viewport: [f64; 2],
    /// Seconds.
    pub time: f64,
    /// Frames since the start of the time range.
    pub frame: f64,
    /// Counts objects from 0.
    pub object_id: f64,
}

/// What each number of a context may be, whatever a scene says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bounds {
    /// Anything: what a mesh, an interpolation or a scene says.
    Anything,
    /// A component of a unit vector or of a rotation, or a cosine.
    Unit,
    /// A count from 0, within what f32 counts exactly.
    Count,
    /// A light's intensity, which the host clamps.
    Intensity,
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
            bounds: Bounds::Anything,
            sample: ContextSample::None(&[]),
        }
    }

    /// A context that is an expression at each fragment.
    pub(super) const fn fragment(
        word: &'static str,
        ty: &'static str,
        wgsl: &'static str,
        help: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Fragment { wgsl, is_derived: false }, help)
    }

    /// A context that is found from the derivatives of the fragment's own normal.
    pub(super) const fn derived(
        word: &'static str,
        ty: &'static str,
        wgsl: &'static str,
        help: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Fragment { wgsl, is_derived: true }, help)
    }

    /// A context that a pass serves: the pass's slug, and the value as an expression of `texel`.
    pub(super) const fn of_pass(
        word: &'static str,
        ty: &'static str,
        (pass, wgsl): (&'static str, &'static str),
        help: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Pass { pass, wgsl }, help)
    }

    /// A context that the host knows.
    pub(super) const fn host(
        word: &'static str,
        ty: &'static str,
        (rate, value): (Rate, fn(&HostSurroundings) -> Value),
        help: &'static str,
        meaning: &'static str,
    ) -> Self {
        Self::new(word, ty, ContextSource::Host { rate, value, meaning }, help)
    }

    /// What a light gives: its own row says it.
    pub(super) fn light(input: LightInput) -> Self {
        let is_intensity = matches!(
            input,
            LightInput::Field(field) if field.quantity() == LightQuantity::Factor
        );
        let bounds = match input {
            _ if is_intensity => Bounds::Intensity,
            _ if input.is_unit() => Bounds::Unit,
            _ => Bounds::Anything,
        };
        let source = ContextSource::Light(input);
        Self::new(input.word(), input.wgsl_type(), source, input.help()).within(bounds)
    }

    /// The same with a name for people.
    pub(super) const fn labeled(self, label: &'static str) -> Self {
        Self { label: Some(label), ..self }
    }

    /// The same with what stands for it in the balanced tier of its own node, and in the fast tier.
    pub(super) const fn cheaper(
        self,
        balanced: Option<&'static str>,
        fast: Option<&'static str>,
    ) -> Self {
        Self { balanced, fast, ..self }
    }

    /// The same with numbers that lie within bounds.
    pub(super) const fn within(self, bounds: Bounds) -> Self {
        Self { bounds, ..self }
    }

    /// The same with a sample that follows from parts of the surface.
    pub(super) const fn sampled(
        self,
        parts: &'static [SurfacePart],
        value: fn(&SurfacePoint) -> Value,
    ) -> Self {
        Self { sample: ContextSample::Of { parts, value }, ..self }
    }

    /// The same with numbers of its own in a sample: what they are unless they are given, and
    /// between which they usually lie.
    pub(super) const fn given(
        self,
        default: &'static [f64],
        range: (Option<f64>, Option<f64>),
    ) -> Self {
        Self { sample: ContextSample::Own { default, range }, ..self }
    }

    /// The same where the host computes its value from parts of a sample.
    pub(super) const fn follows(self, parts: &'static [SurfacePart]) -> Self {
        Self { sample: ContextSample::None(parts), ..self }
    }
}
