// What a look asks of a camera, an object and a scene of three.js. Nothing of three.js is imported:
// both of its builds use this.

import { lightFrame, objectAxes } from "./frames.js";
import { shadowMaps, sphereAround } from "./shadows.js";
import { linear3, normalize, subtract, transformPoint, transpose3, turn } from "./math.js";

/** The parts of a look's state that a camera, an object and a picture's size give. */
export const placeOf = (camera, object, viewport) =>
  ({ camera: cameraState(camera), object: objectState(object), viewport });

/** Part `camera` of the state of a look. */
function cameraState(camera) {
  const world = camera.matrixWorld.elements;
  return {
    rotation: linear3(camera.matrixWorldInverse.elements),
    eye: [world[12], world[13], world[14]],
    parallel: camera.isOrthographicCamera === true,
    toward: normalize([world[8], world[9], world[10]], [0, 0, 1]),
  };
}

/** Part `object` of the state of a look: `id` counts the objects of a program. */
function objectState(object) {
  const world = object.matrixWorld.elements;
  const { geometry } = object;
  if (!geometry.boundingBox) geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox;
  const middle = ["x", "y", "z"].map((axis) => (min[axis] + max[axis]) / 2);
  return {
    id: objectId(object), axes: objectAxes(world), middle: transformPoint(world, middle),
  };
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

/** What the materials of a look do not follow, and what to do. */
const UNFOLLOWED = [
  [({ isInstancedMesh }) => isInstancedMesh, "instances: take a Mesh for each"],
  [({ isBatchedMesh }) => isBatchedMesh, "batches: take a Mesh for each geometry"],
  [({ isSkinnedMesh }) => isSkinnedMesh, "skins: take a Mesh of the posed geometry"],
  [({ geometry }) => Object.keys(geometry.morphAttributes).length > 0,
    "morph targets: bake them into the geometry"],
];

const toldOf = new WeakMap();

/** True once for each look and object or geometry. */
function isNew(look, drawn) {
  if (!toldOf.has(look)) toldOf.set(look, new WeakSet());
  const told = toldOf.get(look);
  return !told.has(drawn) && Boolean(told.add(drawn));
}

/** Says once for each object what of it the look does not draw. */
function checkKind(look, object) {
  if (!isNew(look, object)) return;
  for (const [has, help] of UNFOLLOWED) {
    if (!has(object)) continue;
    const name = object.name || object.type;
    console.error(`Chiaro: ${look.name} on "${name}" does not follow ${help}`);
  }
}

/** Says once for each geometry what the look needs and the geometry lacks. */
export function checkAttributes(look, object) {
  checkKind(look, object);
  const { geometry } = object;
  if (!isNew(look, geometry)) return;
  for (const { name } of look.modules.draw.attributes) {
    if (geometry.attributes[name]) continue;
    const help = HELP[name] ? `: ${HELP[name]}` : "";
    console.error(`Chiaro: ${look.name} needs the attribute "${name}", which the geometry ` +
      `"${geometry.name || object.name || geometry.type}" lacks${help}`);
  }
}

/** Whether a light of the look can follow an object: lights from all around shine from no place. */
export const hasPlace = (light) => light.isObject3D === true &&
  !(light.isAmbientLight || light.isHemisphereLight || light.isLightProbe);

/** Lets lights of three.js drive lights of the look; see `follow` of the materials. */
export function followLights(followed, values, state, look) {
  for (const [id, { light: source, color, intensity }] of followed) {
    const { space } = look.lights.find((light) => light.id === id);
    const { rotation, origin } = lightFrame(space, state);
    const own = (vector) => turn(transpose3(rotation), vector);
    const at = positionOf(source);
    const aim = source.target ? positionOf(source.target) : [0, 0, 0];
    const toward = subtract(at, aim);
    const light = values.lights[id];
    const fields = {
      direction: own(normalize(toward, [0, 1, 0])),
      position: own(subtract(at, origin)),
      aim: own(normalize(toward.map((x) => -x), [0, -1, 0])),
    };
    if (color) fields.color = source.color;
    if (intensity) fields.intensity = source.visible ? source.intensity : 0;
    if (source.isSpotLight) {
      fields.outer = source.angle;
      fields.inner = source.angle * (1 - source.penumbra);
    }
    for (const [field, value] of Object.entries(fields)) if (field in light) light[field] = value;
  }
}

/** Place of an object in the world; lights need not be in the scene. */
function positionOf(object) {
  object.updateWorldMatrix(true, false);
  return object.matrixWorld.elements.slice(12, 15);
}

/** Whether the passes of a look can draw an object: meshes that nothing but their matrix moves. */
const isDrawable = (object) =>
  object.isMesh && object.geometry.attributes.normal &&
  !(object.isSkinnedMesh || object.isInstancedMesh || object.isBatchedMesh) &&
  (Array.isArray(object.material) || object.material.visible);

/** Whether an object casts shadows: what wears a look does. */
export const castsShadow = ({ castShadow, material }) =>
  castShadow || [material].flat().some((one) => one.look !== undefined);

/** The sphere about an object, in world space. */
function sphereOf({ geometry, matrixWorld }) {
  if (!geometry.boundingSphere) geometry.computeBoundingSphere();
  const { center, radius } = geometry.boundingSphere;
  const place = transformPoint(matrixWorld.elements, center.toArray());
  return { center: place, radius: radius * matrixWorld.getMaxScaleOnAxis() };
}

/** The shadow maps of a look for a picture of this height, in pixels. */
export function shadowMapsOf(look, state, scene, height, { isReversed, isWebGL }) {
  const spheres = [];
  scene.traverseVisible((object) => {
    if (isDrawable(object) && castsShadow(object)) spheres.push(sphereOf(object));
  });
  const ends = [isWebGL && !isReversed ? -1 : 0, 1];
  const [near, far] = isReversed ? ends.reverse() : ends;
  const sphere = sphereAround(spheres);
  return shadowMaps(look, state, sphere, height, { near, far, flipsRows: isWebGL });
}

/** Values of the uniform of an object that casts shadows; objects count from 1. */
export const casterValues = (object) =>
  ({ world_from_object: object.matrixWorld.elements, number: objectId(object) + 1 });

/** A state in which lights know the places of their shadow maps. */
export function withShadows(state, shadows) {
  const lights = { ...state.lights };
  for (const [id, place] of Object.entries(shadows?.places ?? {})) {
    lights[id] = { ...lights[id], shadow_map: place };
  }
  return { ...state, lights };
}

/**
 * Runs `draw` while the scene shows its meshes alone, each with the material that `choose` gives
 * for it, if any. Everything is as before afterwards.
 */
export function withMaterials(scene, choose, draw) {
  const restore = [];
  scene.traverseVisible((object) => {
    const chosen = isDrawable(object) && choose(object);
    if (chosen) {
      const { material } = object;
      restore.push(() => (object.material = material));
      object.material = chosen;
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

/** Calls `use` with each vertex of a geometry, as three numbers. */
function eachVertex({ attributes: { position } }, use) {
  for (let i = 0; i < position.count; i++) {
    use([position.getX(i), position.getY(i), position.getZ(i)]);
  }
}

/**
 * Centers a geometry and scales it to a bounding sphere of radius 1, the size that looks are made
 * for: curvature, widths of lines and noise are measured in these units.
 */
export function fit(geometry) {
  geometry.center();
  let most = 0;
  eachVertex(geometry, (vertex) => (most = Math.max(most, Math.hypot(...vertex))));
  if (most > 0) geometry.scale(1 / most, 1 / most, 1 / most);
  return geometry;
}

/** Radius of the meshes about the middle of their common box, in the world. */
function radiusOf(meshes) {
  const each = (use) => {
    for (const { geometry, matrixWorld } of meshes) {
      eachVertex(geometry, (vertex) => use(transformPoint(matrixWorld.elements, vertex)));
    }
  };
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  each((place) => place.forEach((x, k) => {
    low[k] = Math.min(low[k], x);
    high[k] = Math.max(high[k], x);
  }));
  const middle = low.map((x, k) => (x + high[k]) / 2);
  let most = 0;
  each((place) => (most = Math.max(most, Math.hypot(...subtract(place, middle)))));
  return most;
}

/**
 * Brings the meshes of a model to the size that looks are made for: in units of their geometries
 * the whole model has radius 1. Nothing moves or grows; meshes have geometries of their own
 * afterwards.
 */
export function fitAll(root) {
  root.updateWorldMatrix(true, true);
  const meshes = [];
  root.traverse((object) => {
    if (object.isMesh) meshes.push(object);
  });
  const radius = radiusOf(meshes);
  const scales = meshes.map(({ matrixWorld }) => matrixWorld.getMaxScaleOnAxis() / radius);
  meshes.forEach((mesh, i) => {
    const scale = scales[i];
    if (!(scale > 0 && Number.isFinite(scale))) return;
    mesh.geometry = mesh.geometry.clone().scale(scale, scale, scale);
    mesh.scale.divideScalar(scale);
    for (const child of mesh.children) {
      child.position.multiplyScalar(scale);
      child.scale.multiplyScalar(scale);
    }
  });
  root.updateWorldMatrix(false, true);
  return root;
}
