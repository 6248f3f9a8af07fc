//! Images: samples, texels and sizes.

use naga::Expression;

use super::{FunctionWriter, NotWritten, WriteResult};
use crate::compile::functions::code::Code;

impl FunctionWriter<'_> {
    pub(super) fn image(&mut self, expression: &Expression) -> WriteResult<Code> {
        let mut parts = Vec::new();
        let name = match *expression {
            Expression::ImageSample {
                image,
                sampler,
                gather: None,
                coordinate,
                array_index,
                offset: None,
                level,
                depth_ref: None,
                clamp_to_edge: false,
            } => {
                for part in [Some(image), Some(sampler), Some(coordinate), array_index]
                    .into_iter()
                    .flatten()
                {
                    parts.push(self.code(part)?);
                }
                match level {
                    naga::SampleLevel::Auto => "textureSample",
                    naga::SampleLevel::Exact(level) => {
                        parts.push(self.code(level)?);
                        "textureSampleLevel"
                    }
                    naga::SampleLevel::Zero => {
                        parts.push(Code::number("0.0"));
                        "textureSampleLevel"
                    }
                    naga::SampleLevel::Bias(bias) => {
                        parts.push(self.code(bias)?);
                        "textureSampleBias"
                    }
                    naga::SampleLevel::Gradient { x, y } => {
                        parts.push(self.code(x)?);
                        parts.push(self.code(y)?);
                        "textureSampleGrad"
                    }
                }
            }
            Expression::ImageLoad { image, coordinate, array_index, sample: None, level } => {
                for part in
                    [Some(image), Some(coordinate), array_index, level].into_iter().flatten()
                {
                    parts.push(self.code(part)?);
                }
                "textureLoad"
            }
            Expression::ImageQuery { image, query } => {
                parts.push(self.code(image)?);
                match query {
                    naga::ImageQuery::Size { level } => {
                        if let Some(level) = level {
                            parts.push(self.code(level)?);
                        }
                        "textureDimensions"
                    }
                    naga::ImageQuery::NumLevels => "textureNumLevels",
                    naga::ImageQuery::NumLayers => "textureNumLayers",
                    naga::ImageQuery::NumSamples => "textureNumSamples",
                }
            }
            _ => return Err(NotWritten),
        };
        Ok(Code::BuiltIn(name.into(), parts))
    }
}
