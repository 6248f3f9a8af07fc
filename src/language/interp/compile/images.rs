//! Texture samples, loads and queries.

use chiaro_locale::tr;
use naga::{Expression, Handle, ImageQuery, SampleLevel, SwizzleComponent, TypeInner};

use super::Outcome;
use super::globals::texel;
use super::layout::LayoutProblem;
use super::statements::FunctionCompiler;
use crate::interp::ScalarKind;
use crate::interp::image::{Detail, Operation, OperationKind, Sample};
use crate::interp::instruction::{Instruction, ScalarConversion, Slot};
use crate::interp::resources::Texel;

/// Parts of `Expression::ImageSample`.
pub(super) struct SampleParts {
    pub(super) image: Handle<Expression>,
    pub(super) sampler: Handle<Expression>,
    pub(super) gather: Option<SwizzleComponent>,
    pub(super) coordinate: Handle<Expression>,
    pub(super) array_index: Option<Handle<Expression>>,
    pub(super) offset: Option<Handle<Expression>>,
    pub(super) level: SampleLevel,
    pub(super) depth_ref: Option<Handle<Expression>>,
    pub(super) clamp_to_edge: bool,
}

impl FunctionCompiler<'_> {
    pub(super) fn image_sample(&mut self, parts: &SampleParts) -> Outcome<Vec<Slot>> {
        let detail = match parts.level {
            SampleLevel::Auto => Detail::Auto { bias: None },
            SampleLevel::Zero => Detail::Zero,
            SampleLevel::Exact(level) => Detail::Exact(self.as_float(level)?),
            SampleLevel::Bias(bias) => Detail::Auto { bias: Some(self.scalar(bias)?) },
            SampleLevel::Gradient { x, y } => {
                Detail::Gradient { x: self.value(x)?.to_vec(), y: self.value(y)?.to_vec() }
            }
        };
        let offset = match parts.offset {
            Some(offset) => self.value(offset)?.to_vec(),
            None => Vec::new(),
        };
        let sample = Sample {
            sampler: self.scalar(parts.sampler)?,
            coordinate: self.value(parts.coordinate)?.to_vec(),
            layer: self.optional(parts.array_index)?,
            offset,
            detail,
            reference: self.optional(parts.depth_ref)?,
            gather: parts.gather.map(|component| component.index() as usize),
            clamp_to_edge: parts.clamp_to_edge,
        };
        let texel = self.texel(parts.image)?;
        let count = if parts.gather.is_none() && texel == Texel::Depth { 1 } else { 4 };
        self.image(parts.image, texel, OperationKind::Sample(Box::new(sample)), count)
    }

    pub(super) fn image_load(
        &mut self,
        image: Handle<Expression>,
        coordinate: Handle<Expression>,
        [array_index, sample, level]: [Option<Handle<Expression>>; 3],
    ) -> Outcome<Vec<Slot>> {
        if let Some(sample) = sample {
            return Err(
                self.unsupported(tr!("a multisampled texture (ImageLoad)"), self.span(sample))
            );
        }
        let texel = self.texel(image)?;
        let kind = OperationKind::Load {
            coordinate: self.value(coordinate)?.to_vec(),
            layer: self.optional(array_index)?,
            level: self.optional(level)?,
        };
        self.image(image, texel, kind, if texel == Texel::Depth { 1 } else { 4 })
    }

    pub(super) fn image_query(
        &mut self,
        image: Handle<Expression>,
        query: ImageQuery,
    ) -> Outcome<Vec<Slot>> {
        let texel = self.texel(image)?;
        let (kind, count) = match query {
            ImageQuery::Size { level } => {
                let dimensions = self.dimensions(image);
                (
                    OperationKind::Size { level: self.optional(level)?, dimensions },
                    dimensions as u32,
                )
            }
            ImageQuery::NumLevels => (OperationKind::Levels, 1),
            ImageQuery::NumLayers => (OperationKind::Layers, 1),
            ImageQuery::NumSamples => {
                return Err(
                    self.unsupported(tr!("a multisampled texture (ImageQuery)"), self.span(image))
                );
            }
        };
        self.image(image, texel, kind, count)
    }

    fn image(
        &mut self,
        image: Handle<Expression>,
        texel: Texel,
        kind: OperationKind,
        count: u32,
    ) -> Outcome<Vec<Slot>> {
        let image = self.scalar(image)?;
        let to = self.assembler.reserve(count)?;
        let operation = self.assembler.image(Operation { image, to, texel, kind });
        self.assembler.emit(Instruction::Image { operation })?;
        Ok((to..to + count).collect())
    }

    fn optional(&mut self, handle: Option<Handle<Expression>>) -> Outcome<Option<Slot>> {
        handle.map(|handle| self.scalar(handle)).transpose()
    }

    /// Level of detail, which depth textures take as an integer.
    fn as_float(&mut self, handle: Handle<Expression>) -> Outcome<Slot> {
        let slot = self.scalar(handle)?;
        match self.kind(handle)? {
            ScalarKind::Float => Ok(slot),
            ScalarKind::I32 => self.convert(ScalarConversion::I32ToFloat, slot),
            ScalarKind::U32 | ScalarKind::Bool => self.convert(ScalarConversion::U32ToFloat, slot),
        }
    }

    fn texel(&self, image: Handle<Expression>) -> Outcome<Texel> {
        let texel = match *self.inner(image) {
            TypeInner::Image { class, .. } => texel(class),
            _ => Err(LayoutProblem::Unsupported(tr!("no texture"))),
        };
        texel.map_err(|problem| self.locate(problem.diagnose(&self.subject()), self.span(image)))
    }

    /// Number of components of a texture's size.
    fn dimensions(&self, image: Handle<Expression>) -> usize {
        match self.inner(image) {
            TypeInner::Image { dim: naga::ImageDimension::D1, .. } => 1,
            TypeInner::Image { dim: naga::ImageDimension::D3, .. } => 3,
            _ => 2,
        }
    }
}
