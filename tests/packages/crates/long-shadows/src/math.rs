//! Vectors and matrices of 64-bit numbers, from which the material makes the numbers of its
//! uniforms. Matrices are columns.

/// Three columns of three numbers.
pub(crate) type Matrix3 = [[f64; 3]; 3];

/// Four columns of four numbers.
pub(crate) type Matrix4 = [[f64; 4]; 4];

pub(crate) fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(crate) fn scale(a: [f64; 3], factor: f64) -> [f64; 3] {
    a.map(|x| factor * x)
}

pub(crate) fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// The vector at length 1; `otherwise` for one without a direction.
pub(crate) fn unit_or(a: [f64; 3], otherwise: [f64; 3]) -> [f64; 3] {
    let all = dot(a, a).sqrt();
    if all > 1e-12 && all.is_finite() { scale(a, 1.0 / all) } else { otherwise }
}

/// A matrix times a vector.
pub(crate) fn transform<const N: usize>(m: &[[f64; N]; N], v: [f64; N]) -> [f64; N] {
    std::array::from_fn(|row| (0..N).map(|column| m[column][row] * v[column]).sum())
}

/// A point of a space in another; the matrix has no projection.
pub(crate) fn transform_point(m: &Matrix4, [x, y, z]: [f64; 3]) -> [f64; 3] {
    xyz(transform(m, [x, y, z, 1.0]))
}

pub(crate) fn xyz([x, y, z, _]: [f64; 4]) -> [f64; 3] {
    [x, y, z]
}

/// The product of two matrices.
pub(crate) fn product(a: &Matrix4, b: &Matrix4) -> Matrix4 {
    b.map(|column| transform(a, column))
}

pub(crate) fn transposed<const N: usize>(m: &[[f64; N]; N]) -> [[f64; N]; N] {
    std::array::from_fn(|row| std::array::from_fn(|column| m[column][row]))
}

/// Rotation and scale of a matrix.
pub(crate) fn linear(m: &Matrix4) -> Matrix3 {
    [xyz(m[0]), xyz(m[1]), xyz(m[2])]
}

/// The inverse transpose, which turns normals. A matrix without an inverse stays as it is.
pub(crate) fn inverse_transpose(m: &Matrix3) -> Matrix3 {
    let [x, y, z] = *m;
    let determinant = dot(x, cross(y, z));
    if determinant.abs() <= 1e-12 {
        return *m;
    }
    [cross(y, z), cross(z, x), cross(x, y)].map(|column| scale(column, 1.0 / determinant))
}

/// Axes of an object for lights that belong to it: the first of the model matrix at length 1, the
/// second at right angles to it, and their cross product.
pub(crate) fn axes(m: &Matrix4) -> Matrix3 {
    let [x, y, _] = linear(m);
    let first = unit_or(x, [1.0, 0.0, 0.0]);
    let along = dot(first, y);
    let across = std::array::from_fn(|i| y[i] - along * first[i]);
    let second = unit_or(across, [0.0, 1.0, 0.0]);
    [first, second, cross(first, second)]
}

/// The numbers at 64 bits.
pub(crate) fn wide<const N: usize, const M: usize>(numbers: [[f32; N]; M]) -> [[f64; N]; M] {
    numbers.map(|column| column.map(f64::from))
}
