//! Reader of numbers from bytes, which never reads past their end.

/// Bytes that are not yet read, and their byte order.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a> {
    rest: &'a [u8],
    big_endian: bool,
}

impl<'a> Cursor<'a> {
    pub(super) fn little_endian(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, big_endian: false }
    }

    pub(super) fn big_endian(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, big_endian: true }
    }

    /// The next `count` bytes, or `None` where there are fewer.
    pub(super) fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(taken)
    }

    /// The next number, of type `kind`.
    pub(super) fn number(&mut self, kind: NumberType) -> Option<f64> {
        let mut bytes = [0; 8];
        let taken = self.take(kind.size())?;
        bytes[..taken.len()].copy_from_slice(taken);
        if self.big_endian {
            bytes[..taken.len()].reverse();
        }
        let [a, b, c, d, ..] = bytes;
        Some(match kind {
            NumberType::I8 => f64::from(a as i8),
            NumberType::U8 => f64::from(a),
            NumberType::I16 => f64::from(i16::from_le_bytes([a, b])),
            NumberType::U16 => f64::from(u16::from_le_bytes([a, b])),
            NumberType::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            NumberType::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            NumberType::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            NumberType::F64 => f64::from_le_bytes(bytes),
        })
    }

    /// The next three `f32`.
    pub(super) fn vec3(&mut self) -> Option<[f32; 3]> {
        let mut next = || self.number(NumberType::F32).map(|n| n as f32);
        Some([next()?, next()?, next()?])
    }
}

/// Types of the numbers in mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NumberType {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl NumberType {
    /// Size of a number, in bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The greatest value of an unsigned or signed whole type; `None` for floats.
    pub(super) fn max(self) -> Option<f64> {
        match self {
            Self::I8 => Some(f64::from(i8::MAX)),
            Self::U8 => Some(f64::from(u8::MAX)),
            Self::I16 => Some(f64::from(i16::MAX)),
            Self::U16 => Some(f64::from(u16::MAX)),
            Self::I32 => Some(f64::from(i32::MAX)),
            Self::U32 => Some(f64::from(u32::MAX)),
            Self::F32 | Self::F64 => None,
        }
    }
}
