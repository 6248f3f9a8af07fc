//! Access to parts of composites, and to the targets of pointers.

use chiaro_locale::tr;
use naga::{ArraySize, Expression, Handle, TypeInner};

use super::Outcome;
use super::expressions::{MemoryPlace, Operand};
use super::statements::FunctionCompiler;
use crate::interp::instruction::{Instruction, IntBinary, Slot};
use crate::interp::resources::SlotSource;

impl FunctionCompiler<'_> {
    pub(super) fn access_index(
        &mut self,
        handle: Handle<Expression>,
        base: Handle<Expression>,
        index: u32,
    ) -> Outcome<()> {
        let composite = self.pointee(base);
        if is_unsized(composite) {
            let index = self.int_constant(index)?;
            return self.access_slot(handle, base, index);
        }
        let layouts = self.context.layouts;
        let types = &self.context.module.types;
        let operand = self.operand(base)?;
        if let Operand::Place(place) = operand {
            let offset = self.checked(layouts.offset(types, composite, index), base)?;
            return self
                .define_place(handle, MemoryPlace { offset: place.offset + offset, ..place });
        }
        let (offset, count) = self.checked(layouts.part(types, composite, index), base)?;
        match operand {
            Operand::Place(_) => Err(self.unsupported_expression(handle)),
            Operand::Value(slots) => match slots.get(offset as usize..(offset + count) as usize) {
                Some(part) => self.define(handle, part.to_vec()),
                None => Err(self.unsupported_expression(handle)),
            },
        }
    }

    pub(super) fn access(
        &mut self,
        handle: Handle<Expression>,
        base: Handle<Expression>,
        index: Handle<Expression>,
    ) -> Outcome<()> {
        let index = self.scalar(index)?;
        self.access_slot(handle, base, index)
    }

    /// Accesses a part of `base` whose index is in a slot.
    fn access_slot(
        &mut self,
        handle: Handle<Expression>,
        base: Handle<Expression>,
        index: Slot,
    ) -> Outcome<()> {
        let composite = self.pointee(base);
        let (count, stride) = self
            .checked(self.context.layouts.elements(&self.context.module.types, composite), base)?;
        match self.operand(base)? {
            Operand::Place(place) => {
                let index = self.within_buffer(composite, place, index)?;
                let (pointer, offset) = match place.pointer {
                    Some(pointer) => (pointer, place.offset),
                    None => (self.pointer(place)?, 0),
                };
                let to =
                    self.compute(|to| Instruction::Index { to, pointer, index, count, stride })?;
                self.define_place(
                    handle,
                    MemoryPlace { buffer: place.buffer, pointer: Some(to), offset },
                )
            }
            Operand::Value(slots) => {
                let first = self.gather(&slots)?;
                let pointer = self.assembler.constant(u64::from(first))?;
                let to =
                    self.compute(|to| Instruction::Index { to, pointer, index, count, stride })?;
                let part = self.load_from(MemoryPlace::at(to), stride)?;
                self.define(handle, part)
            }
        }
    }

    /// Index clamped to the bound buffer, if that has no fixed length.
    fn within_buffer(
        &mut self,
        composite: &TypeInner,
        place: MemoryPlace,
        index: Slot,
    ) -> Outcome<Slot> {
        match place.buffer {
            Some(buffer) if is_unsized(composite) => {
                let last = self.assembler.bound(SlotSource::Last { buffer })?;
                self.int2(IntBinary::MinUnsigned, index, last)
            }
            _ => Ok(index),
        }
    }

    pub(super) fn array_length(&mut self, array: Handle<Expression>) -> Outcome<Vec<Slot>> {
        match self.place(array)?.buffer {
            Some(buffer) => Ok(vec![self.assembler.bound(SlotSource::Length { buffer })?]),
            None => Err(self.unsupported(
                tr!("the length of an array that is in no buffer (ArrayLength)"),
                self.span(array),
            )),
        }
    }

    /// First of neighboring slots that hold the values of `slots`.
    fn gather(&mut self, slots: &[Slot]) -> Outcome<Slot> {
        if slots.is_sorted_by(|a, b| *b == *a + 1)
            && let Some(&first) = slots.first()
        {
            return Ok(first);
        }
        if let Some(first) = self.assembler.constant_run(slots)? {
            return Ok(first);
        }
        let first = self.assembler.reserve(slots.len() as u32)?;
        self.copy(first, slots)?;
        Ok(first)
    }

    /// Slot that holds the number of the slot at `place`.
    pub(super) fn pointer(&mut self, place: MemoryPlace) -> Outcome<Slot> {
        match place {
            MemoryPlace { pointer: None, offset, .. } => self.assembler.constant(u64::from(offset)),
            MemoryPlace { pointer: Some(pointer), offset: 0, .. } => Ok(pointer),
            MemoryPlace { pointer: Some(pointer), offset, .. } => {
                let to = self.assembler.reserve(1)?;
                self.assembler.emit(Instruction::Offset { to, pointer, offset })?;
                Ok(to)
            }
        }
    }

    pub(super) fn load(
        &mut self,
        pointer: Handle<Expression>,
        handle: Handle<Expression>,
    ) -> Outcome<Vec<Slot>> {
        let place = self.place(pointer)?;
        let count = self.slots_of(self.inner(handle), self.span(handle))?;
        self.load_from(place, count)
    }

    fn load_from(&mut self, place: MemoryPlace, count: u32) -> Outcome<Vec<Slot>> {
        if let MemoryPlace { buffer: Some(buffer), pointer: None, offset } = place {
            // No instruction changes a buffer while the program runs.
            return (offset..offset + count)
                .map(|offset| self.assembler.bound(SlotSource::Scalar { buffer, offset }))
                .collect();
        }
        let to = self.assembler.reserve(count)?;
        match place {
            MemoryPlace { pointer: None, offset, .. } => {
                let from: Vec<Slot> = (offset..offset + count).collect();
                self.copy(to, &from)?;
            }
            MemoryPlace { buffer: None, pointer: Some(pointer), offset } => {
                self.assembler.emit(Instruction::Load { to, pointer, offset, count })?;
            }
            MemoryPlace { buffer: Some(buffer), pointer: Some(pointer), offset } => {
                self.assembler.emit(Instruction::LoadBuffer {
                    to,
                    buffer,
                    pointer,
                    offset,
                    count,
                })?;
            }
        }
        Ok((to..to + count).collect())
    }
}

/// True for an array of any length.
fn is_unsized(inner: &TypeInner) -> bool {
    matches!(inner, TypeInner::Array { size: ArraySize::Dynamic, .. })
}
