// Mathematics of the page alone: turns, colors and half floats.

/** The product of two 3x3 matrices. */
const multiply3 = (a, b) => columns3(b).flatMap((column) => turn(a, column));

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
