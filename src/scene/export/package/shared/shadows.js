// Shadow maps: what lights see of the meshes, a layer for a directional light and six for a lamp,
// as docs/hosts.md says.

import { lightFrame, lightNow } from "./frames.js";
import {
  add, clamp, dot, forClipSpace, identity3, length, normalize, scale, subtract, turn,
} from "./math.js";

/** Least and greatest side of a layer, in texels. */
const SIDES = [256, 2048];

/** Memory that the layers of both maps may take, and that of a texel in both, in bytes. */
const MOST_BYTES = 2 ** 28;
const TEXEL_BYTES = 32;

/** Factor by which a layer is wider than what it shows, so that edges have texels beside them. */
const WIDENED = 1 + 1 / 32;

/** Least distance of a lamp's near plane, as a share of the far plane's. */
const NEAREST_TO_LAMP = 1e-4;

/** A state in which every frame is that of the world. */
const NOWHERE = {
  parameters: {}, lights: {}, illumination: identity3, camera: { rotation: identity3 },
  object: { axes: identity3, middle: [0, 0, 0] },
};

/** The lights of a look that ask for shadow maps, in world space. */
function mappedLights(look, state) {
  const asks = ({ fields }) => fields?.includes("light.shadow_map") ?? true;
  return look.lights.filter(asks).map(({ id }) => {
    const light = lightNow(look, state, id);
    const { rotation, origin } = lightFrame(light.space, state);
    return {
      id,
      isLamp: light.type !== "directional",
      toward: turn(rotation, normalize(light.direction)),
      position: add(origin, turn(rotation, light.position)),
    };
  });
}

/** Number of layers in the shadow maps of a look. */
export const layersOf = (look) => mappedLights(look, NOWHERE).reduce(
  (sum, { isLamp }) => sum + (isLamp ? 6 : 1), 0);

/**
 * The shadow maps of a picture: the side of a layer in texels, the layers, each with the values of
 * its uniform, and the places of lights' maps in them, by the lights' ids.
 *
 * @param state the state of the look, as `prepare` takes it.
 * @param sphere `center` and `radius` of the meshes, in world space.
 * @param height height of the picture, in pixels.
 * @param clip clip space, as `forClipSpace` takes it.
 */
export function shadowMaps(look, state, sphere, height, clip) {
  const layers = [];
  const places = {};
  for (const { id, isLamp, toward, position } of mappedLights(look, state)) {
    const first = layers.length;
    const place = isLamp
      ? lampLayers(layers, position, sphere, clip)
      : sunLayer(layers, toward, sphere, clip);
    places[id] = [...place, first];
  }
  let side = clamp(2 ** Math.ceil(Math.log2(1.5 * Math.max(height, 1))), ...SIDES);
  while (side > SIDES[0] && side ** 2 * TEXEL_BYTES * layers.length > MOST_BYTES) side /= 2;
  return { side, layers, places };
}

/** Adds the layer of a directional light; its middle and half of its side. */
function sunLayer(layers, toward, { center, radius }, clip) {
  const [right, up] = mapAxes(toward);
  const half = WIDENED * Math.max(radius, 1e-20);
  const middle = [dot(right, center), dot(up, center)];
  const height = dot(toward, center);
  const depth = 1.001 * Math.max(radius, 1e-20) + 1e-5 * length(center);
  const rows = [
    [...scale(right, 1 / half), -middle[0] / half],
    [...scale(up, 1 / half), -middle[1] / half],
    [...scale(toward, -0.5 / depth), 0.5 + (0.5 * height) / depth],
    [0, 0, 0, 1],
  ];
  layers.push(layerOf(rows, [...toward, 0], 0, layers.length, clip));
  return [...middle, half];
}

/** Adds the six layers of a lamp: +x, -x, +y, -y, +z, -z. */
function lampLayers(layers, place, { center, radius }, clip) {
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const distance = length(subtract(center, place));
  const far = Math.max(1.001 * (distance + radius), 1e-20);
  const near = Math.max(Math.min((distance - radius) / 1.8, 0.5 * far), far * NEAREST_TO_LAMP);
  const depth = far / (far - near);
  for (let face = 0; face < 6; face++) {
    const axis = face >> 1;
    const [right, up] = [axes[(axis + 1) % 3], axes[(axis + 2) % 3]];
    const ahead = scale(axes[axis], face % 2 === 0 ? 1 : -1);
    const measure = [...ahead, -dot(ahead, place)];
    const rows = [
      [...scale(right, 1 / WIDENED), -dot(right, place) / WIDENED],
      [...scale(up, 1 / WIDENED), -dot(up, place) / WIDENED],
      subtract(scale(measure, depth), [0, 0, 0, depth * near]),
      measure,
    ];
    layers.push(layerOf(rows, measure, 1, layers.length, clip));
  }
  return [0, 0, WIDENED];
}

/** Values of a layer's uniform, from the rows of its matrix. */
function layerOf(rows, measure, isLamp, layer, clip) {
  const matrix = [0, 1, 2, 3].flatMap((column) => rows.map((row) => row[column]));
  return { clip_from_world: forClipSpace(matrix, clip), measure, is_lamp: isLamp, layer };
}

/** Axes of a directional light's map, to the right and up (Duff et al. 2017). */
function mapAxes([x, y, z]) {
  const side = z > -0.4142 ? 1 : -1;
  const a = -1 / (side + z);
  const b = x * y * a;
  return [[1 + side * x * x * a, side * b, -side * x], [b, side + y * y * a, -y]];
}

/** The sphere about spheres of several meshes, around the middle of their box. */
export function sphereAround(spheres) {
  if (spheres.length === 1) return spheres[0];
  const end = (most, sign) => [0, 1, 2].map((i) =>
    most(...spheres.map(({ center, radius }) => center[i] + sign * radius)));
  const [least, greatest] = [end(Math.min, -1), end(Math.max, 1)];
  const center = scale(add(least, greatest), 0.5);
  const reach = ({ center: own, radius }) => length(subtract(own, center)) + radius;
  return { center, radius: Math.max(0, ...spheres.map(reach)) };
}
