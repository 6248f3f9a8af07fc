//! Reader of glTF accessors that checks every access: the crate's own readers trust counts and
//! offsets.

use std::borrow::Cow;

use gltf::Accessor;
use gltf::accessor::DataType;
use gltf::accessor::sparse::IndexType;

use crate::diag::Diagnostic;
use crate::geometry::import::cursor::{Cursor, NumberType};
use crate::geometry::import::report::ImportProblem;
use crate::geometry::import::{MAX_TRIANGLES, MAX_VERTICES};

fn number(kind: DataType) -> NumberType {
    match kind {
        DataType::I8 => NumberType::I8,
        DataType::U8 => NumberType::U8,
        DataType::I16 => NumberType::I16,
        DataType::U16 => NumberType::U16,
        DataType::U32 => NumberType::U32,
        DataType::F32 => NumberType::F32,
    }
}

/// The elements of an accessor as rows of `N` numbers: surplus numbers of an element are left out,
/// lacking ones are `fill`. Normalised whole numbers become 0 to 1, or -1 to 1.
///
/// # Errors
/// Where the accessor reaches beyond its view, its view beyond the buffer, or the count beyond the
/// bounds.
pub(super) fn rows<const N: usize>(
    accessor: &Accessor,
    buffers: &[Cow<'_, [u8]>],
    fill: f64,
) -> Result<Vec<[f64; N]>, ImportProblem> {
    rows_as(accessor, buffers, fill, |row| row)
}

/// The [`rows`] of an accessor, each made into what is kept of it: a mesh has millions of rows, and
/// in f64 they are twice as long as in the file.
///
/// # Errors
/// As those of [`rows`].
pub(super) fn rows_as<const N: usize, T: Clone>(
    accessor: &Accessor,
    buffers: &[Cow<'_, [u8]>],
    fill: f64,
    make: impl Fn([f64; N]) -> T,
) -> Result<Vec<T>, ImportProblem> {
    let count = accessor.count();
    // Indices come three a triangle, more than any other kind of element.
    if count > 3 * MAX_TRIANGLES.max(MAX_VERTICES) {
        let message =
            format!("accessor {} has {count} elements, more than are allowed", accessor.index());
        return Err(Diagnostic::error("mesh-too-large", message).into());
    }
    let layout = Layout {
        kind: number(accessor.data_type()),
        width: accessor.dimensions().multiplicity(),
        normalized: accessor.normalized(),
        fill,
    };
    let outside = || {
        let message = format!("accessor {} reaches beyond its buffer", accessor.index());
        Diagnostic::error("mesh-truncated", message)
    };
    let mut rows = match accessor.view() {
        Some(view) => {
            let stride = view.stride().unwrap_or(layout.size());
            let bytes = slice(&view, accessor.offset(), buffers).ok_or_else(outside)?;
            layout.read::<N, T>(bytes, stride, count, &make).ok_or_else(outside)?
        }
        None => vec![make(layout.row(&[0.0; 16])); count],
    };
    if let Some(sparse) = accessor.sparse() {
        let (places, values) = (sparse.indices(), sparse.values());
        let bytes = slice(&values.view(), values.offset(), buffers).ok_or_else(outside)?;
        let new =
            layout.read::<N, T>(bytes, layout.size(), sparse.count(), &make).ok_or_else(outside)?;
        let bytes = slice(&places.view(), places.offset(), buffers).ok_or_else(outside)?;
        let kind = match places.index_type() {
            IndexType::U8 => NumberType::U8,
            IndexType::U16 => NumberType::U16,
            IndexType::U32 => NumberType::U32,
        };
        let mut cursor = Cursor::little_endian(bytes);
        for row in new {
            let place = cursor.number(kind).ok_or_else(outside)? as usize;
            *rows.get_mut(place).ok_or_else(outside)? = row;
        }
    }
    Ok(rows)
}

/// The bytes of a view from `offset` on.
fn slice<'a>(
    view: &gltf::buffer::View,
    offset: usize,
    buffers: &'a [Cow<'_, [u8]>],
) -> Option<&'a [u8]> {
    let end = view.offset().checked_add(view.length())?;
    buffers.get(view.buffer().index())?.get(view.offset()..end)?.get(offset..)
}

struct Layout {
    kind: NumberType,
    /// Count of numbers in an element.
    width: usize,
    normalized: bool,
    fill: f64,
}

impl Layout {
    /// Size of an element, in bytes.
    fn size(&self) -> usize {
        self.kind.size() * self.width
    }

    fn read<const N: usize, T>(
        &self,
        bytes: &[u8],
        stride: usize,
        count: usize,
        make: impl Fn([f64; N]) -> T,
    ) -> Option<Vec<T>> {
        let needed = stride.checked_mul(count.checked_sub(1)?)?.checked_add(self.size())?;
        if needed > bytes.len() {
            return None;
        }
        let mut rows = Vec::with_capacity(count);
        let mut values = [0.0; 16];
        for i in 0..count {
            let mut cursor = Cursor::little_endian(bytes.get(i * stride..)?);
            for value in values.iter_mut().take(self.width) {
                *value = cursor.number(self.kind)?;
            }
            rows.push(make(self.row(&values)));
        }
        Some(rows)
    }

    fn row<const N: usize>(&self, values: &[f64; 16]) -> [f64; N] {
        let scale = self.kind.max().filter(|_| self.normalized).unwrap_or(1.0);
        let mut row = [self.fill; N];
        for (slot, value) in row.iter_mut().zip(&values[..self.width]) {
            *slot = (value / scale).max(if self.normalized { -1.0 } else { f64::NEG_INFINITY });
        }
        row
    }
}
