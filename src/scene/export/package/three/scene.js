// What a look asks of a camera, an object and a scene of three.js. Nothing is imported: both builds
// of three.js use this.

const columns = ({ elements: m }) => [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];

const normalized = ([x, y, z], otherwise) => {
  const length = Math.hypot(x, y, z);
  return length > 1e-12 ? [x / length, y / length, z / length] : otherwise;
};

const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

/** The parts of a look's state that a camera, an object and a picture's size give. */
export const placeOf = (camera, object, viewport) =>
  ({ camera: cameraState(camera), object: objectState(object), viewport });

/** Part `camera` of the state of a look. */
function cameraState(camera) {
  const world = camera.matrixWorld.elements;
  return {
    rotation: columns(camera.matrixWorldInverse),
    eye: [world[12], world[13], world[14]],
    parallel: camera.isOrthographicCamera === true,
    toward: normalized([world[8], world[9], world[10]], [0, 0, 1]),
  };
}

/** Part `object` of the state of a look: `id` counts the objects of a program. */
function objectState(object) {
  const m = object.matrixWorld.elements;
  const x = normalized([m[0], m[1], m[2]], [1, 0, 0]);
  const along = x[0] * m[4] + x[1] * m[5] + x[2] * m[6];
  const y = normalized([m[4] - along * x[0], m[5] - along * x[1], m[6] - along * x[2]], [0, 1, 0]);
  const { geometry } = object;
  if (!geometry.boundingBox) geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox;
  const [a, b, c] = ["x", "y", "z"].map((axis) => (min[axis] + max[axis]) / 2);
  const middle = [0, 1, 2].map((row) => m[row] * a + m[row + 4] * b + m[row + 8] * c + m[row + 12]);
  return { id: objectId(object), axes: [...x, ...y, ...cross(x, y)], middle };
}

const ids = new WeakMap();
let count = 0;

/** Number of an object, from 0 on in the order in which objects are first drawn. */
function objectId(object) {
  if (!ids.has(object)) ids.set(object, count++ % 262144);
  return ids.get(object);
}

/** Values of the uniform `view`. `rowsUp` is the picture's height where row 0 is at its bottom. */
export function viewValues(camera, clipFromWorld, rowsUp) {
  const { eye, parallel, toward } = cameraState(camera);
  return {
    clip_from_world: clipFromWorld.elements,
    camera_from_world: camera.matrixWorldInverse.elements,
    eye: parallel ? [...toward, 0] : [...eye, 1],
    screen: rowsUp ? [1, -1, 0, rowsUp] : [1, 1, 0, 0],
  };
}

/** Values of the uniform `object`; `normal` is a Matrix3 to work in. */
export function objectValues(object, normal, material) {
  return {
    world_from_object: object.matrixWorld.elements,
    world_from_normal: normal.getNormalMatrix(object.matrixWorld).elements,
    id: objectId(object),
    material,
    look: material,
  };
}

/** Values of the uniform `curvature`. */
export function curvatureValues(camera, height, isRowsUp, samples) {
  return {
    pixel: 2 / (camera.projectionMatrix.elements[5] * height),
    perspective: camera.isOrthographicCamera ? 0 : 1,
    viewport_height: height,
    rows_up: isRowsUp ? 1 : 0,
    samples,
  };
}

/** Sides that a material shows: both while a parameter of the look cuts parts away. */
export function sideOf(THREE, { pass, parameters, ownSide }) {
  return parameters[pass.sides_parameter] > 0 ? THREE.DoubleSide : ownSide;
}

const HELP = {
  normal: "geometry.computeVertexNormals()",
  tangent: "geometry.computeTangents(), which needs an index, normals and uv",
  uv: "a geometry with texture coordinates",
  color: "a geometry with vertex colors of four numbers",
};

const told = new WeakSet();

/** Says once for each geometry what the look needs and the geometry lacks. */
export function checkAttributes(look, object) {
  const { geometry } = object;
  if (told.has(geometry)) return;
  told.add(geometry);
  for (const { name } of look.modules.draw.attributes) {
    if (geometry.attributes[name]) continue;
    const help = HELP[name] ? `: ${HELP[name]}` : "";
    console.error(`Chiaro: ${look.name} needs the attribute "${name}", which the geometry ` +
      `"${geometry.name || object.name || geometry.type}" lacks${help}`);
  }
}

/** Lets lights of three.js drive lights of the look; see `follow` of the materials. */
export function followLights(followed, values, state, look) {
  for (const [id, source] of followed) {
    const { space } = look.lights.find((light) => light.id === id);
    const { rotation, origin } = spaceOf(space, state);
    const own = ([x, y, z]) =>
      [0, 3, 6].map((c) => rotation[c] * x + rotation[c + 1] * y + rotation[c + 2] * z);
    const at = positionOf(source);
    const aim = source.target ? positionOf(source.target) : [0, 0, 0];
    const toward = [0, 1, 2].map((i) => at[i] - aim[i]);
    const light = values.lights[id];
    const fields = {
      direction: own(normalized(toward, [0, 1, 0])),
      position: own([0, 1, 2].map((i) => at[i] - origin[i])),
      aim: own(normalized(toward.map((x) => -x), [0, -1, 0])),
      color: source.color,
      intensity: source.visible ? source.intensity : 0,
    };
    if (source.isSpotLight) {
      fields.outer = source.angle;
      fields.inner = source.angle * (1 - source.penumbra);
    }
    for (const [field, value] of Object.entries(fields)) if (field in light) light[field] = value;
  }
}

const positionOf = ({ matrixWorld: { elements: m } }) => [m[12], m[13], m[14]];

/** Rotation to the world, as columns, and origin of a light's own frame. */
function spaceOf(space, { camera, object, illumination }) {
  const r = camera.rotation;
  const transposed = [r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]];
  const identity = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const zero = [0, 0, 0];
  return {
    illumination: { rotation: illumination, origin: zero },
    world: { rotation: identity, origin: zero },
    camera: { rotation: transposed, origin: camera.eye },
    object: { rotation: object.axes, origin: object.middle },
  }[space];
}

/** Whether the passes of a look can draw an object: meshes that nothing but their matrix moves. */
const isDrawable = (object) =>
  object.isMesh && object.geometry.attributes.normal &&
  !(object.isSkinnedMesh || object.isInstancedMesh || object.isBatchedMesh) &&
  (Array.isArray(object.material) || object.material.visible);

/**
 * Runs `draw` while the scene shows its meshes alone, each with the material that `choose` gives
 * for it. Everything is as before afterwards.
 */
export function withMaterials(scene, choose, draw) {
  const restore = [];
  scene.traverseVisible((object) => {
    if (isDrawable(object)) {
      const { material } = object;
      restore.push(() => (object.material = material));
      object.material = choose(object);
    } else if (object.isMesh || object.isLine || object.isPoints || object.isSprite) {
      const { mask } = object.layers;
      restore.push(() => (object.layers.mask = mask));
      object.layers.mask = 0;
    }
  });
  const { background, fog, onBeforeRender, onAfterRender, matrixWorldAutoUpdate } = scene;
  Object.assign(scene, {
    background: null, fog: null, matrixWorldAutoUpdate: false,
    onBeforeRender() {}, onAfterRender() {},
  });
  try {
    draw();
  } finally {
    Object.assign(scene, { background, fog, onBeforeRender, onAfterRender, matrixWorldAutoUpdate });
    for (const step of restore) step();
  }
}

/**
 * Centers a geometry and scales it to a bounding sphere of radius 1, the size that looks are made
 * for: curvature, widths of lines and noise are measured in these units.
 */
export function fit(geometry) {
  geometry.center();
  const { position } = geometry.attributes;
  let most = 0;
  for (let i = 0; i < position.count; i++) {
    most = Math.max(most, Math.hypot(position.getX(i), position.getY(i), position.getZ(i)));
  }
  if (most > 0) geometry.scale(1 / most, 1 / most, 1 / most);
  return geometry;
}
