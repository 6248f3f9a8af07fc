// Vectors, matrices and colors. Vectors are arrays of numbers; matrices are arrays of numbers too,
// column after column, as shaders have them.

const add = (a, b) => a.map((x, i) => x + b[i]);
const subtract = (a, b) => a.map((x, i) => x - b[i]);
const scale = (a, factor) => a.map((x) => x * factor);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const length = (a) => Math.hypot(...a);

const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

/** The vector at length 1; `otherwise` for one without a direction. */
function normalize(a, otherwise = [0, 0, 1]) {
  const size = length(a);
  return size > 1e-12 && Number.isFinite(size) ? scale(a, 1 / size) : otherwise;
}

const clamp = (x, least, most) => Math.min(Math.max(x, least), most);

// Matrices of 3 columns.

const identity3 = [1, 0, 0, 0, 1, 0, 0, 0, 1];

const transpose3 = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

const columns3 = (m) => [m.slice(0, 3), m.slice(3, 6), m.slice(6, 9)];

/** A 3x3 matrix times a vector. */
const turn = (m, [x, y, z]) =>
  [0, 1, 2].map((row) => m[row] * x + m[row + 3] * y + m[row + 6] * z);

/** The product of two 3x3 matrices. */
const multiply3 = (a, b) => columns3(b).flatMap((column) => turn(a, column));

const determinant3 = (m) => {
  const [x, y, z] = columns3(m);
  return dot(x, cross(y, z));
};

/** The inverse transpose, for normals. A matrix without an inverse stays as it is. */
function inverseTranspose3(m) {
  const [x, y, z] = columns3(m);
  const determinant = determinant3(m);
  if (Math.abs(determinant) <= 1e-12) return m;
  return scale([...cross(y, z), ...cross(z, x), ...cross(x, y)], 1 / determinant);
}

/** The rotation around a unit axis by an angle in radians. */
function rotation3([x, y, z], angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const t = 1 - c;
  return [
    t * x * x + c, t * x * y + s * z, t * x * z - s * y,
    t * x * y - s * z, t * y * y + c, t * y * z + s * x,
    t * x * z + s * y, t * y * z - s * x, t * z * z + c,
  ];
}

// Matrices of 4 columns.

const linear3 = (m) => [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];

/** A 4x4 matrix times a vector of four numbers. */
const transform = (m, [x, y, z, w]) =>
  [0, 1, 2, 3].map((row) => m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12] * w);

/** A 4x4 matrix without projection times a point. */
const transformPoint = (m, p) => transform(m, [...p, 1]).slice(0, 3);

/** The product of two 4x4 matrices. */
const multiply4 = (a, b) =>
  [0, 4, 8, 12].flatMap((column) => transform(a, b.slice(column, column + 4)));

// Colors.

/** A number of linear light for a number as shown (sRGB). */
const decode = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

/** A number as shown (sRGB) for a number of linear light. */
const encode = (x) => (x <= 0.0031308 ? x * 12.92 : 1.055 * x ** (1 / 2.4) - 0.055);

/** The numbers of `#rrggbb` or `#rrggbbaa`, from 0 to 1, with alpha. */
function colorFromHex(text) {
  const digits = text.replace("#", "").padEnd(8, "f");
  return [0, 2, 4, 6].map((at) => parseInt(digits.slice(at, at + 2), 16) / 255);
}

/** `#rrggbb` of a color, its numbers kept from 0 to 1. */
const hexFromColor = (color) =>
  `#${color
    .slice(0, 3)
    .map((x) => Math.round(255 * clamp(x, 0, 1)).toString(16).padStart(2, "0"))
    .join("")}`;

/** The number that 16 bits of a half float stand for. */
function numberFromHalf(half) {
  const sign = half & 0x8000 ? -1 : 1;
  const exponent = (half >> 10) & 31;
  const fraction = half & 1023;
  if (exponent === 0) return sign * 2 ** -24 * fraction;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  return sign * 2 ** (exponent - 25) * (1024 + fraction);
}
