//! Layers beside the picture: which values of looks are asked for, and the numbers that were drawn.

use super::picture::Picture;
use crate::compile::{AovSource, CompiledShader};
use crate::diag::Diagnostic;
use crate::library::Type;

/// Layer beside the picture that is asked for: what each look gives of it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct AovRequest {
    /// Name of the layer.
    pub name: String,
    /// Sources, each with the number of the only look that it is for; the first that is for a look
    /// counts. Looks without one are 0.
    pub sources: Vec<(Option<usize>, AovSource)>,
}

impl AovRequest {
    /// The source of a look, by the look's number.
    pub(super) fn source(&self, look: usize) -> AovSource {
        let is_for = |only: &Option<usize>| only.is_none_or(|only| only == look);
        let found = self.sources.iter().find(|(only, _)| is_for(only));
        found.map_or(AovSource::Nothing, |(_, source)| source.clone())
    }
}

/// Numbers of a layer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum AovKind {
    /// One number.
    #[default]
    Number,
    /// A vector of two.
    Vector2,
    /// A vector of three.
    Vector3,
    /// A color, premultiplied.
    Color,
}

impl AovKind {
    /// The kind of a value.
    fn of(ty: &Type) -> Self {
        match ty {
            Type::Vec2 => Self::Vector2,
            Type::Vec3 => Self::Vector3,
            Type::Vec4 | Type::Color | Type::Composite | Type::Light => Self::Color,
            _ => Self::Number,
        }
    }

    /// Names of the channels, as compositors know them.
    pub fn channels(self) -> &'static [&'static str] {
        match self {
            Self::Number => &["V"],
            Self::Vector2 => &["X", "Y"],
            Self::Vector3 => &["X", "Y", "Z"],
            Self::Color => &["R", "G", "B"],
        }
    }
}

/// Layer that a plan draws beside the picture.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct AovLayer {
    /// Name of the layer.
    pub name: String,
    /// Numbers of the layer.
    pub kind: AovKind,
}

impl AovLayer {
    /// The layers of `requests`, with what modules of looks, each with the look's file, give of
    /// them.
    ///
    /// # Errors
    /// The reasons why no look has what a request asks for.
    pub(super) fn planned<'m>(
        requests: &[AovRequest],
        modules: &(impl Iterator<Item = (&'m str, &'m CompiledShader)> + Clone),
    ) -> Result<Vec<Self>, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let mut layers = Vec::with_capacity(requests.len());
        for (number, request) in requests.iter().enumerate() {
            let given = || {
                let modules = modules.clone();
                modules.filter_map(move |(file, shader)| Some((file, shader.aovs.get(number)?)))
            };
            let kinds =
                given().filter_map(|(_, found)| Some(AovKind::of(found.as_ref().ok()?.as_ref()?)));
            // The look that knows a near name is the one that was meant.
            let refused = || {
                let refused =
                    given().filter_map(|(file, found)| Some((file, found.as_ref().err()?)));
                refused.min_by_key(|(_, problem)| problem.hints.is_empty())
            };
            let kind = kinds.max();
            if let (None, Some((file, problem))) = (kind, refused()) {
                problems.push(problem.clone().in_file(file));
            }
            layers.push(Self { name: request.name.clone(), kind: kind.unwrap_or_default() });
        }
        if problems.is_empty() { Ok(layers) } else { Err(problems) }
    }
}

/// Picture with the layers beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct LayeredPicture {
    /// The picture.
    pub picture: Picture,
    /// Numbers of each layer of the plan, pixel by pixel in rows from the top: means over a pixel's
    /// samples, each weighted by what is seen of the surface.
    pub layers: Vec<Vec<[f32; 3]>>,
}
