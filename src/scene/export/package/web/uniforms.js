// The bytes of uniforms that belong to the view and to the object. Those of the look itself come
// from `prepare` of the look's own file.

/** Number of columns and rows, or of numbers, of the types that these uniforms have. */
const SHAPES = {
  f32: [1, 1],
  vec2f: [1, 2],
  vec3f: [1, 3],
  vec4f: [1, 4],
  mat3x3f: [3, 3],
  mat4x4f: [4, 4],
};

/** The bytes of a uniform: each member's numbers at its place, where `values` has the member. */
function pack(binding, values) {
  const bytes = new DataView(new ArrayBuffer(binding.size));
  for (const member of binding.members) {
    const value = values[member.name];
    if (value === undefined) continue;
    if (member.type === "u32") {
      bytes.setUint32(member.offset, value, true);
      continue;
    }
    const numbers = typeof value === "number" ? [value] : value;
    const [columns, rows] = SHAPES[member.type];
    for (let i = 0; i < columns * rows; i++) {
      // Columns of matrices begin at multiples of 16 bytes.
      const at = member.offset + 16 * Math.floor(i / rows) + 4 * (i % rows);
      bytes.setFloat32(at, numbers[i], true);
    }
  }
  return bytes.buffer;
}

/** Values of the camera's uniform. Rows are counted from the top in both APIs. */
const viewValues = (view) => ({
  clip_from_world: view.clipFromWorld,
  camera_from_world: view.cameraFromWorld,
  eye: view.parallel ? [...view.toward, 0] : [...view.eye, 1],
  screen: [1, 1, 0, 0],
});

/** Values of the object's uniform. */
const objectValues = (mesh, material) => ({
  world_from_object: mesh.worldFromObject,
  world_from_normal: inverseTranspose3(linear3(mesh.worldFromObject)),
  id: 0,
  material,
  look: 0,
});

/** Values of the uniform of a mesh that casts shadows; objects count from 1. */
const casterValues = (mesh) => ({ world_from_object: mesh.worldFromObject, number: 1 });

/** Numbers of the view that passes over the picture ask for. */
const numbersOf = (view, size, samples) => ({
  pixel: view.pixel,
  perspective: view.parallel ? 0 : 1,
  viewport_height: size[1],
  rows_up: 0,
  samples,
});

/** Axes of an object for lights that belong to it: the model matrix's, unit and at right angles. */
function objectAxes(worldFromObject) {
  const [x, y] = columns3(linear3(worldFromObject));
  const first = normalize(x, [1, 0, 0]);
  const second = normalize(subtract(y, scale(first, dot(first, y))), [0, 1, 0]);
  return [...first, ...second, ...cross(first, second)];
}
