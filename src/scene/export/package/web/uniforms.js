// The bytes of uniforms that belong to the view and to the object. Those of the look itself come
// from `prepare` of the look's own file.

/** The bytes of a uniform: each member's numbers at its place, where `values` has the member. */
function pack({ size, members }, values) {
  const floats = new Float32Array(Math.ceil(size / 4));
  write(floats, members, values);
  return floats.buffer;
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
