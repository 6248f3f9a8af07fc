//! Arithmetic on scalars, vectors and matrices that are given as lists of slots.

use super::Outcome;
use super::statements::FunctionCompiler;
use crate::interp::instruction::{
    Comparison, FloatBinary, FloatUnary, Instruction, IntBinary, IntUnary, ScalarConversion, Slot,
};

/// Matrix as a list of columns.
type Columns<'s> = Vec<&'s [Slot]>;

impl FunctionCompiler<'_> {
    /// Emits an instruction that writes a new slot.
    pub(super) fn compute(
        &mut self,
        instruction: impl FnOnce(Slot) -> Instruction,
    ) -> Outcome<Slot> {
        let to = self.assembler.reserve(1)?;
        self.assembler.emit(instruction(to))?;
        Ok(to)
    }

    pub(super) fn float_constant(&mut self, x: f64) -> Outcome<Slot> {
        self.assembler.float(x)
    }

    pub(super) fn int_constant(&mut self, x: u32) -> Outcome<Slot> {
        self.assembler.constant(u64::from(x))
    }

    pub(super) fn float1(&mut self, op: FloatUnary, a: Slot) -> Outcome<Slot> {
        self.compute(|to| Instruction::FloatUnary { op, to, a })
    }

    pub(super) fn float2(&mut self, op: FloatBinary, a: Slot, b: Slot) -> Outcome<Slot> {
        self.compute(|to| Instruction::FloatBinary { op, to, a, b })
    }

    pub(super) fn compare(&mut self, op: Comparison, a: Slot, b: Slot) -> Outcome<Slot> {
        self.compute(|to| Instruction::FloatCompare { op, to, a, b })
    }

    pub(super) fn int1(&mut self, op: IntUnary, a: Slot) -> Outcome<Slot> {
        self.compute(|to| Instruction::IntUnary { op, to, a })
    }

    pub(super) fn int2(&mut self, op: IntBinary, a: Slot, b: Slot) -> Outcome<Slot> {
        self.compute(|to| Instruction::IntBinary { op, to, a, b })
    }

    pub(super) fn convert(&mut self, op: ScalarConversion, a: Slot) -> Outcome<Slot> {
        self.compute(|to| Instruction::Convert { op, to, a })
    }

    pub(super) fn choose(&mut self, condition: Slot, accept: Slot, reject: Slot) -> Outcome<Slot> {
        self.compute(|to| Instruction::Select { to, condition, accept, reject })
    }

    pub(super) fn add(&mut self, a: Slot, b: Slot) -> Outcome<Slot> {
        self.float2(FloatBinary::Add, a, b)
    }

    pub(super) fn subtract(&mut self, a: Slot, b: Slot) -> Outcome<Slot> {
        self.float2(FloatBinary::Subtract, a, b)
    }

    pub(super) fn multiply(&mut self, a: Slot, b: Slot) -> Outcome<Slot> {
        self.float2(FloatBinary::Multiply, a, b)
    }

    pub(super) fn divide(&mut self, a: Slot, b: Slot) -> Outcome<Slot> {
        self.float2(FloatBinary::Divide, a, b)
    }

    /// Applies `f` to each scalar.
    pub(super) fn map(
        &mut self,
        a: &[Slot],
        mut f: impl FnMut(&mut Self, Slot) -> Outcome<Slot>,
    ) -> Outcome<Vec<Slot>> {
        a.iter().map(|&a| f(self, a)).collect()
    }

    /// Applies `f` to each pair of scalars; a list of one is repeated.
    pub(super) fn zip(
        &mut self,
        a: &[Slot],
        b: &[Slot],
        mut f: impl FnMut(&mut Self, Slot, Slot) -> Outcome<Slot>,
    ) -> Outcome<Vec<Slot>> {
        (0..a.len().max(b.len()))
            .map(|index| f(self, component(a, index), component(b, index)))
            .collect()
    }

    /// Emits `a . b`, summed in order.
    pub(super) fn dot(&mut self, a: &[Slot], b: &[Slot]) -> Outcome<Slot> {
        let products = self.zip(a, b, Self::multiply)?;
        self.fold(&products, Self::add)
    }

    /// Joins scalars from left to right.
    pub(super) fn fold(
        &mut self,
        slots: &[Slot],
        mut f: impl FnMut(&mut Self, Slot, Slot) -> Outcome<Slot>,
    ) -> Outcome<Slot> {
        match slots {
            [] => self.int_constant(0),
            [first, rest @ ..] => rest.iter().try_fold(*first, |sum, &slot| f(self, sum, slot)),
        }
    }

    pub(super) fn length(&mut self, a: &[Slot]) -> Outcome<Slot> {
        if let [a] = a {
            return self.float1(FloatUnary::Abs, *a);
        }
        let square = self.dot(a, a)?;
        self.float1(FloatUnary::Sqrt, square)
    }

    pub(super) fn cross(&mut self, a: [Slot; 3], b: [Slot; 3]) -> Outcome<[Slot; 3]> {
        let x = self.determinant2([a[1], a[2]], [b[1], b[2]])?;
        let y = self.determinant2([a[2], a[0]], [b[2], b[0]])?;
        let z = self.determinant2([a[0], a[1]], [b[0], b[1]])?;
        Ok([x, y, z])
    }

    /// Emits `a.x * b.y - a.y * b.x`.
    fn determinant2(&mut self, a: [Slot; 2], b: [Slot; 2]) -> Outcome<Slot> {
        let down = self.multiply(a[0], b[1])?;
        let up = self.multiply(a[1], b[0])?;
        self.subtract(down, up)
    }

    /// Matrix times column vector: the columns weighted by the vector.
    pub(super) fn matrix_vector(&mut self, matrix: &[Slot], vector: &[Slot]) -> Outcome<Vec<Slot>> {
        let transposed = transpose(matrix, vector.len());
        self.vector_matrix(vector, &transposed)
    }

    /// Row vector times matrix: the dot product with each column.
    pub(super) fn vector_matrix(&mut self, vector: &[Slot], matrix: &[Slot]) -> Outcome<Vec<Slot>> {
        matrix.chunks_exact(vector.len().max(1)).map(|column| self.dot(column, vector)).collect()
    }

    /// Matrix times matrix; `inner` is the number of columns of the left and of rows of the right.
    pub(super) fn matrix_matrix(
        &mut self,
        left: &[Slot],
        right: &[Slot],
        inner: usize,
    ) -> Outcome<Vec<Slot>> {
        let mut product = Vec::new();
        for column in right.chunks_exact(inner.max(1)) {
            product.extend(self.matrix_vector(left, column)?);
        }
        Ok(product)
    }

    /// Determinant of a square matrix.
    pub(super) fn determinant(&mut self, matrix: &[Slot], size: usize) -> Outcome<Slot> {
        let columns: Columns = matrix.chunks_exact(size.max(1)).collect();
        let cofactors = self.first_cofactors(&columns)?;
        match columns.first() {
            Some(first) => self.dot(first, &cofactors),
            None => self.float_constant(1.0),
        }
    }

    /// Inverse of a square matrix: the transposed cofactors over the determinant.
    pub(super) fn inverse(&mut self, matrix: &[Slot], size: usize) -> Outcome<Vec<Slot>> {
        let columns: Columns = matrix.chunks_exact(size.max(1)).collect();
        let mut cofactors = Vec::new();
        for index in 0..size {
            // Column `index` is moved to the front; that takes `index` exchanges, each of which
            // changes the sign.
            let mut moved = columns.clone();
            moved[..=index].rotate_right(1);
            let of_column = self.first_cofactors(&moved)?;
            cofactors.extend(match index % 2 {
                0 => of_column,
                _ => self.map(&of_column, |this, slot| this.float1(FloatUnary::Negate, slot))?,
            });
        }
        let determinant = match columns.first() {
            Some(first) => self.dot(first, &cofactors[..size])?,
            None => self.float_constant(1.0)?,
        };
        self.map(&transpose(&cofactors, size), |this, slot| this.divide(slot, determinant))
    }

    /// Cofactors of the first of 2 to 4 columns.
    fn first_cofactors(&mut self, columns: &[&[Slot]]) -> Outcome<Vec<Slot>> {
        match *columns {
            [_, b] => {
                let negative = self.float1(FloatUnary::Negate, b[0])?;
                Ok(vec![b[1], negative])
            }
            [_, b, c] => Ok(self.cross([b[0], b[1], b[2]], [c[0], c[1], c[2]])?.to_vec()),
            [_, b, c, d] => (0..4).map(|row| self.cofactor(row, [b, c, d])).collect(),
            _ => Ok(columns.first().map_or_else(Vec::new, |first| first.to_vec())),
        }
    }

    /// Signed determinant of three columns of four without row `row`.
    fn cofactor(&mut self, row: usize, columns: [&[Slot]; 3]) -> Outcome<Slot> {
        let [b, c, d] = columns.map(|column| {
            let mut rest = (0..4).filter(|&other| other != row).map(|other| column[other]);
            [(); 3].map(|()| rest.next().unwrap_or_default())
        });
        let normal = self.cross(c, d)?;
        let minor = self.dot(&b, &normal)?;
        if row.is_multiple_of(2) { Ok(minor) } else { self.float1(FloatUnary::Negate, minor) }
    }
}

/// Component `index` of a list; a list of one is repeated.
fn component(slots: &[Slot], index: usize) -> Slot {
    if let [only] = slots { *only } else { slots[index] }
}

/// Rows of a matrix, one after the other.
pub(super) fn transpose(matrix: &[Slot], columns: usize) -> Vec<Slot> {
    let rows = matrix.len().checked_div(columns).unwrap_or(0);
    (0..rows).flat_map(|row| matrix.iter().skip(row).step_by(rows).copied()).collect()
}
