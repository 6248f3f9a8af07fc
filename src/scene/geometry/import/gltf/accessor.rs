//! Reader of glTF accessors that checks every access: the crate's own readers trust counts and
//! offsets.

use chiaro_locale::tr;
use gltf::Accessor;
use gltf::accessor::DataType;
use gltf::accessor::sparse::IndexType;

use crate::diag::Diagnostic;
use crate::geometry::import::cursor::{Cursor, NumberType};
use crate::geometry::import::report::ImportProblem;
use crate::geometry::import::source::Source;
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
    buffers: &[Source],
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
    buffers: &[Source],
    fill: f64,
    make: impl Fn([f64; N]) -> T,
) -> Result<Vec<T>, ImportProblem> {
    let count = accessor.count();
    // Indices come three a triangle, more than any other kind of element.
    if count > 3 * MAX_TRIANGLES.max(MAX_VERTICES) {
        let message = tr!(
            "accessor {index} has {count} elements, more than are allowed",
            index = accessor.index()
        );
        return Err(Diagnostic::error("mesh-too-large", message).into());
    }
    let layout = Layout {
        kind: number(accessor.data_type()),
        width: accessor.dimensions().multiplicity(),
        normalized: accessor.normalized(),
        fill,
    };
    let outside = || {
        let message = tr!("accessor {index} reaches beyond its buffer", index = accessor.index());
        Diagnostic::error("mesh-truncated", message)
    };
    let mut rows = match accessor.view() {
        Some(view) => {
            let stride = view.stride().unwrap_or(layout.size());
            let bytes = part(&view, accessor.offset(), buffers).ok_or_else(outside)?;
            layout.read::<N, T>(&bytes, stride, count, &make)?.ok_or_else(outside)?
        }
        None => vec![make(layout.row(&[0.0; 16])); count],
    };
    if let Some(sparse) = accessor.sparse() {
        let (places, values) = (sparse.indices(), sparse.values());
        let bytes = part(&values.view(), values.offset(), buffers).ok_or_else(outside)?;
        let new = layout.read::<N, T>(&bytes, layout.size(), sparse.count(), &make)?;
        let new = new.ok_or_else(outside)?;
        let bytes = part(&places.view(), places.offset(), buffers).ok_or_else(outside)?.all()?;
        let kind = match places.index_type() {
            IndexType::U8 => NumberType::U8,
            IndexType::U16 => NumberType::U16,
            IndexType::U32 => NumberType::U32,
        };
        let mut cursor = Cursor::little_endian(&bytes);
        for row in new {
            let place = cursor.number(kind).ok_or_else(outside)? as usize;
            *rows.get_mut(place).ok_or_else(outside)? = row;
        }
    }
    Ok(rows)
}

/// The bytes of a view from `offset` on.
fn part<'f>(
    view: &gltf::buffer::View,
    offset: usize,
    buffers: &[Source<'f>],
) -> Option<Source<'f>> {
    let buffer = buffers.get(view.buffer().index())?;
    let view = buffer.part(view.offset() as u64, view.length() as u64)?;
    view.part(offset as u64, view.length().checked_sub(offset as u64)?)
}

/// Number of bytes that are read at a time.
const BLOCK: usize = 1 << 16;

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

    /// The rows of `count` elements, each `stride` bytes behind the one before; `None` where they
    /// reach beyond the bytes.
    ///
    /// # Errors
    /// Where the bytes cannot be read.
    fn read<const N: usize, T>(
        &self,
        bytes: &Source,
        stride: usize,
        count: usize,
        make: impl Fn([f64; N]) -> T,
    ) -> Result<Option<Vec<T>>, ImportProblem> {
        let extent =
            |count: usize| stride.checked_mul(count.checked_sub(1)?)?.checked_add(self.size());
        if extent(count).is_none_or(|needed| needed as u64 > bytes.length()) {
            return Ok(None);
        }
        let mut rows = Vec::with_capacity(count);
        let mut block = Vec::new();
        let mut values = [0.0; 16];
        let at_a_time = (BLOCK / stride.max(1)).max(1);
        for start in (0..count).step_by(at_a_time) {
            let of_block = at_a_time.min(count - start);
            block.resize(extent(of_block).unwrap_or_default(), 0);
            bytes.read((start * stride) as u64, &mut block)?;
            for element in 0..of_block {
                let mut cursor = Cursor::little_endian(&block[element * stride..]);
                for value in values.iter_mut().take(self.width) {
                    *value = cursor.number(self.kind).unwrap_or_default();
                }
                rows.push(make(self.row(&values)));
            }
        }
        Ok(Some(rows))
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
