// Vectors and matrices: arrays of numbers, matrices column after column, as shaders have them.

export const add = (a, b) => a.map((x, i) => x + b[i]);
export const subtract = (a, b) => a.map((x, i) => x - b[i]);
export const scale = (a, factor) => a.map((x) => x * factor);
export const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const length = (a) => Math.hypot(...a);

export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

/** The vector at length 1; `otherwise` for one without a direction. */
export function normalize(a, otherwise = [0, 0, 1]) {
  const size = length(a);
  return size > 1e-12 && Number.isFinite(size) ? scale(a, 1 / size) : otherwise;
}

export const clamp = (x, least, most) => Math.min(Math.max(x, least), most);

// Matrices of 3 columns.

export const identity3 = [1, 0, 0, 0, 1, 0, 0, 0, 1];

export const transpose3 = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

export const columns3 = (m) => [m.slice(0, 3), m.slice(3, 6), m.slice(6, 9)];

/** A 3x3 matrix times a vector. */
export const turn = (m, [x, y, z]) =>
  [0, 1, 2].map((row) => m[row] * x + m[row + 3] * y + m[row + 6] * z);

export const determinant3 = (m) => {
  const [x, y, z] = columns3(m);
  return dot(x, cross(y, z));
};

/** The inverse transpose, for normals. A matrix without an inverse stays as it is. */
export function inverseTranspose3(m) {
  const [x, y, z] = columns3(m);
  const determinant = determinant3(m);
  if (Math.abs(determinant) <= 1e-12) return m;
  return scale([...cross(y, z), ...cross(z, x), ...cross(x, y)], 1 / determinant);
}

// Matrices of 4 columns.

export const linear3 = (m) => [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];

/** A 4x4 matrix times a vector of four numbers. */
export const transform = (m, [x, y, z, w]) =>
  [0, 1, 2, 3].map((row) => m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12] * w);

/** A 4x4 matrix without projection times a point. */
export const transformPoint = (m, p) => transform(m, [...p, 1]).slice(0, 3);

/** The product of two 4x4 matrices. */
export const multiply4 = (a, b) =>
  [0, 4, 8, 12].flatMap((column) => transform(a, b.slice(column, column + 4)));

/**
 * A projection whose depths go from 0 (near) to 1 (far), for the clip space of an API: `near` and
 * `far` are its depths; with `flipsRows` the first row of the picture is at the bottom.
 */
export function forClipSpace(projection, { near, far, flipsRows }) {
  const y = flipsRows ? -1 : 1;
  return multiply4([1, 0, 0, 0, 0, y, 0, 0, 0, 0, far - near, 0, 0, 0, near, 1], projection);
}
