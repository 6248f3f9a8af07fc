// A highlight, moved: made by Chiaro 0.1.0. This is what draws the look on a canvas.
(() => {
"use strict";

// Vectors and matrices: arrays of numbers, matrices column after column, as shaders have them.

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

/**
 * A projection whose depths go from 0 (near) to 1 (far), for the clip space of an API: `near` and
 * `far` are its depths; with `flipsRows` the first row of the picture is at the bottom.
 */
function forClipSpace(projection, { near, far, flipsRows }) {
  const y = flipsRows ? -1 : 1;
  return multiply4([1, 0, 0, 0, 0, y, 0, 0, 0, 0, far - near, 0, 0, 0, near, 1], projection);
}

// Frames of lights and objects, as docs/hosts.md says.

/** Axes of an object for lights that belong to it: the model matrix's, unit and at right angles. */
function objectAxes(worldFromObject) {
  const [x, y] = columns3(linear3(worldFromObject));
  const first = normalize(x, [1, 0, 0]);
  const second = normalize(subtract(y, scale(first, dot(first, y))), [0, 1, 0]);
  return [...first, ...second, ...cross(first, second)];
}

/** Rotation to the world, as columns, and origin of the frame that a light is in. */
function lightFrame(space, { camera, object, illumination }) {
  const rotations = {
    illumination,
    world: identity3,
    camera: transpose3(camera.rotation),
    object: object.axes,
  };
  return { rotation: rotations[space], origin: space === "object" ? object.middle : [0, 0, 0] };
}

/** A light with the look's values, those of parameters, and those that are set on it. */
function lightNow(look, { parameters, lights }, id) {
  const light = { ...look.lights.find((one) => one.id === id) };
  for (const { key, target } of look.parameters) {
    const [kind, of, field] = target?.split(".") ?? [];
    const value = parameters[key];
    if (kind === "lights" && of === id && value !== undefined) light[field] = value;
  }
  return { ...light, ...lights[id] };
}

// Shadow maps: what lights see of the meshes, a layer for a directional light and six for a lamp,
// as docs/hosts.md says.

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
const layersOf = (look) => mappedLights(look, NOWHERE).reduce(
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
function shadowMaps(look, state, sphere, height, clip) {
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
function sphereAround(spheres) {
  if (spheres.length === 1) return spheres[0];
  const end = (most, sign) => [0, 1, 2].map((i) =>
    most(...spheres.map(({ center, radius }) => center[i] + sign * radius)));
  const [least, greatest] = [end(Math.min, -1), end(Math.max, 1)];
  const center = scale(add(least, greatest), 0.5);
  const reach = ({ center: own, radius }) => length(subtract(own, center)) + radius;
  return { center, radius: Math.max(0, ...spheres.map(reach)) };
}

// The passes of a look.

/** The image that a texture of a pass reads: the output of an earlier pass. */
function sourceOf(pass, { feed, name }) {
  const input = feed.from === "pass" ? feed : pass.inputs?.find(({ binding }) => binding === name);
  return input && `${input.pass}.${input.output}`;
}

/** The passes before the picture. */
const passesBefore = (look) => look.passes.filter(({ name }) => name !== "draw");

/** True where the passes before the picture are the same whatever the values of the look. */
const arePassesShared = (look) => passesBefore(look).every(({ draws, module }) =>
  draws !== "lights" && look.modules[module].bindings.every(({ feed }) => feed.from !== "look"));

// The bytes of uniforms.

/** Columns and rows of the types that members have. */
const SHAPES = {
  f32: [1, 1], u32: [1, 1], i32: [1, 1], vec2f: [1, 2], vec3f: [1, 3], vec4f: [1, 4],
  mat3x3f: [3, 3], mat4x4f: [4, 4],
};

/** Writes values into a uniform, each member at its place, where `values` has the member. */
function write(floats, members, values) {
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

// Painted textures: arrays of layers in KTX2 files.

const RGBA8 = 37;
const BC7 = 145;

/** The layers of a KTX2 file with one level of RGBA8 or BC7, as Chiaro writes it. */
function readLayers(buffer, name) {
  const words = new DataView(buffer);
  const word = (at) => words.getUint32(at, true);
  const format = buffer.byteLength > 104 && word(0) === 0x58544bab ? word(12) : 0;
  if (format !== RGBA8 && format !== BC7) {
    throw new Error(`${name} is no texture of Chiaro: export the look again`);
  }
  const [width, height, layers] = [word(20), word(24), Math.max(word(32), 1)];
  const [start, size] = [80, 88].map((at) => Number(words.getBigUint64(at, true)));
  const bytes = new Uint8Array(buffer, start, size);
  return { width, height, layers, isBlocks: format === BC7, bytes };
}

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

// The camera: where it stands, the matrices of a picture, and how it is turned.

/** Least distance of the near plane, as a share of the far plane's. */
const NEAREST = 1e-3;

/**
 * The matrices of a picture.
 *
 * @param camera `eye`, `target`, `up`, `fov` (vertical, in radians) or, where `parallel`, `height`;
 *   `aspect` is the width over the height that it was placed for: a narrower picture shows as much
 *   in width. 0 for any.
 * @param size width and height of the picture, in pixels.
 * @param sphere `center` and `radius` of what is drawn, in world space.
 * @param clip clip space of the API, as `forClipSpace` takes it.
 */
function viewOf(camera, size, sphere, clip) {
  const backward = normalize(subtract(camera.eye, camera.target));
  const other = Math.abs(backward[1]) < 0.9 ? [0, 1, 0] : [0, 0, 1];
  const right = normalize(cross(camera.up, backward), normalize(cross(other, backward)));
  const up = cross(backward, right);
  const rotation = transpose3([...right, ...up, ...backward]);
  const moved = turn(rotation, scale(camera.eye, -1));
  const cameraFromWorld = [
    ...rotation.slice(0, 3), 0,
    ...rotation.slice(3, 6), 0,
    ...rotation.slice(6, 9), 0,
    ...moved, 1,
  ];
  const aspect = Math.max(size[0], 1) / Math.max(size[1], 1);
  const widening = camera.aspect > 0 ? Math.max(camera.aspect / aspect, 1) : 1;
  const distance = dot(backward, subtract(camera.eye, sphere.center));
  const reach = 1.01 * Math.max(sphere.radius, 1e-6);
  const far = Math.max(distance + reach, 1e-3);
  let projection, height;
  if (camera.parallel) {
    height = Math.max(camera.height, 1e-6) * widening;
    const near = distance - reach;
    const half = 0.5 * height;
    projection = orthographic(half * aspect, half, near, Math.max(far, near + 1e-3));
  } else {
    height = 2 * Math.tan(0.5 * camera.fov) * widening;
    const near = Math.max(distance - reach, far * NEAREST);
    projection = perspective(0.5 * height, aspect, near, Math.max(far, 1.001 * near));
  }
  return {
    clipFromWorld: multiply4(forClipSpace(projection, clip), cameraFromWorld),
    cameraFromWorld,
    rotation,
    eye: camera.eye,
    toward: backward,
    parallel: Boolean(camera.parallel),
    // The size of a pixel in scene units: at depth 1 for perspective, at every depth otherwise.
    pixel: height / Math.max(size[1], 1),
  };
}

// Both projections have depths from 0 (near) to 1 (far).

function perspective(half, aspect, near, far) {
  const depth = far / (near - far);
  return [1 / half / aspect, 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, depth, -1, 0, 0, near * depth, 0];
}

function orthographic(halfWidth, halfHeight, near, far) {
  const depth = 1 / (near - far);
  return [1 / halfWidth, 0, 0, 0, 0, 1 / halfHeight, 0, 0, 0, 0, depth, 0, 0, 0, near * depth, 1];
}

/** Turns the camera around its target: to the right and up, in radians. */
function orbit(camera, yaw, pitch) {
  const offset = subtract(camera.eye, camera.target);
  const backward = normalize(offset);
  // Never over the poles, where right and left would change places.
  const height = Math.asin(clamp(dot(backward, normalize(camera.up, [0, 1, 0])), -1, 1));
  const limit = 0.495 * Math.PI;
  const rise = clamp(height + pitch, -Math.max(limit, -height), Math.max(limit, height)) - height;
  const axis = normalize(camera.up, [0, 1, 0]);
  const right = normalize(cross(axis, backward), [1, 0, 0]);
  const turned = turn(rotation3(axis, yaw), turn(rotation3(right, -rise), offset));
  return { ...camera, eye: add(camera.target, turned) };
}

/** Moves the camera nearer (a factor below 1) or farther, between `least` and `most` away. */
function dolly(camera, factor, least, most) {
  const offset = subtract(camera.eye, camera.target);
  const distance = clamp(length(offset) * factor, least, most);
  const eye = add(camera.target, scale(normalize(offset), distance));
  return { ...camera, eye, height: camera.height * (distance / Math.max(length(offset), 1e-9)) };
}

/** Moves the camera and its target sideways, in pictures' heights. */
function pan(camera, x, y) {
  const offset = subtract(camera.eye, camera.target);
  const backward = normalize(offset);
  const right = normalize(cross(camera.up, backward), [1, 0, 0]);
  const up = cross(backward, right);
  const height = camera.parallel ? camera.height : 2 * Math.tan(0.5 * camera.fov) * length(offset);
  const move = add(scale(right, -x * height), scale(up, y * height));
  return { ...camera, eye: add(camera.eye, move), target: add(camera.target, move) };
}

// What lies in the package's scripts as base64: the mesh, images, and arrays of painted textures.

/** The bytes of a text in base64. */
function bytesFromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** The mesh with its attributes as arrays of numbers, ready for vertex buffers. */
function readMesh(mesh) {
  const attributes = {};
  for (const [name, text] of Object.entries(mesh.attributes)) {
    attributes[name] = new Float32Array(bytesFromBase64(text).buffer);
  }
  const indices = new Uint32Array(bytesFromBase64(mesh.indices).buffer);
  return { ...mesh, attributes, indices };
}

/**
 * The images of a look: `{ bitmap }` for a flat one, and for an array of layers what `readLayers`
 * gives. An image whose file is missing is one white texel.
 */
async function readImages(look, textures) {
  const known = new Map();
  const read = async ({ file, kind }) => {
    const text = file && textures[file];
    if (!text) return missingImage(kind);
    if (kind === "hcbtf") return readLayers(bytesFromBase64(text).buffer, file);
    return readImage(text, file);
  };
  return Promise.all(
    look.images.map((image) => {
      if (!known.has(image.file)) known.set(image.file, read(image));
      return known.get(image.file);
    }),
  );
}

function missingImage(kind) {
  const bytes = new Uint8Array([255, 255, 255, 255]);
  return { width: 1, height: 1, layers: 1, isBlocks: false, bytes, isFlat: kind !== "hcbtf" };
}

async function readImage(text, file) {
  const blob = new Blob([bytesFromBase64(text)]);
  // Numbers as they are in the file: no alpha multiplied in, no profile of the screen.
  const plainly = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
  try {
    const bitmap = await createImageBitmap(blob, plainly);
    return { bitmap, width: bitmap.width, height: bitmap.height, isFlat: true };
  } catch {
    throw new Error(`the image ${file} cannot be read: export the look again`);
  }
}

// Meshes of a page's own: arrays of numbers as other libraries have them.

/** Names that a mesh of one's own has for the attributes of shaders, with their counts. */
const MESH_ARRAYS = {
  position: ["positions", 3], normal: ["normals", 3], tangent: ["tangents", 4], uv: ["uvs", 2],
  color: ["colors", 4],
};

/**
 * The mesh with the attributes that a look reads, as large as the sphere that the look was made
 * for and in its place.
 *
 * @param given `positions`, three numbers a vertex; `indices`, three a triangle, else every three
 *   vertices are one; `normals`, else smooth ones; `uvs`; `colors` of four numbers; `tangents` of
 *   four. `twoSided` where backs are seen.
 * @param wanted names of the attributes that the look reads.
 */
function meshOf(given, wanted, sphere) {
  const positions = Float32Array.from(given.positions ?? []);
  const count = positions.length / 3;
  if (!count || !Number.isInteger(count) || !positions.every(Number.isFinite)) {
    throw new TypeError("positions are finite numbers, three for every vertex");
  }
  const indices = Uint32Array.from(given.indices ?? positions.subarray(0, count).keys());
  if (!indices.length || indices.length % 3 || indices.some((index) => index >= count)) {
    throw new TypeError(`indices are three for every triangle, below the ${count} vertices`);
  }
  const attributes = {};
  for (const name of wanted) {
    const [key, size] = MESH_ARRAYS[name];
    const array = given[key] && Float32Array.from(given[key]);
    if (array && array.length !== size * count) {
      throw new TypeError(`${key} are ${size} numbers for each of the ${count} vertices`);
    }
    attributes[name] = array ?? new Float32Array(size * count).fill(name === "color" ? 1 : 0);
  }
  if (attributes.normal && !given.normals) smoothNormals(positions, indices, attributes.normal);
  if (attributes.tangent && !given.tangents) {
    tangentsFromUvs({ positions, indices, ...attributes });
  }
  const [least, most] = [[...positions.slice(0, 3)], [...positions.slice(0, 3)]];
  const pointAt = (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)];
  for (let vertex = 0; vertex < count; vertex++) {
    pointAt(vertex).forEach((x, i) => {
      least[i] = Math.min(least[i], x);
      most[i] = Math.max(most[i], x);
    });
  }
  const middle = scale(add(least, most), 0.5);
  let radius = 0;
  for (let vertex = 0; vertex < count; vertex++) {
    radius = Math.max(radius, length(subtract(pointAt(vertex), middle)));
  }
  const size = sphere.radius / Math.max(radius, 1e-9);
  const place = subtract(sphere.center, scale(middle, size));
  const worldFromObject = [size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, ...place, 1];
  const twoSided = Boolean(given.twoSided);
  const parts = [{ first: 0, count: indices.length, twoSided, material: 0 }];
  return { worldFromObject, middle, sphere, parts, attributes, indices };
}

/** Normals that are the sums of the triangles' around a vertex, by their areas. */
function smoothNormals(positions, indices, normals) {
  const pointAt = (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)];
  for (let at = 0; at < indices.length; at += 3) {
    const corners = indices.subarray(at, at + 3);
    const [a, b, c] = [...corners].map(pointAt);
    const normal = cross(subtract(b, a), subtract(c, a));
    for (const vertex of corners) normal.forEach((x, i) => (normals[3 * vertex + i] += x));
  }
  for (let at = 0; at < normals.length; at += 3) {
    normals.set(normalize([...normals.subarray(at, at + 3)]), at);
  }
}

/** Tangents along the first coordinate of the uvs; along any direction where there are none. */
function tangentsFromUvs({ positions, indices, normal, uv, tangent }) {
  const at = (array, size, vertex) => [...array.subarray(size * vertex, size * (vertex + 1))];
  const sides = new Float64Array(positions.length);
  for (let first = 0; first < indices.length && uv; first += 3) {
    const corners = [...indices.subarray(first, first + 3)];
    const [a, b, c] = corners.map((vertex) => at(positions, 3, vertex));
    const [p, q, r] = corners.map((vertex) => at(uv, 2, vertex));
    const [[du1, dv1], [du2, dv2]] = [subtract(q, p), subtract(r, p)];
    const area = du1 * dv2 - du2 * dv1;
    if (Math.abs(area) < 1e-12) continue;
    const way = scale(subtract(scale(subtract(b, a), dv2), scale(subtract(c, a), dv1)), 1 / area);
    const along = normalize(way, [0, 0, 0]);
    for (const vertex of corners) along.forEach((x, i) => (sides[3 * vertex + i] += x));
  }
  for (let vertex = 0; vertex < positions.length / 3; vertex++) {
    const up = normal ? at(normal, 3, vertex) : [0, 0, 1];
    const along = at(sides, 3, vertex);
    const flat = subtract(along, scale(up, dot(along, up)));
    const other = Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    tangent.set([...normalize(flat, normalize(cross(other, up))), 1], 4 * vertex);
  }
}

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

// Drawing by WebGPU. `WebGl2Executor` has the same methods.

const WEBGPU_FORMATS = { vec2f: "float32x2", vec3f: "float32x3", vec4f: "float32x4" };

/** Shader that shows the picture on the page. Its alpha is multiplied in, as the page wants it. */
const WEBGPU_SHOWING = (isLinear) => `
@group(0) @binding(0) var picture: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1) * 4.0 - 1.0, f32(index >> 1) * 4.0 - 1.0, 0.0, 1.0);
}

fn encode(x: vec3f) -> vec3f {
    return select(1.055 * pow(x, vec3f(1.0 / 2.4)) - 0.055, 12.92 * x, x <= vec3f(0.0031308));
}

@fragment
fn fs_main(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let found = textureLoad(picture, vec2i(at.xy), 0);
    let straight = clamp(found.rgb / max(found.a, 1e-6), vec3f(0.0), vec3f(1.0));
    return vec4f(${isLinear ? "encode(straight)" : "straight"} * found.a, found.a);
}`;

class WebGpuExecutor {
  label = "WebGPU";
  clip = { near: 0, far: 1, flipsRows: false };

  /** An executor that draws on `canvas`. Rejects, with the reason, where WebGPU is missing. */
  static async create(canvas, content) {
    if (!navigator.gpu) throw new Error("this browser has no WebGPU");
    const adapter = await navigator.gpu.requestAdapter();
    if (!adapter) throw new Error("WebGPU finds no graphics card");
    const blocks = "texture-compression-bc";
    const requiredFeatures = adapter.features.has(blocks) ? [blocks] : [];
    const device = await adapter.requestDevice({ requiredFeatures });
    const executor = new WebGpuExecutor();
    Object.assign(executor, content, { canvas, device, adapter });
    device.pushErrorScope("validation");
    executor.uploadMesh();
    executor.uploadImages();
    const problem = await device.popErrorScope();
    if (problem) throw new Error(problem.message);
    await executor.compile();
    return executor;
  }

  uploadMesh() {
    const upload = (array, usage) => {
      const size = Math.ceil(array.byteLength / 4) * 4;
      const buffer = this.device.createBuffer({ size, usage: usage | GPUBufferUsage.COPY_DST });
      this.device.queue.writeBuffer(buffer, 0, array);
      return buffer;
    };
    this.indices = upload(this.mesh.indices, GPUBufferUsage.INDEX);
    this.vertices = {};
    for (const [name, array] of Object.entries(this.mesh.attributes)) {
      this.vertices[name] = upload(array, GPUBufferUsage.VERTEX);
    }
  }

  uploadImages() {
    this.textures = this.images.map((image, index) => this.uploadImage(image, index));
    this.samplers = this.look.images.map(({ wrap, filter }) => {
      const mode = { repeat: "repeat", clamp: "clamp-to-edge", mirror: "mirror-repeat" }[wrap];
      const filters = { magFilter: filter, minFilter: filter };
      return this.device.createSampler({ addressModeU: mode, addressModeV: mode, ...filters });
    });
  }

  uploadImage(image, index) {
    if (image.isBlocks && !this.device.features.has("texture-compression-bc")) {
      throw new Error("this graphics card does not read textures in BC7 blocks");
    }
    const isDecoded = isDecodedBySampling(this.look, index);
    const flat = isDecoded ? "rgba8unorm-srgb" : "rgba8unorm";
    const format = image.isBlocks ? "bc7-rgba-unorm" : flat;
    const size = [image.width, image.height, image.layers ?? 1];
    const { TEXTURE_BINDING, COPY_DST, RENDER_ATTACHMENT } = GPUTextureUsage;
    const drawn = image.isBlocks ? 0 : RENDER_ATTACHMENT;
    const texture = this.device.createTexture({
      size, format, usage: TEXTURE_BINDING | COPY_DST | drawn,
    });
    if (image.bitmap) {
      const place = { texture, premultipliedAlpha: false };
      this.device.queue.copyExternalImageToTexture({ source: image.bitmap }, place, size);
    } else {
      // Four texels are 16 bytes, and so are the sixteen of a block.
      const bytesPerRow = 4 * image.width;
      const rowsPerImage = image.isBlocks ? image.height / 4 : image.height;
      const layout = { bytesPerRow, rowsPerImage };
      this.device.queue.writeTexture({ texture }, image.bytes, layout, size);
    }
    return texture.createView({ dimension: image.isFlat ? "2d" : "2d-array" });
  }

  /** Compiles the modules, and the pipelines that the first picture needs. */
  async compile() {
    this.modules = {};
    for (const [name, module] of Object.entries(this.look.modules)) {
      const code = this.device.createShaderModule({ code: module.wgsl, label: name });
      const entries = module.bindings.map((binding) => this.layoutEntry(binding));
      const layout = this.device.createBindGroupLayout({ entries });
      const pipelineLayout = this.device.createPipelineLayout({ bindGroupLayouts: [layout] });
      this.modules[name] = { ...module, code, layout, pipelineLayout };
    }
    this.pipelines = new Map();
    this.buffers = new Map();
    this.format = navigator.gpu.getPreferredCanvasFormat();
    const isLinear = this.look.colorSpace === "linear";
    const shown = this.device.createShaderModule({ code: WEBGPU_SHOWING(isLinear) });
    this.showing = await this.device.createRenderPipelineAsync({
      layout: "auto",
      vertex: { module: shown },
      fragment: { module: shown, targets: [{ format: this.format }] },
    });
    this.context = this.canvas.getContext("webgpu");
    const { device, format } = this;
    this.context.configure({ device, format, alphaMode: "premultiplied" });
    const first = this.look.passes.map(async (pass) => {
      const [key, descriptor] = this.pipelineOf(pass, pass.sides === "both", this.samples);
      this.pipelines.set(key, await this.device.createRenderPipelineAsync(descriptor));
    });
    await Promise.all(first);
  }

  layoutEntry({ kind, type, feed, wgsl }) {
    const visibility = GPUShaderStage.VERTEX | GPUShaderStage.FRAGMENT;
    const entry = { binding: wgsl.binding, visibility };
    if (kind === "uniform") return { ...entry, buffer: {} };
    if (kind === "sampler") return { ...entry, sampler: {} };
    const isArray = feed.from === "image" && this.look.images[feed.image].kind === "hcbtf";
    const viewDimension = isArray || type?.includes("array") ? "2d-array" : "2d";
    const sampleType = feed.from === "image" ? "float" : "unfilterable-float";
    return { ...entry, texture: { sampleType, viewDimension } };
  }

  /** Key and descriptor of the pipeline of a pass. */
  pipelineOf(pass, both, samples) {
    const module = this.modules[pass.module];
    const isPicture = pass.name === "draw";
    const drawsMeshes = pass.draws !== "screen";
    const count = isPicture ? samples : 1;
    // What casts shadows does so with both sides.
    const showsBacks = both || pass.draws !== "meshes";
    const { vertex, fragment } = module.entry_points;
    const attributes = drawsMeshes ? module.attributes : [];
    const buffers = attributes.map(({ type, location }) => ({
      arrayStride: 4 * Number(type[3]),
      attributes: [{ shaderLocation: location, offset: 0, format: WEBGPU_FORMATS[type] }],
    }));
    const over = { srcFactor: "src-alpha", dstFactor: "one-minus-src-alpha" };
    const blend = { color: over, alpha: { srcFactor: "one", dstFactor: "one-minus-src-alpha" } };
    const targets = isPicture
      ? [{ format: "rgba16float", blend }]
      : pass.outputs.map(({ format }) => ({ format }));
    const descriptor = {
      label: pass.name,
      layout: module.pipelineLayout,
      vertex: { module: module.code, entryPoint: vertex, buffers },
      fragment: { module: module.code, entryPoint: fragment, targets },
      primitive: {
        frontFace: this.mesh.isMirrored ? "cw" : "ccw",
        cullMode: showsBacks ? "none" : "back",
      },
      multisample: { count },
    };
    if (drawsMeshes) {
      const depth = { format: "depth32float", depthCompare: "less", depthWriteEnabled: true };
      descriptor.depthStencil = depth;
    }
    return [`${pass.name} ${both} ${count}`, descriptor];
  }

  pipeline(pass, both, samples) {
    const [key, descriptor] = this.pipelineOf(pass, both, samples);
    let found = this.pipelines.get(key);
    if (!found) {
      found = this.device.createRenderPipeline(descriptor);
      this.pipelines.set(key, found);
    }
    return found;
  }

  /** The textures that the passes draw into, for one size. */
  targetsOf([width, height], samples) {
    const { RENDER_ATTACHMENT, TEXTURE_BINDING, COPY_SRC } = GPUTextureUsage;
    const all = [];
    const make = (format, usage, sampleCount = 1) => {
      const size = [width, height];
      const texture = this.device.createTexture({ size, format, usage, sampleCount });
      all.push(texture);
      return texture.createView();
    };
    const found = { size: [width, height], samples, images: {}, depths: {} };
    for (const pass of this.look.passes) {
      if (pass.draws === "lights") continue;
      const isPicture = pass.name === "draw";
      if (pass.draws === "meshes") {
        const count = isPicture ? samples : 1;
        found.depths[pass.name] = make("depth32float", RENDER_ATTACHMENT, count);
      }
      for (const output of isPicture ? [] : pass.outputs) {
        const usage = RENDER_ATTACHMENT | TEXTURE_BINDING;
        found.images[`${pass.name}.${output.name}`] = make(output.format, usage);
      }
    }
    found.picture = make("rgba16float", RENDER_ATTACHMENT | TEXTURE_BINDING | COPY_SRC);
    found.pictureTexture = all.at(-1);
    found.sampled = samples > 1 ? make("rgba16float", RENDER_ATTACHMENT, samples) : null;
    found.destroy = () => all.forEach((texture) => texture.destroy());
    return found;
  }

  /** Draws all passes of a frame into `targets`. */
  run(frame, targets) {
    const encoder = this.device.createCommandEncoder();
    if (frame.shadows) this.runShadows(encoder, frame);
    for (const pass of this.look.passes) {
      if (pass.draws !== "lights") this.runPass(encoder, pass, frame, targets);
    }
    return encoder;
  }

  /** Draws what lights see, where a light has moved since it was drawn last. */
  runShadows(encoder, frame) {
    const { side, layers } = frame.shadows;
    const passes = this.look.passes.filter(({ draws }) => draws === "lights");
    if (this.shadows?.side !== side || this.shadows.count !== layers.length) {
      this.shadows?.destroy();
      this.shadows = this.shadowTargets(passes, side, layers.length);
    }
    const drawn = JSON.stringify(layers);
    if (drawn === this.shadows.drawn) return;
    this.shadows.drawn = drawn;
    for (const pass of passes) {
      layers.forEach((_, layer) => {
        const image = ({ name, clear }) => ({
          view: this.shadows.layers[`${pass.name}.${name}`][layer],
          loadOp: "clear", storeOp: "store", clearValue: clear,
        });
        const depth = { depthClearValue: 1, depthLoadOp: "clear", depthStoreOp: "discard" };
        const drawing = encoder.beginRenderPass({
          label: pass.name,
          colorAttachments: pass.outputs.map(image),
          depthStencilAttachment: { view: this.shadows.depth, ...depth },
        });
        drawing.setPipeline(this.pipeline(pass, true, 1));
        const module = this.modules[pass.module];
        drawing.setBindGroup(0, this.bindGroup(pass, module, frame, this.shadows, layer));
        this.bindMesh(drawing, module);
        drawing.drawIndexed(this.mesh.indices.length);
        drawing.end();
      });
    }
  }

  /** The textures of shadow maps, with views of all layers and of each. */
  shadowTargets(passes, side, count) {
    const { RENDER_ATTACHMENT, TEXTURE_BINDING } = GPUTextureUsage;
    const all = [];
    const make = (format, usage, layers) => {
      const texture = this.device.createTexture({ size: [side, side, layers], format, usage });
      all.push(texture);
      return texture;
    };
    const found = { side, count, images: {}, layers: {} };
    for (const pass of passes) {
      for (const { name, format } of pass.outputs) {
        const layers = Math.max(count, 2);
        const texture = make(format, RENDER_ATTACHMENT | TEXTURE_BINDING, layers);
        const key = `${pass.name}.${name}`;
        found.images[key] = texture.createView({ dimension: "2d-array" });
        found.layers[key] = Array.from({ length: layers }, (_, layer) =>
          texture.createView({ dimension: "2d", baseArrayLayer: layer, arrayLayerCount: 1 }));
      }
    }
    found.depth = make("depth32float", RENDER_ATTACHMENT, 1).createView();
    found.destroy = () => all.forEach((texture) => texture.destroy());
    return found;
  }

  runPass(encoder, pass, frame, targets) {
    const isPicture = pass.name === "draw";
    const cleared = { loadOp: "clear", storeOp: "store", clearValue: [0, 0, 0, 0] };
    const picture = targets.sampled
      ? { ...cleared, view: targets.sampled, resolveTarget: targets.picture, storeOp: "discard" }
      : { ...cleared, view: targets.picture };
    const image = ({ name, clear }) =>
      ({ ...cleared, clearValue: clear, view: targets.images[`${pass.name}.${name}`] });
    const colorAttachments = isPicture ? [picture] : pass.outputs.map(image);
    const descriptor = { colorAttachments, label: pass.name };
    if (pass.draws === "meshes") {
      const view = targets.depths[pass.name];
      const depth = { view, depthClearValue: 1, depthLoadOp: "clear", depthStoreOp: "discard" };
      descriptor.depthStencilAttachment = depth;
    }
    const drawing = encoder.beginRenderPass(descriptor);
    const module = this.modules[pass.module];
    if (pass.draws === "screen") {
      drawing.setPipeline(this.pipeline(pass, false, 1));
      drawing.setBindGroup(0, this.bindGroup(pass, module, frame, targets, 0));
      drawing.draw(3);
    } else {
      this.bindMesh(drawing, module);
      this.mesh.parts.forEach((part, number) => {
        const both = frame.drawsBoth(pass, part);
        drawing.setPipeline(this.pipeline(pass, both, frame.samples));
        drawing.setBindGroup(0, this.bindGroup(pass, module, frame, targets, number));
        drawing.drawIndexed(part.count, 1, part.first);
      });
    }
    drawing.end();
  }

  bindMesh(drawing, module) {
    module.attributes.forEach(({ name }, slot) => {
      drawing.setVertexBuffer(slot, this.vertices[name]);
    });
    drawing.setIndexBuffer(this.indices, "uint32");
  }

  bindGroup(pass, module, frame, targets, part) {
    const entries = module.bindings.map((binding) => {
      const { feed, kind, name, wgsl } = binding;
      let resource;
      if (kind === "uniform") {
        const buffer = this.buffer(`${pass.module} ${name} ${part}`, binding.size);
        this.device.queue.writeBuffer(buffer, 0, frame.bytes(pass.module, binding, part));
        resource = { buffer };
      } else if (feed.from === "image") {
        resource = this.textures[feed.image];
      } else if (feed.from === "sampler") {
        resource = this.samplers[feed.image];
      } else {
        const source = sourceOf(pass, binding);
        resource = targets.images[source] ?? this.shadows.images[source];
      }
      return { binding: wgsl.binding, resource };
    });
    return this.device.createBindGroup({ layout: module.layout, entries });
  }

  buffer(key, size) {
    let found = this.buffers.get(key);
    if (!found) {
      const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
      found = this.device.createBuffer({ size: Math.ceil(size / 16) * 16, usage });
      this.buffers.set(key, found);
    }
    return found;
  }

  /** Draws a frame on the page. */
  show(frame) {
    const [width, height] = frame.size;
    const is = this.targets;
    if (!is || is.size[0] !== width || is.size[1] !== height || is.samples !== frame.samples) {
      is?.destroy();
      this.targets = this.targetsOf(frame.size, frame.samples);
    }
    const encoder = this.run(frame, this.targets);
    const view = this.context.getCurrentTexture().createView();
    const drawing = encoder.beginRenderPass({
      colorAttachments: [{ view, loadOp: "clear", storeOp: "store" }],
    });
    drawing.setPipeline(this.showing);
    const entries = [{ binding: 0, resource: this.targets.picture }];
    const layout = this.showing.getBindGroupLayout(0);
    drawing.setBindGroup(0, this.device.createBindGroup({ layout, entries }));
    drawing.draw(3);
    drawing.end();
    this.device.queue.submit([encoder.finish()]);
  }

  /** The numbers of a frame drawn beside the page: premultiplied RGBA, the top row first. */
  async read(frame) {
    const targets = this.targetsOf(frame.size, frame.samples);
    const encoder = this.run(frame, targets);
    const [width, height] = frame.size;
    const bytesPerRow = Math.ceil((8 * width) / 256) * 256;
    const usage = GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ;
    const buffer = this.device.createBuffer({ size: bytesPerRow * height, usage });
    encoder.copyTextureToBuffer(
      { texture: targets.pictureTexture }, { buffer, bytesPerRow }, [width, height],
    );
    this.device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const halves = new Uint16Array(buffer.getMappedRange());
    const numbers = new Float32Array(4 * width * height);
    for (let row = 0; row < height; row++) {
      for (let i = 0; i < 4 * width; i++) {
        numbers[row * 4 * width + i] = numberFromHalf(halves[(row * bytesPerRow) / 2 + i]);
      }
    }
    buffer.destroy();
    targets.destroy();
    return numbers;
  }

  /** Calls `then` with the reason when the graphics card is lost, once. */
  onLost(then) {
    this.device.lost.then(({ message }) => this.isClosed || then(message));
  }

  /** Resolves when everything is drawn that was asked for. */
  finished() {
    return this.device.queue.onSubmittedWorkDone();
  }

  /** Draws another mesh with the same attributes from now on. */
  replaceMesh(mesh) {
    const before = [this.indices, ...Object.values(this.vertices)];
    this.mesh = mesh;
    this.uploadMesh();
    before.forEach((buffer) => buffer.destroy());
    // Which side is the front is part of a pipeline, and shadow maps show the mesh before.
    this.pipelines.clear();
    this.shadows?.destroy();
    this.shadows = null;
  }

  destroy() {
    this.isClosed = true;
    this.targets?.destroy();
    this.shadows?.destroy();
    this.device.destroy();
  }
}

// Drawing by WebGL 2, with the methods of `WebGpuExecutor`.
//
// Everything is drawn with its first row at the top, as WebGPU draws it, by turning y over in clip
// space; the last step shows the picture upside down. So derivatives, which graphics cards take
// once for every two by two pixels, are those of WebGPU.

const WEBGL2_SHOWING_VERTEX = `#version 300 es
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}`;

const WEBGL2_SHOWING_FRAGMENT = (isLinear) => `#version 300 es
precision highp float;
uniform highp sampler2D picture;
out vec4 color;

vec3 encode(vec3 x) {
    bvec3 isDark = lessThanEqual(x, vec3(0.0031308));
    return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, isDark);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 found = texelFetch(picture, ivec2(at.x, textureSize(picture, 0).y - 1 - at.y), 0);
    vec3 straight = clamp(found.rgb / max(found.a, 1e-6), 0.0, 1.0);
    color = vec4(${isLinear ? "encode(straight)" : "straight"} * found.a, found.a);
}`;

class WebGl2Executor {
  label = "WebGL 2";
  clip = { near: -1, far: 1, flipsRows: true };

  /** An executor that draws on `canvas`. Rejects, with the reason, where WebGL 2 is missing. */
  static async create(canvas, content) {
    const gl = canvas.getContext("webgl2", { antialias: false, depth: false, alpha: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    if (!gl.getExtension("EXT_color_buffer_float")) {
      throw new Error("this graphics card cannot draw numbers of 32 bits by WebGL 2");
    }
    const executor = new WebGl2Executor();
    Object.assign(executor, content, { canvas, gl });
    executor.compile();
    executor.uploadMesh();
    executor.uploadImages();
    return executor;
  }

  /** Compiles the modules, side by side where the browser can, and finds the places of inputs. */
  compile() {
    const { gl, look } = this;
    const begun = Object.entries(look.modules).map(([name, { glsl }]) =>
      [name, this.begin(glsl.vertex, glsl.fragment)]);
    const isLinear = look.colorSpace === "linear";
    const showing = this.begin(WEBGL2_SHOWING_VERTEX, WEBGL2_SHOWING_FRAGMENT(isLinear));
    this.modules = {};
    for (const [name, program] of begun) {
      this.check(program, name);
      const module = look.modules[name];
      let [blocks, units] = [0, 0];
      const bindings = module.bindings.filter(({ kind }) => kind !== "sampler").map((binding) => {
        if (binding.kind === "uniform") {
          const index = gl.getUniformBlockIndex(program, binding.glsl.name);
          // A block that no stage reads is not there.
          if (index === gl.INVALID_INDEX) return { ...binding, isUnused: true };
          gl.uniformBlockBinding(program, index, blocks);
          return { ...binding, place: blocks++ };
        }
        gl.useProgram(program);
        gl.uniform1i(gl.getUniformLocation(program, binding.glsl.name), units);
        return { ...binding, place: units++ };
      });
      this.modules[name] = { ...module, program, bindings };
    }
    this.check(showing, "show");
    this.showing = showing;
    this.buffers = new Map();
    this.nearest = this.sampler("nearest", "clamp");
    this.nothing = gl.createVertexArray();
  }

  begin(vertex, fragment) {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    return program;
  }

  check(program, name) {
    const { gl } = this;
    if (gl.getProgramParameter(program, gl.LINK_STATUS) || gl.isContextLost()) return;
    const logs = gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader));
    const said = [...logs, gl.getProgramInfoLog(program)].filter(Boolean).join("\n");
    throw new Error(`the shader ${name} does not compile: ${said}`);
  }

  uploadMesh() {
    const { gl, mesh } = this;
    this.meshBuffers = [];
    const upload = (target, array) => {
      const buffer = gl.createBuffer();
      this.meshBuffers.push(buffer);
      gl.bindBuffer(target, buffer);
      gl.bufferData(target, array, gl.STATIC_DRAW);
      return buffer;
    };
    gl.bindVertexArray(null);
    const vertices = {};
    for (const [name, array] of Object.entries(mesh.attributes)) {
      vertices[name] = upload(gl.ARRAY_BUFFER, array);
    }
    const indices = upload(gl.ELEMENT_ARRAY_BUFFER, mesh.indices);
    for (const pass of this.look.passes) {
      const module = this.modules[pass.module];
      if (pass.draws === "screen" || module.vertices) continue;
      module.vertices = gl.createVertexArray();
      gl.bindVertexArray(module.vertices);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
      for (const { name, type, location } of module.attributes) {
        gl.bindBuffer(gl.ARRAY_BUFFER, vertices[name]);
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, Number(type[3]), gl.FLOAT, false, 0, 0);
      }
    }
    gl.bindVertexArray(null);
  }

  uploadImages() {
    this.textures = this.images.map((image, index) => this.uploadImage(image, index));
    this.samplers = this.look.images.map(({ wrap, filter }) => this.sampler(filter, wrap));
  }

  sampler(filter, wrap) {
    const { gl } = this;
    const sampler = gl.createSampler();
    const mode = { repeat: gl.REPEAT, clamp: gl.CLAMP_TO_EDGE, mirror: gl.MIRRORED_REPEAT }[wrap];
    const kind = filter === "nearest" ? gl.NEAREST : gl.LINEAR;
    gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, kind);
    gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, kind);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, mode);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, mode);
    return sampler;
  }

  uploadImage(image, index) {
    const { gl } = this;
    const { width, height, layers = 1 } = image;
    const target = image.isFlat ? gl.TEXTURE_2D : gl.TEXTURE_2D_ARRAY;
    const texture = gl.createTexture();
    gl.bindTexture(target, texture);
    // The first row of the file is the first row of the texture, with its numbers as they are.
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    const flat = isDecodedBySampling(this.look, index) ? gl.SRGB8_ALPHA8 : gl.RGBA8;
    if (image.isBlocks) {
      const blocks = gl.getExtension("EXT_texture_compression_bptc");
      if (!blocks) throw new Error("this graphics card does not read textures in BC7 blocks");
      const format = blocks.COMPRESSED_RGBA_BPTC_UNORM_EXT;
      gl.compressedTexImage3D(target, 0, format, width, height, layers, 0, image.bytes);
    } else if (image.isFlat) {
      const source = image.bitmap
        ?? new ImageData(new Uint8ClampedArray(image.bytes), width, height);
      gl.texImage2D(target, 0, flat, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, source);
    } else {
      const kind = gl.UNSIGNED_BYTE;
      gl.texImage3D(target, 0, flat, width, height, layers, 0, gl.RGBA, kind, image.bytes);
    }
    gl.texParameteri(target, gl.TEXTURE_MAX_LEVEL, 0);
    return { target, texture };
  }

  /** The textures that the passes draw into, for one size. */
  targetsOf([width, height], samples) {
    const { gl } = this;
    const made = [];
    const texture = (format) => {
      const found = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, found);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
      made.push(() => gl.deleteTexture(found));
      return found;
    };
    const renderbuffer = (format, count) => {
      const found = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, found);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, count, format, width, height);
      made.push(() => gl.deleteRenderbuffer(found));
      return found;
    };
    const framebuffer = (attach) => {
      const found = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, found);
      attach();
      if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
        throw new Error("this graphics card cannot draw what the look needs by WebGL 2");
      }
      made.push(() => gl.deleteFramebuffer(found));
      return found;
    };
    const onto = (place, kind, what) => kind === gl.TEXTURE_2D
      ? gl.framebufferTexture2D(gl.FRAMEBUFFER, place, kind, what, 0)
      : gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, kind, what);
    const found = { size: [width, height], samples, images: {}, framebuffers: {} };
    const formats = { rgba32float: gl.RGBA32F, r32float: gl.R32F };
    for (const pass of this.look.passes) {
      if (pass.name === "draw" || pass.draws === "lights") continue;
      const images = pass.outputs.map(({ name, format }) => {
        const image = texture(formats[format]);
        found.images[`${pass.name}.${name}`] = { target: gl.TEXTURE_2D, texture: image };
        return image;
      });
      const depth = pass.draws === "meshes" ? renderbuffer(gl.DEPTH_COMPONENT32F, 0) : null;
      found.framebuffers[pass.name] = framebuffer(() => {
        images.forEach((image, i) => onto(gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, image));
        gl.drawBuffers(images.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        if (depth) onto(gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
      });
    }
    found.picture = texture(gl.RGBA16F);
    const depth = renderbuffer(gl.DEPTH_COMPONENT32F, samples > 1 ? samples : 0);
    const sampled = samples > 1 ? renderbuffer(gl.RGBA16F, samples) : null;
    found.framebuffers.draw = framebuffer(() => {
      if (sampled) onto(gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, sampled);
      else onto(gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, found.picture);
      onto(gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    });
    found.resolved = sampled
      ? framebuffer(() => onto(gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, found.picture))
      : found.framebuffers.draw;
    found.destroy = () => made.forEach((free) => free());
    return found;
  }

  /** Draws all passes of a frame into `targets`. */
  run(frame, targets) {
    const { gl } = this;
    const [width, height] = frame.size;
    gl.depthFunc(gl.LESS);
    gl.depthMask(true);
    // Rows run the other way, and so do corners.
    gl.frontFace(this.mesh.isMirrored ? gl.CCW : gl.CW);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    if (frame.shadows) this.runShadows(frame);
    gl.viewport(0, 0, width, height);
    for (const pass of this.look.passes) {
      if (pass.draws !== "lights") this.runPass(pass, frame, targets);
    }
    if (targets.resolved !== targets.framebuffers.draw) {
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, targets.framebuffers.draw);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, targets.resolved);
      const box = [0, 0, width, height];
      gl.blitFramebuffer(...box, ...box, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }
  }

  /** Draws what lights see, where a light has moved since it was drawn last. */
  runShadows(frame) {
    const { gl } = this;
    const { side, layers } = frame.shadows;
    const passes = this.look.passes.filter(({ draws }) => draws === "lights");
    if (this.shadows?.side !== side || this.shadows.count !== layers.length) {
      this.shadows?.destroy();
      this.shadows = this.shadowTargets(passes, side, layers.length);
    }
    const drawn = JSON.stringify(layers);
    if (drawn === this.shadows.drawn) return;
    this.shadows.drawn = drawn;
    gl.viewport(0, 0, side, side);
    this.enable(gl.BLEND, false);
    this.enable(gl.CULL_FACE, false);
    this.enable(gl.DEPTH_TEST, true);
    for (const pass of passes) {
      const module = this.modules[pass.module];
      gl.useProgram(module.program);
      gl.bindVertexArray(module.vertices);
      layers.forEach((_, layer) => {
        this.bind(pass, module, frame, this.shadows, layer);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadows.framebuffers[pass.name][layer]);
        pass.outputs.forEach(({ clear }, i) => gl.clearBufferfv(gl.COLOR, i, clear));
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        gl.drawElements(gl.TRIANGLES, this.mesh.indices.length, gl.UNSIGNED_INT, 0);
      });
    }
  }

  /** The textures of shadow maps, with a framebuffer for each layer of each pass. */
  shadowTargets(passes, side, count) {
    const { gl } = this;
    const made = [];
    const depth = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, side, side);
    made.push(() => gl.deleteRenderbuffer(depth));
    const found = { side, count, images: {}, framebuffers: {} };
    for (const pass of passes) {
      const textures = pass.outputs.map(({ name }) => {
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
        gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA32F, side, side, Math.max(count, 2));
        found.images[`${pass.name}.${name}`] = { target: gl.TEXTURE_2D_ARRAY, texture };
        made.push(() => gl.deleteTexture(texture));
        return texture;
      });
      found.framebuffers[pass.name] = Array.from({ length: count }, (_, layer) => {
        const framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        textures.forEach((texture, i) =>
          gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, texture, 0, layer));
        gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        const kind = gl.RENDERBUFFER;
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, kind, depth);
        made.push(() => gl.deleteFramebuffer(framebuffer));
        return framebuffer;
      });
    }
    found.destroy = () => made.forEach((free) => free());
    return found;
  }

  runPass(pass, frame, targets) {
    const { gl } = this;
    const isPicture = pass.name === "draw";
    gl.bindFramebuffer(gl.FRAMEBUFFER, targets.framebuffers[pass.name]);
    this.enable(gl.BLEND, isPicture);
    this.enable(gl.DEPTH_TEST, pass.draws === "meshes");
    pass.outputs.forEach(({ clear }, i) => gl.clearBufferfv(gl.COLOR, i, clear));
    if (pass.draws === "meshes") gl.clearBufferfv(gl.DEPTH, 0, [1]);
    const module = this.modules[pass.module];
    gl.useProgram(module.program);
    if (pass.draws === "screen") {
      this.enable(gl.CULL_FACE, false);
      this.bind(pass, module, frame, targets, 0);
      gl.bindVertexArray(this.nothing);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      return;
    }
    gl.bindVertexArray(module.vertices);
    this.mesh.parts.forEach((part, number) => {
      this.enable(gl.CULL_FACE, !frame.drawsBoth(pass, part));
      this.bind(pass, module, frame, targets, number);
      gl.drawElements(gl.TRIANGLES, part.count, gl.UNSIGNED_INT, 4 * part.first);
    });
  }

  enable(what, isOn) {
    if (isOn) this.gl.enable(what);
    else this.gl.disable(what);
  }

  bind(pass, module, frame, targets, part) {
    const { gl } = this;
    for (const binding of module.bindings) {
      const { kind, feed, place } = binding;
      if (binding.isUnused) continue;
      if (kind === "uniform") {
        const buffer = this.buffer(`${pass.module} ${binding.name} ${part}`);
        gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
        const bytes = frame.bytes(pass.module, binding, part);
        gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, place, buffer);
        continue;
      }
      const isImage = feed.from === "image";
      const key = sourceOf(pass, binding);
      const source = isImage
        ? this.textures[feed.image]
        : (targets.images[key] ?? this.shadows.images[key]);
      gl.activeTexture(gl.TEXTURE0 + place);
      gl.bindTexture(source.target, source.texture);
      gl.bindSampler(place, isImage ? this.samplers[feed.image] : this.nearest);
    }
  }

  buffer(key) {
    let found = this.buffers.get(key);
    if (!found) {
      found = this.gl.createBuffer();
      this.buffers.set(key, found);
    }
    return found;
  }

  /** Draws a frame on the page. */
  show(frame) {
    const { gl } = this;
    const [width, height] = frame.size;
    const is = this.targets;
    if (!is || is.size[0] !== width || is.size[1] !== height || is.samples !== frame.samples) {
      is?.destroy();
      this.targets = this.targetsOf(frame.size, frame.samples);
    }
    this.run(frame, this.targets);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    [gl.BLEND, gl.DEPTH_TEST, gl.CULL_FACE].forEach((what) => gl.disable(what));
    gl.useProgram(this.showing);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.targets.picture);
    gl.bindSampler(0, this.nearest);
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** The numbers of a frame drawn beside the page: premultiplied RGBA, the top row first. */
  async read(frame) {
    const { gl } = this;
    const [width, height] = frame.size;
    const targets = this.targetsOf(frame.size, frame.samples);
    this.run(frame, targets);
    gl.bindFramebuffer(gl.FRAMEBUFFER, targets.resolved);
    const numbers = new Float32Array(4 * width * height);
    // By way of a buffer, so that the page need not wait for the graphics card.
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, numbers.byteLength, gl.STREAM_READ);
    // Row 0 is the top one here.
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (gl.clientWaitSync(drawn, 0, 0) === gl.TIMEOUT_EXPIRED) {
      await new Promise((resolve) => setTimeout(resolve, 4));
    }
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, numbers);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.deleteSync(drawn);
    gl.deleteBuffer(buffer);
    targets.destroy();
    return numbers;
  }

  /** Calls `then` with the reason when the graphics card is lost, once. */
  onLost(then) {
    const lost = () => this.isClosed || then("the browser took the graphics card away");
    this.canvas.addEventListener("webglcontextlost", lost, { once: true });
  }

  /** Resolves when everything is drawn that was asked for. */
  async finished() {
    const { gl } = this;
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (!this.isClosed && gl.clientWaitSync(drawn, 0, 0) === gl.TIMEOUT_EXPIRED) {
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    gl.deleteSync(drawn);
  }

  /** Draws another mesh with the same attributes from now on. */
  replaceMesh(mesh) {
    for (const module of Object.values(this.modules)) {
      if (module.vertices) this.gl.deleteVertexArray(module.vertices);
      module.vertices = null;
    }
    this.meshBuffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
    this.mesh = mesh;
    this.uploadMesh();
    this.shadows?.destroy();
    this.shadows = null;
  }

  destroy() {
    this.isClosed = true;
    this.targets?.destroy();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}

// What a program sets, checked where it arrives: a wrong value is refused with the form that is
// taken, and the picture stays as it was.

/** Fields of a light that may be set, with the count of their numbers. */
const LIGHT_FIELDS = {
  direction: 3, position: 3, aim: 3, color: 3,
  intensity: 1, inner: 1, outer: 1, half_distance: 1, range: 1,
};

/** Rounding that a bound forgives: π has more digits than people write. */
const FORGIVEN = 1e-4;

const HEX = /^#([0-9a-f]{3}|[0-9a-f]{6}|[0-9a-f]{8})$/i;

/** `#rrggbb` or `#rrggbbaa`, also of `#rgb`; `undefined` for another text. */
function wholeHex(text) {
  if (!HEX.test(text)) return undefined;
  const digits = text.slice(1).toLowerCase();
  return `#${digits.length === 3 ? [...digits].map((digit) => digit + digit).join("") : digits}`;
}

/** Finite numbers of an array; `undefined` for anything else. */
function finiteNumbers(value) {
  if (!Array.isArray(value) && !ArrayBuffer.isView(value)) return undefined;
  const numbers = Array.from(value);
  return numbers.every(Number.isFinite) ? numbers : undefined;
}

function refuse(name, form, value) {
  const given = typeof value === "string" ? `"${value}"` : JSON.stringify(value) ?? String(value);
  throw new TypeError(`${name} is ${form}, not ${Number.isNaN(value) ? "NaN" : given}`);
}

/** The words for a number between the bounds that it has. */
function numberForm({ type, min, max, unit }) {
  const kind = type === "int" ? "a whole number" : "a number";
  const from = min === undefined ? "" : ` from ${shortDigits(min)}`;
  const to = max === undefined ? "" : ` to ${shortDigits(max)}`;
  return `${kind}${from}${to}${unit === "rad" ? " (radians)" : ""}`;
}

const shortDigits = (x) => String(Number(x.toPrecision(5)));

/** The value of a parameter as the player keeps it; throws a `TypeError` for a wrong one. */
function checkedValue(parameter, value) {
  const { key, type, options, min = -Infinity, max = Infinity } = parameter;
  if (!parameter.live) {
    throw new TypeError(`${key} cannot be set: it was decided when the look was exported`);
  }
  if (options?.length) {
    const words = options.map((word) => `"${word}"`).join(", ");
    return options.includes(value) ? value : refuse(key, `one of ${words}`, value);
  }
  switch (type) {
    case "float":
    case "int": {
      const isRight = Number.isFinite(value) && (type === "float" || Number.isInteger(value))
        && value >= min - FORGIVEN && value <= max + FORGIVEN;
      return isRight ? clamp(value, min, max) : refuse(key, numberForm(parameter), value);
    }
    case "bool":
    case "switch":
      return typeof value === "boolean" ? value : refuse(key, "true or false", value);
    case "color": {
      const numbers = finiteNumbers(value);
      const isRight = numbers?.length === 3 || numbers?.length === 4;
      const found = typeof value === "string" ? wholeHex(value) : isRight && numbers;
      return found || refuse(key, 'a color: "#rrggbb", or three or four numbers', value);
    }
    default: {
      const count = Number(/^vec([234])$/.exec(type)?.[1]);
      if (!count) return value;
      const numbers = finiteNumbers(value);
      return numbers?.length === count ? numbers : refuse(key, `${count} numbers`, value);
    }
  }
}

/** Fields of a light as the player keeps them; `decoded` has the numbers of a hex color. */
function checkedFields(light, fields, decoded) {
  const known = Object.keys(LIGHT_FIELDS).filter((field) => field in light);
  return Object.fromEntries(Object.entries(fields).map(([field, value]) => {
    const name = `${field} of the light ${light.id}`;
    if (!known.includes(field)) {
      throw new TypeError(`the light ${light.id} has no ${field}; it has: ${known.join(", ")}`);
    }
    const count = LIGHT_FIELDS[field];
    if (count === 1) {
      const isRight = Number.isFinite(value) && value >= 0;
      return [field, isRight ? value : refuse(name, "a number from 0", value)];
    }
    if (field === "color" && typeof value === "string") {
      const hex = wholeHex(value) ?? refuse(name, '"#rrggbb" or three numbers', value);
      return [field, decoded(hex).slice(0, 3)];
    }
    const numbers = finiteNumbers(value);
    const isRight = numbers?.length === 3 && (field !== "direction" || numbers.some(Boolean));
    const form = field === "direction" ? "three numbers, not all 0" : "three numbers";
    return [field, isRight ? numbers : refuse(name, form, value)];
  }));
}

/** The parts of an export, each of which must be the one that its script defines. */
function checkContent({ look, scene, textures } = {}) {
  const wrong = (name, file) =>
    new Error(`${name} is not that of an export of Chiaro: is its script ${file} loaded?`);
  if (!look?.modules || !look.passes) throw wrong("look", "LOOK.js");
  if (!scene?.mesh?.attributes || !scene.camera) throw wrong("scene", "scene.js");
  if (look.images.some(({ file }) => file) && !textures) throw wrong("textures", "textures.js");
}

// The player: draws a look on a canvas, and draws again when something has changed. A page at rest
// costs nothing.

/** True for an image whose numbers the sampler turns into linear light. */
const isDecodedBySampling = (look, index) =>
  look.colorSpace === "linear" && look.images[index].encoding === "color"
  && look.images[index].kind !== "hcbtf";

/** Executors, in the order in which they are tried. */
const EXECUTORS = { webgpu: WebGpuExecutor, webgl2: WebGl2Executor };

/** The most device pixels for a pixel of the page. */
const MOST_PIXELS = 2;

/** The longest side of the picture on the page, in device pixels. */
const MOST_SIDE = 4096;

/** A device that is lost within this time, in milliseconds, had not drawn well at all. */
const EARLY = 5000;

/** Frames that take longer than this, in milliseconds, are drawn coarser while things move. */
const SLOW = 50;

/** Time without a change, in milliseconds, after which the picture is drawn finely again. */
const REST = 200;

/** The canvas that events and styles are given to; a new one where another API has taken it. */
function freshCanvas(canvas) {
  const fresh = canvas.cloneNode(false);
  canvas.replaceWith(fresh);
  return fresh;
}

class Player extends EventTarget {
  /**
   * Draws a look on a canvas. Rejects, with the reason in words, where that cannot be.
   *
   * @param canvas a canvas of the page; a fresh one takes its place where an API fails on it.
   * @param content `look`, `scene` and `textures`, as the package's scripts define them.
   * @param options `api`: `webgpu` or `webgl2`, else the first that works. `samples`: 1, or 4 for
   *   smooth edges.
   */
  static async open(canvas, content, { api, samples = 4 } = {}) {
    checkContent(content);
    const { look, scene, textures = {} } = content;
    const player = new Player();
    const images = await readImages(look, textures);
    const mesh = readMesh(scene.mesh);
    mesh.isMirrored = determinant3(linear3(mesh.worldFromObject)) < 0;
    Object.assign(player, { canvas, look, scene, mesh, samples });
    player.content = { look, mesh, images, samples };
    player.camera = { ...scene.camera };
    player.reset();
    const wanted = api?.toLowerCase();
    if (wanted && !EXECUTORS[wanted]) throw new Error(`api is "webgpu" or "webgl2", not "${api}"`);
    player.failures = [];
    await player.begin(wanted ? [wanted] : Object.keys(EXECUTORS));
    player.watchSize();
    return player;
  }

  /** Draws by the first of some APIs that works; a canvas that one has failed on is replaced. */
  async begin(names) {
    for (const [at, name] of names.entries()) {
      if (this.failures.length) this.canvas = freshCanvas(this.canvas);
      try {
        this.executor = await EXECUTORS[name].create(this.canvas, this.content);
        this.begun = performance.now();
        this.executor.onLost((reason) => this.recover(reason, names.slice(at + 1)));
        return;
      } catch (failure) {
        this.failures.push(`${name}: ${failure.message}`);
      }
    }
    throw new Error(this.failures.join("; "));
  }

  /** Goes on by another API where the first was lost at once; tells of it where none is left. */
  async recover(reason, others) {
    const { executor } = this;
    if (!executor) return;
    this.executor = null;
    const told = reason || "the graphics card was lost";
    try {
      if (!others.length || performance.now() - this.begun > EARLY) throw new Error(told);
      this.failures.push(`${executor.label}: ${told}`);
      await this.begin(others);
      this.sizes.disconnect();
      this.watchSize();
      this.gestures?.listen();
      this.isDrawing = false;
      this.draw();
      this.tell("api");
    } catch (failure) {
      this.isPlaying = false;
      this.tell("lost", failure.message);
    }
  }

  /** Name of the API that draws: `WebGPU` or `WebGL 2`. */
  get api() {
    return this.executor?.label;
  }

  // Values.

  /** Sets an exposed parameter by the name that the artist gave it. */
  set(key, value) {
    const parameter = this.parameter(key);
    const checked = checkedValue(parameter, value);
    // Keys move a value only while it is not set.
    if (!parameter.keyed && this.isSame(parameter, checked)) delete this.values[key];
    else this.values[key] = checked;
    this.invalidate();
    this.tell("value", key);
  }

  /** The value of an exposed parameter. */
  get(key) {
    const parameter = this.parameter(key);
    return key in this.values ? this.values[key] : parameter.default;
  }

  parameter(key) {
    const found = this.look.parameters.find((one) => one.key === key);
    if (found) return found;
    const known = this.look.parameters.map((one) => one.key).join(", ");
    throw new Error(`there is no parameter ${key}; there are: ${known || "none"}`);
  }

  /** True for the value that a parameter has in the look. */
  isSame({ type, default: own }, value) {
    if (type === "color") {
      return this.hexOf(value) === this.hexOf(own) && this.isAsOpaque(value, own);
    }
    return String(value) === String(own);
  }

  /** True for colors of the same alpha. */
  isAsOpaque(...colors) {
    const alphaOf = (color) =>
      typeof color === "string" ? colorFromHex(color)[3] : (color[3] ?? 1);
    const [first, second] = colors.map(alphaOf);
    return Math.abs(first - second) < 1 / 512;
  }

  /** Sets fields of a light, in its own frame: `direction`, `position`, `color`, `intensity`... */
  light(id, fields) {
    const light = this.look.lights.find((one) => one.id === id);
    if (!light) {
      const known = this.look.lights.map((one) => one.id).join(", ");
      throw new Error(`there is no light ${id}; there are: ${known || "none"}`);
    }
    const checked = checkedFields(light, fields, (hex) => this.numbersOfHex(hex));
    this.lights[id] = { ...this.lights[id], ...checked };
    this.invalidate();
    this.tell("light", id);
  }

  /** A light as it is now: with the look's values, those of parameters, and those that are set. */
  lightNow(id) {
    return lightNow(this.look, { parameters: this.values, lights: this.lights }, id);
  }

  /** Gives everything, or one parameter, the value that it has in the look. The view stays. */
  reset(key) {
    if (key !== undefined) {
      this.get(key);
      delete this.values[key];
      this.tell("value", key);
    } else {
      this.values = {};
      this.lights = {};
      this.illumination = [...this.scene.illumination];
      this.time = 0;
      this.tell("reset");
    }
    this.invalidate();
  }

  /** Gives a light the values that it has in the look. */
  resetLight(id) {
    delete this.lights[id];
    this.invalidate();
    this.tell("light", id);
  }

  /** Turns all lights back, which were turned together. */
  resetIllumination() {
    this.illumination = [...this.scene.illumination];
    this.invalidate();
    this.tell("view");
  }

  /** True while everything is as the look has it, but for the view. */
  get isUntouched() {
    const isTurned = this.illumination.some((x, i) => x !== this.scene.illumination[i]);
    return !isTurned && ![this.values, this.lights].some((set) => Object.keys(set).length);
  }

  /** `#rrggbb` of a color of the look, or of one that is written so already. */
  hexOf(color) {
    if (typeof color === "string") return color.slice(0, 7);
    return hexFromColor(this.look.colorSpace === "linear" ? color.map(encode) : color);
  }

  /** The numbers of a color that is written as `#rrggbb`, in the look's own space. */
  numbersOfHex(hex) {
    const [r, g, b, a] = colorFromHex(hex);
    return this.look.colorSpace === "linear" ? [decode(r), decode(g), decode(b), a] : [r, g, b, a];
  }

  /** True where the picture changes with time. */
  get isAnimated() {
    const bytes = (time) => {
      const now = this.state(this.view([64, 64]), [64, 64]);
      const state = { ...now, time, frame: Math.floor(time * 24) };
      return Object.values(this.look.modules).flatMap(({ prepare }) =>
        prepare ? [...new Uint8Array(prepare(state))] : []);
    };
    const [first, ...others] = [0, 0.37, 1.9, 7.3].map((time) => String(bytes(time)));
    return others.some((other) => other !== first);
  }

  // Frames.

  view(size, camera = this.camera) {
    const clip = this.executor?.clip ?? { near: 0, far: 1 };
    return viewOf(camera, size, this.mesh.sphere, clip);
  }

  /** The shadow maps of a picture; `null` for a look that asks for none. */
  shadows(view, size) {
    if (!this.look.passes.some(({ draws }) => draws === "lights")) return null;
    const state = this.state(view, size);
    return shadowMaps(this.look, state, this.mesh.sphere, size[1], this.executor.clip);
  }

  /** The middle of the mesh's box, in world space. */
  get middle() {
    return transformPoint(this.mesh.worldFromObject, this.mesh.middle);
  }

  /** What `prepare` of the look asks for. */
  state(view, size, shadows) {
    const lights = { ...this.lights };
    for (const [id, place] of Object.entries(shadows?.places ?? {})) {
      lights[id] = { ...lights[id], shadow_map: place };
    }
    const parameters = Object.fromEntries(this.look.parameters.map(({ key, type }) => {
      const value = this.get(key);
      const isHex = type === "color" && typeof value === "string";
      return [key, isHex ? this.numbersOfHex(value) : value];
    }));
    const { rotation, eye, parallel, toward } = view;
    return {
      parameters,
      lights,
      illumination: this.illumination,
      camera: { rotation, eye, parallel, toward },
      object: {
        id: 0,
        axes: objectAxes(this.mesh.worldFromObject),
        middle: this.middle,
      },
      viewport: size,
      time: this.time,
      frame: Math.floor(24 * this.time),
    };
  }

  /** Everything that an executor asks for while it draws. */
  frame(size, samples, camera) {
    const view = this.view(size, camera);
    const shadows = this.shadows(view, size);
    const state = this.state(view, size, shadows);
    const looks = new Map();
    const lookBytes = (module) => {
      if (!looks.has(module)) looks.set(module, this.look.modules[module].prepare(state));
      return looks.get(module);
    };
    // `number` is that of a part of the mesh, or of a layer of shadow maps.
    const objectBytes = (binding, number) =>
      pack(binding, objectValues(this.mesh, this.mesh.parts[number].material));
    const bytes = (module, binding, number) => {
      switch (binding.feed.from) {
        case "look": return lookBytes(module);
        case "view": return pack(binding, viewValues(view));
        case "object": return objectBytes(binding, number);
        case "light_layer": return pack(binding, shadows.layers[number]);
        case "light_caster": return pack(binding, casterValues(this.mesh));
        default: return pack(binding, numbersOf(view, size, samples));
      }
    };
    const { center, radius } = this.mesh.sphere;
    const isWithin = length(subtract(view.eye, center)) < radius;
    const drawsBoth = (pass, part) => part.twoSided || isWithin || this.cuts(pass, state);
    return { size, samples, bytes, drawsBoth, shadows };
  }

  /** True where the look cuts parts away, so that backs are seen through them. */
  cuts(pass, state) {
    const by = pass.sides_parameter;
    const key = typeof by === "number" ? this.look.parameters[by]?.key : by;
    return key === undefined || key === null
      ? pass.sides === "both"
      : Number(state.parameters[key]) > 0;
  }

  /** Has the page drawn again before it is shown next, or once the frame before is done. */
  invalidate() {
    this.changed = performance.now();
    this.schedule();
  }

  /** Asks for the next frame. */
  schedule() {
    if (!this.executor || this.awaited) return;
    if (this.isDrawing) {
      this.isBehind = true;
      return;
    }
    this.awaited = requestAnimationFrame((now) => {
      this.awaited = 0;
      if (this.isPlaying) {
        this.time += Math.min((now - (this.last ?? now)) / 1000, 0.1);
        this.last = now;
        this.invalidate();
      }
      this.draw();
    });
  }

  play(isPlaying) {
    this.isPlaying = isPlaying;
    this.last = undefined;
    this.invalidate();
  }

  /** The camera of the page: a page that is higher than wide shows as much in width. */
  get pageCamera() {
    return { ...this.camera, aspect: this.camera.aspect || 1 };
  }

  draw() {
    if (!this.executor) return;
    if (this.isDrawing) {
      this.isBehind = true;
      return;
    }
    clearTimeout(this.resting);
    // What is slow is drawn with half the width and height while it moves.
    const isMoving = this.isPlaying || performance.now() - this.changed < REST;
    const isCoarse = this.slowness > SLOW && isMoving;
    const size = this.pageSize.map((side) => (isCoarse ? Math.ceil(side / 2) : side));
    if (!size[0] || !size[1]) return;
    if (size[0] !== this.canvas.width || size[1] !== this.canvas.height) {
      [this.canvas.width, this.canvas.height] = size;
    }
    try {
      this.executor.show(this.frame(size, this.samples, this.pageCamera));
      this.drawn = (this.drawn ?? 0) + 1;
      this.tell("drawn");
    } catch (failure) {
      this.isPlaying = false;
      this.tell("lost", failure.message);
      return;
    }
    this.isDrawing = true;
    const begun = performance.now();
    const { executor } = this;
    executor.finished().then(() => {
      if (executor !== this.executor) return;
      this.isDrawing = false;
      // The first frame counts little: drivers finish shaders during it.
      if (!isCoarse && this.drawn > 1) this.slowness = performance.now() - begun;
      if (this.isBehind) {
        this.isBehind = false;
        this.schedule();
      } else if (isCoarse) {
        this.resting = setTimeout(() => this.draw(), REST);
      }
    }, () => (this.isDrawing = false));
  }

  /**
   * The picture at another size, as `ImageData`: straight RGBA of 8 bits, the top row first,
   * transparent where nothing is.
   *
   * @param options `camera`, else the page's; `samples`, 1 or 4, else the page's.
   */
  async picture(width, height, { camera, samples = this.samples } = {}) {
    const whole = { ...this.camera, ...camera };
    const numbers = await this.executor.read(this.frame([width, height], samples, whole));
    const isLinear = this.look.colorSpace === "linear";
    const pixels = new Uint8ClampedArray(numbers.length);
    for (let at = 0; at < numbers.length; at += 4) {
      const alpha = numbers[at + 3];
      for (let i = 0; i < 3; i++) {
        const straight = alpha > 0 ? numbers[at + i] / alpha : 0;
        const shown = isLinear ? encode(Math.max(straight, 0)) : straight;
        pixels[at + i] = Math.floor(255 * clamp(shown, 0, 1) + 0.5);
      }
      pixels[at + 3] = Math.floor(255 * clamp(alpha, 0, 1) + 0.5);
    }
    return new ImageData(pixels, width, height);
  }

  /** Width and height of the picture on the page, in device pixels. */
  get pageSize() {
    const pixels = Math.min(devicePixelRatio || 1, MOST_PIXELS);
    const { clientWidth, clientHeight } = this.canvas;
    const sideOf = (side) => Math.min(Math.round(side * pixels), MOST_SIDE);
    return [clientWidth, clientHeight].map(sideOf);
  }

  /** The numbers of the picture with other values of parameters: a few pixels, to compare. */
  trial(values, side) {
    const own = this.values;
    this.values = { ...own, ...values };
    try {
      // Everything is asked for before the first wait.
      return this.executor.read(this.frame([side, side], 1, this.pageCamera));
    } finally {
      this.values = own;
    }
  }

  /** Draws again, at the right size, when the canvas has another one. */
  watchSize() {
    this.sizes = new ResizeObserver(() => {
      const [width, height] = this.pageSize;
      if (width !== this.canvas.width || height !== this.canvas.height) this.draw();
    });
    this.sizes.observe(this.canvas);
  }

  /**
   * Shows the look on a mesh of the page's own, brought to the size and the place of the first
   * one: `positions`, `indices`, `normals`, `uvs`, as arrays of numbers.
   */
  wear(given) {
    const wanted = Object.keys(this.mesh.attributes);
    const mesh = { ...meshOf(given, wanted, this.mesh.sphere), isMirrored: false };
    this.mesh = mesh;
    this.content.mesh = mesh;
    this.executor?.replaceMesh(mesh);
    this.invalidate();
    this.tell("mesh");
  }

  /** Tells listeners of `value`, `light`, `view`, `reset`, `mesh`, `drawn`, `api` or `lost`. */
  tell(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  /** Frees the graphics card. */
  close() {
    cancelAnimationFrame(this.awaited);
    clearTimeout(this.resting);
    this.sizes?.disconnect();
    this.gestures?.close();
    this.executor?.destroy();
    this.executor = null;
  }
}

// Gestures on the canvas: drags turn the view or a light, the wheel and two fingers go nearer.

/** Turn for a drag over the height of the canvas, in radians. */
const TURN = Math.PI;

/** Turn, and step nearer, for an arrow key. */
const STEP = { turn: Math.PI / 36, nearer: 1.08 };

class Gestures {
  /** Drags turn what `subject` names: `"view"`, `"lights"`, or the id of a light. */
  subject = "view";

  /**
   * @param wheel who may turn the wheel to come nearer: `true`, whoever is over the canvas;
   *   `"focus"`, whoever has clicked it; `"ctrl"`, whoever holds Ctrl; `false`, nobody. Otherwise
   *   the page scrolls.
   */
  constructor(player, { wheel = true } = {}) {
    if (![true, false, "focus", "ctrl"].includes(wheel)) {
      throw new Error(`wheel is true, false, "focus" or "ctrl", not ${JSON.stringify(wheel)}`);
    }
    this.player = player;
    this.wheelFor = wheel;
    this.listen();
  }

  /** Hears what happens on the player's canvas, which can be reached by the keyboard. */
  listen() {
    this.close();
    this.pointers = new Map();
    this.closing = new AbortController();
    const { canvas, look } = this.player;
    const { signal } = this.closing;
    const listen = (type, listener) =>
      canvas.addEventListener(type, listener, { passive: false, signal });
    listen("pointerdown", (event) => this.down(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.up(event));
    listen("pointercancel", (event) => this.up(event));
    listen("wheel", (event) => this.wheel(event));
    listen("keydown", (event) => this.key(event));
    listen("dblclick", () => this.resetView());
    listen("contextmenu", (event) => event.preventDefault());
    // A browser that scrolls by the same finger would break the drag off.
    canvas.style.touchAction = "none";
    if (!canvas.hasAttribute("tabindex")) canvas.tabIndex = 0;
    if (!canvas.hasAttribute("role")) canvas.setAttribute("role", "application");
    if (!canvas.hasAttribute("aria-label")) {
      const keys = "Arrow keys turn it, plus and minus go nearer, Home resets the view.";
      canvas.setAttribute("aria-label", `${look.name}: a picture that can be turned. ${keys}`);
    }
  }

  /** Hears nothing any more. */
  close() {
    this.closing?.abort();
  }

  down(event) {
    this.player.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  up(event) {
    this.pointers.delete(event.pointerId);
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const height = Math.max(this.player.canvas.clientHeight, 1);
    const [x, y] = subtract(now, before).map((way) => way / height);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers.set(event.pointerId, now);
    if (other) {
      // Two fingers: as near as they are apart, and sideways with their middle.
      const apart = (point) => Math.max(length(subtract(point, other)), 1);
      this.nearer(apart(before) / apart(now));
      this.pan(x / 2, y / 2);
    } else if (event.buttons & 6) {
      this.pan(x, y);
    } else {
      this.turn(x * TURN, y * TURN, event.shiftKey ? "lights" : this.subject);
    }
  }

  wheel(event) {
    const isOn = {
      ctrl: event.ctrlKey || event.metaKey,
      focus: document.activeElement === this.player.canvas,
    };
    if (!(isOn[this.wheelFor] ?? this.wheelFor)) return;
    event.preventDefault();
    const lines = event.deltaMode === 0 ? event.deltaY / 100 : event.deltaY / 3;
    this.nearer(1.15 ** clamp(lines, -3, 3));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const subject = event.shiftKey ? "lights" : this.subject;
    const steps = {
      ArrowLeft: () => this.turn(-STEP.turn, 0, subject),
      ArrowRight: () => this.turn(STEP.turn, 0, subject),
      ArrowUp: () => this.turn(0, -STEP.turn, subject),
      ArrowDown: () => this.turn(0, STEP.turn, subject),
      "+": () => this.nearer(1 / STEP.nearer),
      "=": () => this.nearer(1 / STEP.nearer),
      "-": () => this.nearer(STEP.nearer),
      Home: () => this.resetView(),
    };
    if (!steps[event.key]) return;
    event.preventDefault();
    steps[event.key]();
  }

  /** Turns the view, all lights or one light, to the right and down, in radians. */
  turn(right, down, subject) {
    const { player } = this;
    if (subject === "view") {
      player.camera = orbit(player.camera, -right, down);
    } else {
      const view = player.view([1, 1]);
      const [x, y] = columns3(transpose3(view.rotation));
      // What is dragged lies on the near side, and follows the pointer.
      const turned = multiply3(rotation3(y, right), rotation3(x, down));
      if (subject === "lights") {
        player.illumination = multiply3(turned, player.illumination);
      } else {
        this.turnLight(subject, turned, view);
      }
    }
    player.invalidate();
    player.tell("view");
  }

  turnLight(id, turned, view) {
    const { player } = this;
    const light = player.lightNow(id);
    const { rotation: worldFromOwn } = lightFrame(light.space, player.state(view, [1, 1]));
    const ownTurn = multiply3(transpose3(worldFromOwn), multiply3(turned, worldFromOwn));
    if (light.type === "directional") {
      player.light(id, { direction: turn(ownTurn, normalize(light.direction)) });
    } else {
      player.light(id, { position: turn(ownTurn, light.position), aim: turn(ownTurn, light.aim) });
    }
  }

  nearer(factor) {
    const { player } = this;
    const { radius } = player.mesh.sphere;
    player.camera = dolly(player.camera, factor, 0.2 * radius, 40 * radius);
    player.invalidate();
    player.tell("view");
  }

  pan(x, y) {
    const { player } = this;
    player.camera = pan(player.camera, x, y);
    player.invalidate();
    player.tell("view");
  }

  resetView() {
    const { player } = this;
    player.camera = { ...player.scene.camera };
    player.invalidate();
    player.tell("view");
  }
}

// What pages use: `chiaro.open` for a player of one's own, and the rest for the first player of the
// page.

const opening = Promise.withResolvers?.() ?? {};
opening.promise ??= new Promise((resolve, reject) => Object.assign(opening, { resolve, reject }));
// Who awaits `ready` is told of a failure; the page tells it anyway.
opening.promise.catch(() => {});

/** The first player of the page. */
let first = null;

const player = () => {
  if (!first) throw new Error("nothing is drawn yet: await chiaro.ready");
  return first;
};

window.chiaro = {
  /** The first player of the page, as soon as it draws; rejects where it cannot. */
  ready: opening.promise,

  /** The first player of the page, once it draws. */
  get player() {
    return player();
  },

  /**
   * Draws an export on a canvas: `await chiaro.open(canvas, chiaroExports["clay"])`. The result
   * has the methods below.
   *
   * @param options `api` and `samples`, as the player takes them; `gestures`: `false` for a
   *   canvas that is not dragged; `wheel`: `true`, `"focus"`, `"ctrl"` or `false`.
   */
  async open(canvas, content, options = {}) {
    try {
      const found = await Player.open(canvas, content, options);
      if (options.gestures !== false) found.gestures = new Gestures(found, options);
      found.draw();
      first ??= found;
      opening.resolve(found);
      return found;
    } catch (failure) {
      opening.reject(failure);
      throw failure;
    }
  },

  /** Sets an exposed parameter: `chiaro.set("warmth", 0.3)`. */
  set: (key, value) => player().set(key, value),

  /** The value of an exposed parameter. */
  get: (key) => player().get(key),

  /** Sets fields of a light, in its own frame: `chiaro.light("key", { intensity: 2 })`. */
  light: (id, fields) => player().light(id, fields),

  /** Gives a light the values that it has in the look. */
  resetLight: (id) => player().resetLight(id),

  /** Shows the look on a mesh of the page's own: arrays of `positions`, `indices`, `normals`... */
  wear: (mesh) => player().wear(mesh),

  /** Gives everything, or one parameter, the value that it has in the look. */
  reset: (key) => player().reset(key),

  /** The picture at any size, as `ImageData`: `await chiaro.picture(1920, 1080)`. */
  picture: (width, height, options) => player().picture(width, height, options),
};
})();
