//! Contents of the resources of a running program.

use super::{Sampler, Texture};
use crate::interp::image::Operation;

/// Content bound to one resource.
#[derive(Clone, Debug)]
pub(in crate::interp) enum BoundContent {
    Buffer {
        /// Scalars of the buffer, at least one.
        scalars: Vec<u64>,
        /// Number of elements of the array at the buffer's end.
        length: u32,
    },
    Texture(Texture),
    Sampler(Sampler),
}

/// Source of a slot that is filled when resources are bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::interp) enum SlotSource {
    /// Scalar of a buffer.
    Scalar { buffer: u32, offset: u32 },
    /// Number of elements of the array at a buffer's end.
    Length { buffer: u32 },
    /// Index of the array's last element.
    Last { buffer: u32 },
}

/// Resources of a program, by their number in
/// [`Program::resources`](crate::interp::Program::resources).
#[derive(Clone, Copy, Debug)]
pub(in crate::interp) struct BoundResources<'p> {
    pub(in crate::interp) contents: &'p [BoundContent],
    pub(in crate::interp) operations: &'p [Operation],
}

impl<'p> BoundResources<'p> {
    /// Bits that a slot is filled with.
    pub(in crate::interp) fn scalar(&self, source: SlotSource) -> u64 {
        match source {
            SlotSource::Scalar { buffer, offset } => self.load(buffer, u64::from(offset)),
            SlotSource::Length { buffer } => self.length(buffer).into(),
            SlotSource::Last { buffer } => self.length(buffer).saturating_sub(1).into(),
        }
    }

    fn length(&self, buffer: u32) -> u32 {
        if let Some(BoundContent::Buffer { length, .. }) = self.contents.get(buffer as usize) {
            *length
        } else {
            0
        }
    }

    /// Scalar of a buffer; beyond the end the last.
    pub(in crate::interp) fn load(&self, buffer: u32, at: u64) -> u64 {
        let Some(BoundContent::Buffer { scalars, .. }) = self.contents.get(buffer as usize) else {
            return 0;
        };
        scalars.get(at as usize).or(scalars.last()).copied().unwrap_or(0)
    }

    pub(in crate::interp) fn texture(&self, number: u64) -> Option<&'p Texture> {
        if let Some(BoundContent::Texture(texture)) = self.contents.get(number as usize) {
            Some(texture)
        } else {
            None
        }
    }

    pub(in crate::interp) fn sampler(&self, number: u64) -> Option<&'p Sampler> {
        if let Some(BoundContent::Sampler(sampler)) = self.contents.get(number as usize) {
            Some(sampler)
        } else {
            None
        }
    }
}
