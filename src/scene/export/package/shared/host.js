// Takes what is set from outside, or what the look has where nothing is set.

// A number, or the first of several.
const number_of = (given, own) => {
  const value = Number(Array.isArray(given) ? given[0] : (given ?? own));
  return Number.isFinite(value) ? value : own;
};

const truth_of = (given, own) => (given === undefined || given === null ? own : Boolean(given));

// A vector. A number fills it; a color of three numbers is opaque.
const vector_of = (given, own, is_color = false) => {
  if (given === undefined || given === null) return own;
  if (!Array.isArray(given) && !ArrayBuffer.isView(given)) {
    const value = number_of(given, 0);
    return own.map((_, i) => (is_color && i === 3 ? 1 : value));
  }
  const numbers = Array.from(given);
  if (is_color && own.length === 4 && numbers.length === 3) numbers.push(1);
  return own.map((value, i) => number_of(numbers[i], value));
};

// Columns of three numbers, from nine in a row.
const matrix_of = (given) => {
  const m = given ?? [1, 0, 0, 0, 1, 0, 0, 0, 1];
  return [0, 3, 6].map((at) => [m[at], m[at + 1], m[at + 2]]);
};

// A light: what later ones of `given` set, and what the look has.
const light_of = (own, ...given) => {
  const set = Object.assign({}, ...given);
  const place = set.aimed_at_place;
  return {
    direction: vector_of(set.direction, own.direction),
    position: vector_of(set.position, own.position),
    aim: vector_of(set.aim, own.aim),
    color: vector_of(set.color, own.color),
    intensity: number_of(set.intensity, own.intensity),
    inner: number_of(set.inner, own.inner),
    outer: number_of(set.outer, own.outer),
    half_distance: number_of(set.half_distance, own.half_distance),
    range: number_of(set.range, own.range),
    aimed_at: place ? [...place, 1] : [0, 0, 0, 0],
    shadow_map: vector_of(set.shadow_map, [0, 0, 1, -1]),
  };
};

// What surrounds the object, of a state.
const surroundings_of = (state) => {
  const { camera = {}, object = {} } = state;
  const near = object.near ?? {};
  return {
    illumination: matrix_of(state.illumination),
    camera_from_world: matrix_of(camera.rotation),
    eye: vector_of(camera.eye, [0, 0, 1]),
    parallel: camera.parallel ? vector_of(camera.toward, [0, 0, 1]) : [0, 0, 0],
    object_axes: matrix_of(object.axes),
    object_middle: vector_of(object.middle, [0, 0, 0]),
    object_id: number_of(object.id, 0),
    viewport: vector_of(state.viewport, [1, 1]),
    time: number_of(state.time, 0),
    frame: number_of(state.frame, 0),
    near,
  };
};

// Numbers as the bytes of a uniform: floats of 32 bits, integers where `integers` says.
const bytes_of = (numbers, integers) => {
  const most = 3.4028234663852886e38;
  const floats = new Float32Array(numbers.length);
  numbers.forEach((x, i) => {
    floats[i] = Number.isNaN(x) ? 0 : Math.min(Math.max(x, -most), most);
  });
  const words = new Int32Array(floats.buffer);
  for (const i of integers) words[i] = numbers[i];
  return floats.buffer;
};
