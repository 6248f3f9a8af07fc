// The bytes of uniforms.

/** Columns and rows of the types that members have. */
export const SHAPES = {
  f32: [1, 1], u32: [1, 1], i32: [1, 1], vec2f: [1, 2], vec3f: [1, 3], vec4f: [1, 4],
  mat3x3f: [3, 3], mat4x4f: [4, 4],
};

/** Writes values into a uniform, each member at its place, where `values` has the member. */
export function write(floats, members, values) {
  for (const member of members) {
    const value = values[member.name];
    if (value === undefined) continue;
    const numbers = typeof value === "number" ? [value] : value;
    if (member.type === "u32") {
      new Uint32Array(floats.buffer)[member.offset / 4] = value;
      continue;
    }
    const [columns, rows] = SHAPES[member.type];
    for (let i = 0; i < columns * rows; i++) {
      // Columns of matrices begin at multiples of 16 bytes.
      floats[member.offset / 4 + 4 * Math.floor(i / rows) + (i % rows)] = numbers[i];
    }
  }
}
