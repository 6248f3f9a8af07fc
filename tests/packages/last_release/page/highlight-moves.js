// A highlight, moved: made by Chiaro 0.1.0, JavaScript.
// Shaders, parameters, lights, passes and host work of the look.

((window.chiaroExports ??= {})["highlight-moves"] ??= {}).look = (() => {
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

  const DIRECTIONAL_LIGHT = 0;
  const PI_HOST = 3.141592653589793;
  const SPOT_LIGHT = 2;

  const max = (a, b) => (a < b || a !== a ? b : a);
  const min = (a, b) => (b < a || a !== a ? b : a);
  const clamp = (x, low, high) => min(max(x, low), high);
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const length = (a) => Math.sqrt(dot(a, a));
  const matrix_times_vector = (m, v) =>
    m[0].map((_, row) => m.reduce((sum, column, i) => sum + column[row] * v[i], 0));
  const transpose = (m) => m[0].map((_, row) => m.map((column) => column[row]));
  const vector_add = (a, b) => a.map((x, i) => x + b[i]);
  const vector_divide = (a, b) => a.map((x, i) => x / b[i]);
  const vector_multiply = (a, b) => a.map((x, i) => x * b[i]);
  const vector_negate = (a) => a.map((x) => -x);
  const vector_subtract = (a, b) => a.map((x, i) => x - b[i]);

  // The vector at length 1, or another where it has no length.
  function unit_or(v, otherwise) {
    const all_ = length(v);
    let value = false;
    if (all_ > 0) {
      value = all_ < 1e38;
    } else {
      value = false;
    }
    if (value) {
      return vector_divide(v, [all_, all_, all_]);
    }
    return otherwise;
  }

  // The number within bounds; 0 for what is none.
  function bounded_number(x, least, greatest) {
    if (x !== x) {
      return 0;
    }
    return clamp(x, least, greatest);
  }

  // A distance of a light: 0 or at least 1e-30.
  function bounded_distance(x) {
    if (x > 0) {
      return clamp(x, 1e-30, 3.4028234663852886e38);
    }
    return 0;
  }

  function bounded_color(color) {
    return [bounded_number(color[0], -1000000, 1000000), bounded_number(color[1], -1000000, 1000000), bounded_number(color[2], -1000000, 1000000)];
  }

  // The light in the world.
  function light_in_world(light, frame, kind) {
    const forward = [0, 0, 1];
    const position = vector_add(frame.origin, matrix_times_vector(frame.world_from_own, light.position));
    const own_from_world = transpose(frame.world_from_own);
    let direction = matrix_times_vector(frame.world_from_own, unit_or(light.direction, forward));
    let own_direction = unit_or(light.direction, forward);
    let aim = matrix_times_vector(frame.world_from_own, unit_or(light.aim, forward));
    const way = vector_subtract([light.aimed_at[0], light.aimed_at[1], light.aimed_at[2]], position);
    let value = false;
    if (light.aimed_at[3] > 0) {
      value = length(way) > 0;
    } else {
      value = false;
    }
    if (value) {
      const toward = unit_or(way, forward);
      if (kind === DIRECTIONAL_LIGHT) {
        direction = vector_negate(toward);
        own_direction = matrix_times_vector(own_from_world, direction);
      }
      if (kind === SPOT_LIGHT) {
        aim = toward;
      }
    }
    const outer = bounded_number(light.outer, 0, PI_HOST);
    const inner = min(bounded_number(light.inner, 0, PI_HOST), outer);
    return { direction, own_direction, position, aim, color: bounded_color(light.color), intensity: bounded_number(light.intensity, 0, 1e30), cone: [Math.cos(inner), Math.cos(outer)], half_distance: bounded_distance(light.half_distance), range: bounded_distance(light.range), own_from_world, shadow_map: light.shadow_map };
  }

  // A share (an opacity, a mask) clamped to [0, 1]: beyond, a mix would go past what it mixes.
  function unit_share(share) {
    return clamp(share, 0, 1);
  }

  // `color` with its alpha clamped to [0, 1].
  function with_unit_alpha(color) {
    const value = [color[0], color[1], color[2]];
    return [value[0], value[1], value[2], unit_share(color[3])];
  }

  // Premultiplied RGBA of a straight color.
  function premultiplied(color) {
    const value = color[3];
    const value_ = vector_multiply([color[0], color[1], color[2]], [value, value, value]);
    return [value_[0], value_[1], value_[2], color[3]];
  }

  // Base
  function base(color) {
    return premultiplied(color);
  }

  // Light
  function light_directional(direction, own_direction, color, intensity) {
    return { direction, own_direction, color, intensity };
  }

  // Numbers of the uniform of `draw`, one for each four bytes.
  function draw_numbers(settings, around) {
    const back_light = light_in_world(settings.back_light, { world_from_own: around.illumination, origin: [0, 0, 0] }, DIRECTIONAL_LIGHT);
    const back = light_directional(back_light.direction, back_light.own_direction, back_light.color, back_light.intensity);
    const key_light = light_in_world(settings.key_light, { world_from_own: around.illumination, origin: [0, 0, 0] }, DIRECTIONAL_LIGHT);
    const key = light_directional(key_light.direction, key_light.own_direction, key_light.color, key_light.intensity);
    const value_19 = with_unit_alpha(settings.color);
    const body = base(value_19);
    let numbers = Array(36).fill(0);
    numbers[0] = back.direction[0];
    numbers[1] = back.direction[1];
    numbers[2] = back.direction[2];
    numbers[4] = back.own_direction[0];
    numbers[5] = back.own_direction[1];
    numbers[6] = back.own_direction[2];
    numbers[8] = back.color[0];
    numbers[9] = back.color[1];
    numbers[10] = back.color[2];
    numbers[11] = back.intensity;
    numbers[12] = key.direction[0];
    numbers[13] = key.direction[1];
    numbers[14] = key.direction[2];
    numbers[16] = key.own_direction[0];
    numbers[17] = key.own_direction[1];
    numbers[18] = key.own_direction[2];
    numbers[20] = key.color[0];
    numbers[21] = key.color[1];
    numbers[22] = key.color[2];
    numbers[23] = key.intensity;
    numbers[24] = settings.turn;
    numbers[25] = settings.move_x;
    numbers[26] = settings.move_y;
    numbers[27] = settings.stretch_x;
    numbers[28] = settings.stretch_y;
    numbers[29] = settings.split_x;
    numbers[30] = settings.split_y;
    numbers[31] = settings.square;
    numbers[32] = body[0];
    numbers[33] = body[1];
    numbers[34] = body[2];
    numbers[35] = body[3];
    return numbers;
  }

  // Lights of the look, each in its own frame.
  const own_lights = {
    "key": {
      "type": "directional",
      "space": "illumination",
      "direction": [-0.45, 0.62, 0.65],
      "position": [0, 0, 3],
      "aim": [0, 0, -1],
      "inner": 0.35,
      "outer": 0.5,
      "color": [1, 1, 1],
      "intensity": 1,
      "half_distance": 0,
      "range": 0
    },
    "back": {
      "type": "directional",
      "space": "illumination",
      "direction": [0.8, 0.1, -0.6],
      "position": [0, 0, 3],
      "aim": [0, 0, -1],
      "inner": 0.35,
      "outer": 0.5,
      "color": [1, 1, 1],
      "intensity": 1,
      "half_distance": 0,
      "range": 0
    }
  };

  const settings_of = ({ parameters = {}, lights = {} }) => ({
    turn: number_of(parameters["turn"], 0.0),
    move_x: number_of(parameters["move_x"], 0.0),
    move_y: number_of(parameters["move_y"], 0.0),
    stretch_x: number_of(parameters["stretch_x"], 0.0),
    stretch_y: number_of(parameters["stretch_y"], 0.0),
    split_x: number_of(parameters["split_x"], 0.0),
    split_y: number_of(parameters["split_y"], 0.0),
    square: number_of(parameters["square"], 0.0),
    color: vector_of(parameters["color"], [0.16,0.3,0.55,1.0], true),
    key_light: light_of(own_lights["key"], lights["key"] ?? {}),
    back_light: light_of(own_lights["back"], lights["back"] ?? {}),
  });

  const prepared = (state, numbers, integers) => {
    const around = surroundings_of(state);
    return bytes_of(numbers(settings_of(state), around), integers);
  };

  return {
    "name": "A highlight, moved",
    "chiaro": "0.1.0",
    "colorSpace": "display",
    "opaque": false,
    "tiers": {"exact": 0, "balanced": 15, "fast": 0, "max_error": 0.00392156862745098},
    "parameters": [
      {
        "live": true,
        "label": "Body",
        "help": "What is seen where no layer paints.",
        "group": "Body",
        "target": "base.color",
        "type": "color",
        "default": [0.16, 0.3, 0.55, 1],
        "key": "color"
      },
      {
        "live": true,
        "label": "Move right",
        "help": "How far along the first axis: 1 is an eighth of a turn.",
        "group": "Move",
        "target": "move.x",
        "type": "float",
        "default": 0,
        "key": "move_x"
      },
      {
        "live": true,
        "label": "Move up",
        "help": "How far along the second.",
        "group": "Move",
        "target": "move.y",
        "type": "float",
        "default": 0,
        "key": "move_y"
      },
      {
        "live": true,
        "label": "Turn",
        "help": "How far.",
        "group": "Turn",
        "target": "turn.angle",
        "type": "float",
        "default": 0,
        "unit": "rad",
        "key": "turn"
      },
      {
        "live": true,
        "label": "Stretch across",
        "help": "How much longer along the first axis; 1 has no end.",
        "group": "Stretch",
        "target": "stretch.x",
        "type": "float",
        "default": 0,
        "max": 1,
        "key": "stretch_x"
      },
      {
        "live": true,
        "label": "Stretch upright",
        "help": "How much longer along the second.",
        "group": "Stretch",
        "target": "stretch.y",
        "type": "float",
        "default": 0,
        "max": 1,
        "key": "stretch_y"
      },
      {
        "live": true,
        "label": "Split across",
        "help": "How far apart along the first axis.",
        "group": "Split",
        "target": "split.x",
        "type": "float",
        "default": 0,
        "min": 0,
        "key": "split_x"
      },
      {
        "live": true,
        "label": "Split upright",
        "help": "How far apart along the second.",
        "group": "Split",
        "target": "split.y",
        "type": "float",
        "default": 0,
        "min": 0,
        "key": "split_y"
      },
      {
        "live": true,
        "label": "Square",
        "help": "How far the corners are drawn out; at 0.3 the sides are straight.",
        "group": "Square",
        "target": "square.amount",
        "type": "float",
        "default": 0,
        "min": 0,
        "max": 1,
        "key": "square"
      }
    ],
    "lights": [
      {
        "type": "directional",
        "space": "illumination",
        "direction": [-0.45, 0.62, 0.65],
        "position": [0, 0, 3],
        "aim": [0, 0, -1],
        "inner": 0.35,
        "outer": 0.5,
        "color": [1, 1, 1],
        "intensity": 1,
        "half_distance": 0,
        "range": 0,
        "id": "key",
        "label": "key",
        "fields": ["light.color", "light.direction", "light.intensity", "light.own_direction"]
      },
      {
        "type": "directional",
        "space": "illumination",
        "direction": [0.8, 0.1, -0.6],
        "position": [0, 0, 3],
        "aim": [0, 0, -1],
        "inner": 0.35,
        "outer": 0.5,
        "color": [1, 1, 1],
        "intensity": 1,
        "half_distance": 0,
        "range": 0,
        "id": "back",
        "label": "back",
        "fields": ["light.color", "light.direction", "light.intensity", "light.own_direction"]
      }
    ],
    "images": [],
    "passes": [
      {
        "name": "draw",
        "module": "draw",
        "draws": "meshes",
        "sides": "front",
        "outputs": [{"name": "color", "format": "any", "clear": [0, 0, 0, 0]}]
      }
    ],
    "modules": {
      "draw": {
        "purpose": "Draws a mesh with the look; the result is straight RGBA.",
        "attributes": [
          {"location": 0, "name": "position", "type": "vec3f", "semantic": "position in object space", "glsl": "a_position"},
          {"location": 1, "name": "normal", "type": "vec3f", "semantic": "unit normal in object space", "glsl": "a_normal"}
        ],
        "outputs": [{"location": 0, "type": "vec4f"}],
        "bindings": [
          {
            "name": "view",
            "kind": "uniform",
            "type": "View",
            "feed": {"from": "view"},
            "size": 144,
            "members": [
              {
                "name": "clip_from_world",
                "type": "mat4x4f",
                "offset": 0,
                "size": 64,
                "stride": 16,
                "meaning": "projection times view matrix, for the API's own clip space"
              },
              {
                "name": "camera_from_world",
                "type": "mat4x4f",
                "offset": 64,
                "size": 64,
                "stride": 16,
                "meaning": "view matrix; camera axes: x right, y up, z toward the viewer"
              },
              {
                "name": "eye",
                "type": "vec4f",
                "offset": 128,
                "size": 16,
                "meaning": "the eye in world space and 1; for parallel projection the direction toward the viewer and 0"
              }
            ],
            "wgsl": {"group": 0, "binding": 0},
            "glsl": {"name": "ViewBlock"}
          },
          {
            "name": "object",
            "kind": "uniform",
            "type": "Object",
            "feed": {"from": "object"},
            "size": 128,
            "members": [
              {
                "name": "world_from_object",
                "type": "mat4x4f",
                "offset": 0,
                "size": 64,
                "stride": 16,
                "meaning": "model matrix"
              },
              {
                "name": "world_from_normal",
                "type": "mat3x3f",
                "offset": 64,
                "size": 48,
                "stride": 16,
                "meaning": "inverse transpose of the model matrix's upper left 3x3, for normals"
              },
              {"name": "id", "type": "f32", "offset": 112, "size": 4, "meaning": "counts objects from 0"}
            ],
            "wgsl": {"group": 0, "binding": 1},
            "glsl": {"name": "ObjectBlock"}
          },
          {
            "name": "look",
            "kind": "uniform",
            "type": "Look",
            "feed": {"from": "look"},
            "size": 144,
            "members": [
              {
                "name": "back",
                "type": "Light",
                "offset": 0,
                "size": 48,
                "members": [
                  {"name": "direction", "type": "vec3f", "offset": 0, "size": 12},
                  {"name": "own_direction", "type": "vec3f", "offset": 16, "size": 12},
                  {"name": "color", "type": "vec3f", "offset": 32, "size": 12},
                  {"name": "intensity", "type": "f32", "offset": 44, "size": 4}
                ]
              },
              {
                "name": "key",
                "type": "Light",
                "offset": 48,
                "size": 48,
                "members": [
                  {"name": "direction", "type": "vec3f", "offset": 0, "size": 12},
                  {"name": "own_direction", "type": "vec3f", "offset": 16, "size": 12},
                  {"name": "color", "type": "vec3f", "offset": 32, "size": 12},
                  {"name": "intensity", "type": "f32", "offset": 44, "size": 4}
                ]
              },
              {"name": "turn_angle", "type": "f32", "offset": 96, "size": 4},
              {"name": "move_x", "type": "f32", "offset": 100, "size": 4},
              {"name": "move_y", "type": "f32", "offset": 104, "size": 4},
              {"name": "stretch_x", "type": "f32", "offset": 108, "size": 4},
              {"name": "stretch_y", "type": "f32", "offset": 112, "size": 4},
              {"name": "split_x", "type": "f32", "offset": 116, "size": 4},
              {"name": "split_y", "type": "f32", "offset": 120, "size": 4},
              {"name": "square_amount", "type": "f32", "offset": 124, "size": 4},
              {"name": "body", "type": "vec4f", "offset": 128, "size": 16}
            ],
            "wgsl": {"group": 0, "binding": 2},
            "glsl": {"name": "LookBlock"}
          }
        ],
        "entry_points": {"vertex": "vs_main", "fragment": "fs_main"},
        "wgsl": `// A highlight, moved: made by Chiaro 0.1.0, WGSL.
// Draws a mesh with the look; the result is straight RGBA.
// Bindings of group 0: view 0, object 1, look 2.
// highlight-moves.json says what to put there and how to draw.

struct View {
    clip_from_world: mat4x4f,
    camera_from_world: mat4x4f,
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    eye: vec4f,
}

struct Object {
    world_from_object: mat4x4f,
    /// The inverse transpose, for normals.
    world_from_normal: mat3x3f,
    id: f32,
}

/// What is known before the fragment.
struct Look {
    @align(16) back: Light,
    @align(16) key: Light,
    @align(16) turn_angle: f32,
    move_x: f32,
    move_y: f32,
    stretch_x: f32,
    stretch_y: f32,
    split_x: f32,
    split_y: f32,
    square_amount: f32,
    body: vec4f,
}

/// The surface under the fragment, in world space.
struct Surface {
    normal: vec3f,
    view: vec3f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var<uniform> object: Object;
@group(0) @binding(2) var<uniform> look: Look;

/// Straight RGBA.
alias Color = vec4f;

/// Premultiplied RGBA: the stack of layers below, as blends pass it on.
alias Composite = vec4f;

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    half_sin: f32,
    /// cos(u/2), 0 or more.
    half_cos: f32,
}

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    direction: vec3f,
    /// Unit, toward the light, in the light's own frame.
    own_direction: vec3f,
    /// Straight RGB.
    color: vec3f,
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    intensity: f32,
}

const HALF_PI: f32 = 1.57079632679489661923;
const LN_2: f32 = 0.693147180559945309417;
const LOG2_E: f32 = 1.44269504088896340736;
/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
fn is_finite(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7f800000u) != 0x7f800000u;
}

/// v with 0 for each component that is NaN or infinite.
fn finite_vec4(v: vec4f) -> vec4f {
    let exponent = vec4u(0x7f800000u);
    return select(vec4f(0.0), v, (bitcast<vec4u>(v) & exponent) != exponent);
}

/// v at length 1, or \`otherwise\` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
fn normalize_or(v: vec3f, otherwise: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !((largest > 1e-30) & (largest < 1e30)) {
        return otherwise;
    }
    let scaled = v * (1.0 / largest);
    let square = dot(scaled, scaled);
    // max() passes over a NaN.
    if !is_finite(square) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
fn exp2_stable(x: f32) -> f32 {
    let clamped = max(x, -126.0);
    let whole = round(clamped);
    let f = clamped - whole;
    let twice = 2.0 + f * (1.386294405710424 + f
        * (0.4804529582723118 + f * (0.11100664941567156 + f
        * (0.019236874716471952 + f * (0.0026797749114217808 + f * 0.00030706724124369897)))));
    return twice * bitcast<f32>(u32(i32(whole) + 126) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
fn log2_stable(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    let exponent = bitcast<i32>(bits - 0x3f3504f3u) >> 23u;
    let mantissa = bitcast<f32>(bits - (bitcast<u32>(exponent) << 23u));
    let z = (mantissa - 1.0) / (mantissa + 1.0);
    let z2 = z * z;
    return f32(exponent) + z * (2.8853900797881615 + z2 * (0.9617988482912865
        + z2 * (0.5767143098091317 + z2 * 0.43173790132006157)));
}

/// ln(x) for normal x > 0.
fn log_stable(x: f32) -> f32 {
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
fn log1p_negative(y: f32) -> f32 {
    if y < 0.25 {
        return log1p_negative_small(y);
    }
    return log_stable(max(1.0 - y, 1.17549435e-38));
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
fn log1p_negative_small(y: f32) -> f32 {
    let z = y / (2.0 - y);
    let z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.333333333333333333
        + z2 * (0.2 + z2 * (0.142857142857142857 + z2 * 0.111111111111111111))));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
fn sin_cos_quarter(x: f32) -> vec2f {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    let h = 0.5 * x;
    let h2 = h * h;
    let s = h * (1.0 + h2 * (-0.166666666666666667
        + h2 * (0.00833333333333333333 + h2 * (-0.000198412698412698413
        + h2 * (0.00000275573192239858907 + h2 * -2.50521083854417188e-8)))));
    let one_minus_c = h2 * (0.5 + h2 * (-0.0416666666666666667
        + h2 * (0.00138888888888888889 + h2 * (-0.0000248015873015873016
        + h2 * (2.75573192239858907e-7 + h2 * -2.08767569878680990e-9)))));
    let c = 1.0 - one_minus_c;
    return vec2f(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [\`sin_cos_quarter\`] after reduction to a
/// quarter turn.
fn sin_cos(x: f32) -> vec2f {
    let turns = round(x * 0.318309886183790672);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    let r = ((x - turns * 3.140625) - turns * 0.0009670257568359375)
        - turns * 6.27832957300962643e-7;
    let sign = 1.0 - 2.0 * abs(turns - 2.0 * trunc(turns * 0.5));
    return sign * sin_cos_quarter(clamp(r, -HALF_PI, HALF_PI));
}

/// [\`normalize_or\`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
fn normalize_moderate(v: vec3f, otherwise: vec3f) -> vec3f {
    let square = dot(v, v);
    return select(otherwise, v * inverseSqrt(max(square, 1e-30)), square > 1e-30);
}

/// [\`normalize_seen\`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
fn normalize_seen_balanced(v: vec3f) -> vec3f {
    return v * inverseSqrt(max(dot(v, v), 1e-30));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
fn angle_footprint(u: Angle) -> f32 {
    let half = vec2f(u.half_sin, u.half_cos);
    let dx = dpdx(half);
    let dy = dpdy(half);
    let w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - 0.0;
    let upper = select(vec2f(s, u.half_cos), vec2f(1.0, 0.0), u.half_cos <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < u.half_cos));
    return Angle(turned.x, turned.y);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
fn angle_turned_2(u: Angle, t: vec2f) -> Angle {
    let s = u.half_sin - u.half_cos * 0.0;
    let c = u.half_cos + u.half_sin * 0.0;
    let upper = select(vec2f(s, c), vec2f(1.0, 0.0), c <= 0.0);
    let turned = select(upper, vec2f(0.0, 1.0), (s <= 0.0) & (s < c));
    return Angle(turned.x, turned.y);
}

/// [\`bounded\`], component by component.
fn bounded_vec3(v: vec3f) -> vec3f {
    let bits = bitcast<vec3u>(v);
    let magnitude = bits & vec3u(0x7fffffffu);
    let largest = bitcast<vec3f>((bits & vec3u(0x80000000u)) | vec3u(0x7f7fffffu));
    let numbers = select(vec3f(0.0), largest, magnitude == vec3u(0x7f800000u));
    return select(numbers, v, magnitude < vec3u(0x7f800000u));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
fn footprint_of(x: f32) -> f32 {
    let d = vec2f(dpdx(x), dpdy(x));
    return sqrt(dot(d, d));
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
fn any_orthogonal(n: vec3f) -> vec3f {
    let sign = select(-1.0, 1.0, n.z >= 0.0);
    let a = -1.0 / (sign + n.z);
    return vec3f(1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x);
}

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    direction: vec3f,
    x_axis: vec3f,
    y_axis: vec3f,
    /// The direction's cosines with the two axes.
    place: vec2f,
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
fn direction_within(direction: vec3f, x_axis: vec3f, y_axis: vec3f) -> DirectionParts {
    let y = y_axis * inverseSqrt(max(dot(y_axis, y_axis), 1e-30));
    return DirectionParts(direction, x_axis, y, vec2f(dot(direction, x_axis), dot(direction, y)));
}

/// The direction moved along its axes by \`by\`, and unit again; unmoved where nothing is left of it.
fn direction_moved(parts: DirectionParts, by: vec2f) -> vec3f {
    let step = clamp(by, vec2f(-1000000.0), vec2f(1000000.0));
    let moved = parts.direction + step.x * parts.x_axis + step.y * parts.y_axis;
    return select(parts.direction, normalize_moderate(moved, parts.direction), dot(moved, moved)
        > 1e-6);
}

/// The direction moved along its axes by \`by\`, and unit again; unmoved where nothing is left of it.
fn direction_moved_2(parts: DirectionParts, by: vec2f) -> vec3f {
    let moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    return select(parts.direction, normalize_moderate(moved, parts.direction), dot(moved, moved)
        > 1e-6);
}

/// Unit axes as columns: to the right and upright, both at right angles to \`toward\`, and \`toward\`
/// itself; upright lies along \`up\` as far as that goes.
fn axes_around(toward: vec3f, up: vec3f) -> mat3x3f {
    let y = normalize_moderate(up, vec3f(0.0, 1.0, 0.0));
    let leaning = cross(y, toward);
    let square = dot(leaning, leaning);
    let aside = select(vec3f(1.0, 0.0, 0.0), vec3f(0.0, 0.0, 1.0), abs(toward.x) > 0.7);
    let across = select(cross(aside, toward), leaning, square > 1e-8);
    let x = normalize_moderate(across - dot(across, toward) * toward, vec3f(1.0, 0.0, 0.0));
    return mat3x3f(x, cross(toward, x), toward);
}

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
fn axes(direction: vec3f, up: vec3f) -> AxesAround {
    let axes_2 = axes_around(direction, up);
    return AxesAround(axes_2[0], axes_2[1]);
}

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    x_axis: vec3f,
    /// Unit, upright.
    y_axis: vec3f,
}

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
fn half_vector(light: Light, view: vec3f) -> vec3f {
    let half = light.direction + view;
    return normalize_or(select(any_orthogonal(view), half, dot(half, half) > 1e-12), view);
}

/// Split direction
///
/// Cuts a highlight in two along an axis and moves the halves apart, or in four along both: window
/// panes in an eye.
fn split_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    let side = select(vec2f(-1.0), vec2f(1.0), bent.place >= vec2f(0.0));
    return direction_moved(bent, -max(vec2f(x, y), vec2f(0.0)) * side);
}

/// Square direction
///
/// Gives a highlight corners: from round to a square whose sides lie along the axes.
fn square_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, amount: f32, sharpness: f32)
    -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    let square = dot(bent.place, bent.place);
    let apart = abs(bent.place.x) - abs(bent.place.y);
    let aside = min(apart * apart / max(square, 1e-20), 1.0);
    let corner = select(0.0, exp2_stable(sharpness * LOG2_E * log1p_negative(aside)),
        (square > 1e-20) & (aside < 1.0));
    return direction_moved_2(bent, -clamp(amount, 0.0, 1.0) * corner * bent.place);
}

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
fn stretch_direction(direction: vec3f, x_axis: vec3f, y_axis: vec3f, x: f32, y: f32) -> vec3f {
    let bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -min(vec2f(x, y), vec2f(1.0)) * bent.place);
}

fn blend_alpha(below: Composite, color: Color, tone: f32, opacity: f32, clamped: bool)
    -> Composite {
    let alpha = below.w + tone * opacity * (1.0 - below.w);
    return clamp(vec4f(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), alpha), vec4f(0.0), vec4f(1.0));
}

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    half_cos_offset: f32,
    half_sin_offset: f32,
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    scale: f32,
    /// gamma of BADF eq. 11.
    exponent: f32,
    /// tau, the step's place, in radians.
    offset: f32,
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    edge_mean: f32,
    edge_deviation: f32,
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    kind: u32,
}

/// alpha of a soft profile where the half-sine from tau is s.
fn profile_soft_quick(s: f32, shape: ProfileShape) -> f32 {
    let q = s * shape.scale;
    return select(pow(max(1.0 - q * q, 0.0), shape.exponent), 1.0, s <= 0.0);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
fn profile_ramp_quick_2(s: f32, w: f32, shape: ProfileShape) -> f32 {
    let width = sqrt(w * w);
    let from_offset = s * (2.0 + s * s * 0.333333333333333333);
    let ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return select(ramp, select(0.0, 1.0, s <= 4e-7), w <= 0.0);
}

/// [\`profile_filtered\`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
fn profile_filtered_quick(u: Angle, w: f32, shape: ProfileShape) -> f32 {
    let place = vec2f(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    let is_narrow = (w > 0.0) & (w >= 3.46410161513775459 * shape.edge_deviation);
    if is_narrow {
        return profile_ramp_quick(place.x, w, shape);
    }
    let point = profile_soft_quick(place.x, shape);
    if w < 0.1 * shape.edge_deviation {
        return point;
    }
    let r = 0.193649167310370844 * w;
    let turn = vec2f(r * (1.0 - 0.166666666666666667 * r * r), 1.0 - 0.5 * r * r);
    let before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    let after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

fn profile_balanced(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned(angle, vec2f(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

fn profile_balanced_2(angle: Angle, shift: f32, shape: ProfileShape) -> f32 {
    let warped = angle_turned_2(angle, vec2f(0.0, 1.0));
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint(warped), shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
fn rim(light: Light, normal: vec3f, view: vec3f, width: f32, softness: f32, follow: f32) -> f32 {
    let facing = clamp(dot(normal, view), 0.0, 1.0);
    let edge = max(width * softness, min(footprint_of(facing), 1.0));
    let aside = normal - view;
    let further = select(width - facing, 0.5 * dot(aside, aside) - (1.0 - width), facing > 0.5);
    let within = further / edge + 0.0;
    let inside = clamp(within, 0.0, 1.0);
    let across = light.direction - dot(light.direction, view) * view;
    let side = dot(normal - dot(normal, view) * view, across
        * inverseSqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// Rotate vector
///
/// Turns a vector about an axis, counter-clockwise as the axis points at you.
fn rotate_vector(vector: vec3f, axis: vec3f, angle: f32) -> vec3f {
    let half = clamp(sin_cos(0.5 * angle), vec2f(-1.0), vec2f(1.0));
    let aside = cross(axis, vector);
    return bounded_vec3(vector + 2.0 * half.x * (half.y * aside + half.x * cross(axis, aside)));
}

const lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25, 0.17004733,
    0.08138281, 0u);
const highlight_shape = ProfileShape(0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0, 1u);

/// The look at one point of the surface.
fn shade(surface: Surface) -> vec4f {
    // Parametrization
    let turned_from_the_key = Angle(0.5 * length(surface.normal - look.key.direction), 0.5
        * length(surface.normal + look.key.direction));
    let lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    let in_the_dark = 1.0 - lit_side;
    // Blend
    let shadow = clamp(vec4f(look.body.xyz
        + (look.body.xyz * mix(vec3f(1.0), vec4f(0.45, 0.36, 0.62, 1.0).xyz, in_the_dark)
        - look.body.xyz), look.body.w), vec4f(0.0), vec4f(1.0));
    let normal = surface.normal;
    let half = half_vector(look.key, surface.view);
    let turn = rotate_vector(vec3f(0.0, 1.0, 0.0), half, look.turn_angle);
    let axes_of_the_highlight = axes(half, turn);
    // Shift direction
    let move_2 = direction_moved(direction_within(normal, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis), vec2f(look.move_x, look.move_y));
    let stretch = stretch_direction(move_2, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, look.stretch_x, look.stretch_y);
    let split = split_direction(stretch, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis,
        look.split_x, look.split_y);
    let square = square_direction(split, axes_of_the_highlight.x_axis, axes_of_the_highlight.y_axis,
        look.square_amount, 4.0);
    // Angle between directions
    let from_the_highlight = Angle(0.5 * length(square - half), 0.5 * length(square + half));
    let highlight = profile_balanced_2(from_the_highlight, 0.0, highlight_shape);
    let highlight_on_top = blend_alpha(shadow, vec4f(1.0, 0.98, 0.92, 1.0), highlight, 0.96, true);
    let rim_2 = rim(look.back, surface.normal, surface.view, 0.3, 0.2, 1.0);
    // Blend
    let rim_s_light = clamp(vec4f(highlight_on_top.xyz + 0.5
        * (highlight_on_top.xyz + rim_2 * vec4f(0.55, 0.75, 1.0, 1.0).xyz - highlight_on_top.xyz),
        highlight_on_top.w), vec4f(0.0), vec4f(1.0));
    let output = finite_vec4(select(vec4f(rim_s_light.xyz / rim_s_light.w, rim_s_light.w),
        rim_s_light, rim_s_light.w <= 0.0));
    return output;
}

struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

struct Varyings {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

@vertex
fn vs_main(vertex: Vertex) -> Varyings {
    let world = object.world_from_object * vec4f(vertex.position, 1.0);
    return Varyings(view.clip_from_world * world, world.xyz, object.world_from_normal
        * vertex.normal);
}

@fragment
fn fs_main(in: Varyings, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facing = normalize_seen_balanced(in.normal);
    let normal = select(-facing, facing, is_front);
    let surface = Surface(normal, normalize(view.eye.xyz - view.eye.w * in.position));
    return finite_vec4(shade(surface));
}
`,
        "glsl": {
          "vertex": `#version 300 es
// A highlight, moved: made by Chiaro 0.1.0, GLSL ES 3.00.
// The vertex shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// highlight-moves.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

struct Object {
    mat4x4 world_from_object;
    /// The inverse transpose, for normals.
    mat3x3 world_from_normal;
    float id;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
};

struct Vertex {
    vec3 position;
    vec3 normal;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const float HALF_PI = 1.5707964;
const float LN_2 = 0.6931472;
const float LOG2_E = 1.442695;
const ProfileShape lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25,
    0.17004733, 0.08138281, 0u);
const ProfileShape highlight_shape = ProfileShape(0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0,
    1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform ObjectBlock { Object u_object; };

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
smooth out vec3 v_position;
smooth out vec3 v_normal;

void main() {
    Vertex vertex = Vertex(a_position, a_normal);
    vec4 world = u_object.world_from_object * vec4(vertex.position, 1.0);
    Varyings varyings = Varyings(u_view.clip_from_world * world, world.xyz,
        u_object.world_from_normal * vertex.normal);
    gl_Position = varyings.clip;
    v_position = varyings.position;
    v_normal = varyings.normal;
}
`,
          "fragment": `#version 300 es
// A highlight, moved: made by Chiaro 0.1.0, GLSL ES 3.00.
// The fragment shader. Draws a mesh with the look; the result is straight RGBA.
// Uniform blocks (std140): ViewBlock 0, ObjectBlock 1, LookBlock 2.
// highlight-moves.json says what to put there and how to draw.

precision highp float;
precision highp int;

struct View {
    mat4x4 clip_from_world;
    mat4x4 camera_from_world;
    /// The eye and 1; for parallel projection the direction toward the viewer and 0.
    vec4 eye;
};

/// A light as it arrives at a point of the surface.
struct Light {
    /// Unit, toward the light, in world space.
    vec3 direction;
    /// Unit, toward the light, in the light's own frame.
    vec3 own_direction;
    /// Straight RGB.
    vec3 color;
    /// The light's intensity with its distance and cone attenuation; 0 or more.
    float intensity;
};

/// What is known before the fragment.
struct Look {
    Light back;
    Light key;
    float turn_angle;
    float move_x;
    float move_y;
    float stretch_x;
    float stretch_y;
    float split_x;
    float split_y;
    float square_amount;
    vec4 body;
};

/// The surface under the fragment, in world space.
struct Surface {
    vec3 normal;
    vec3 view;
};

/// An angle u in [0, pi] by the sine and cosine of its half, so that nothing is lost near 0 and
/// near pi.
struct Angle {
    /// sin(u/2), 0 or more.
    float half_sin;
    /// cos(u/2), 0 or more.
    float half_cos;
};

/// A direction with the two axes along which it is bent.
struct DirectionParts {
    /// Unit.
    vec3 direction;
    vec3 x_axis;
    vec3 y_axis;
    /// The direction's cosines with the two axes.
    vec2 place;
};

struct AxesAround {
    /// Unit, to the right as seen against the direction.
    vec3 x_axis;
    /// Unit, upright.
    vec3 y_axis;
};

/// Constants of a profile, from its offset, fall-off and cut-off; made once, in f64 wherever those
/// are known before the fragment.
struct ProfileShape {
    /// cos(tau/2) and sin(tau/2).
    float half_cos_offset;
    float half_sin_offset;
    /// 1 / sin(c'/2); 0 for a step at tau and for ambient.
    float scale;
    /// gamma of BADF eq. 11.
    float exponent;
    /// tau, the step's place, in radians.
    float offset;
    /// Mean and standard deviation of the soft edge, measured from tau, in radians.
    float edge_mean;
    float edge_deviation;
    /// Kind of the profile: 0 soft, 1 a step at tau, 2 ambient, which is 1 everywhere.
    uint kind;
};

struct Varyings {
    vec4 clip;
    vec3 position;
    vec3 normal;
};

const float HALF_PI = 1.5707964;
const float LN_2 = 0.6931472;
const float LOG2_E = 1.442695;
const ProfileShape lit_side_shape = ProfileShape(0.8109631, 0.58509725, 4.0419726, 5.9230337, 1.25,
    0.17004733, 0.08138281, 0u);
const ProfileShape highlight_shape = ProfileShape(0.9939561, 0.1097783, 0.0, 1.0, 0.22, 0.0, 0.0,
    1u);

layout(std140) uniform ViewBlock { View u_view; };

layout(std140) uniform LookBlock { Look u_look; };

smooth in vec3 v_position;
smooth in vec3 v_normal;
layout(location = 0) out vec4 out_color;

/// True if x is neither NaN nor infinite, told by its exponent bits: a compiler may assume that NaN
/// never happens.
bool is_finite(float x) {
    return (floatBitsToUint(x) & 2139095040u) != 2139095040u;
}

/// v with 0 for each component that is NaN or infinite.
vec4 finite_vec4(vec4 v) {
    uvec4 exponent = uvec4(2139095040u);
    return mix(vec4(0.0), v, notEqual(floatBitsToUint(v) & exponent, exponent));
}

/// v at length 1, or \`otherwise\` where v is too short or too long to have a direction, or has a
/// NaN. Scaled by the largest component first, so that neither tiny nor huge vectors under- or
/// overflow.
vec3 normalize_or(vec3 v, vec3 otherwise) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 1e-30 && largest < 1e30)) {
        return otherwise;
    }
    vec3 scaled = v * (1.0 / largest);
    float square = dot(scaled, scaled);
    // max() passes over a NaN.
    if (!is_finite(square)) {
        return otherwise;
    }
    return scaled * (1.0 / sqrt(square));
}

/// 2^x: a minimax polynomial of degree 6 on [-1/2, 1/2] (relative error below 3e-9 beside
/// rounding), scaled by a power of two. 0 below -125.5, the largest finite number above 128.
float exp2_stable(float x) {
    float clamped = max(x, -126.0);
    float whole = roundEven(clamped);
    float f = clamped - whole;
    float twice = 2.0 + f * (1.3862944 + f
        * (0.48045295 + f * (0.11100665 + f
        * (0.019236874 + f * (0.002679775 + f * 0.00030706724)))));
    return twice * uintBitsToFloat(uint(int(whole) + 126) << 23u);
}

/// log2(x) for normal x > 0: the exponent by bits, the mantissa by a minimax polynomial in
/// (m - 1) / (m + 1) (relative error below 1e-9 beside rounding).
float log2_stable(float x) {
    uint bits = floatBitsToUint(x);
    // Mantissa in [sqrt(1/2), sqrt(2)), so that z stays below 0.1716. The sign bit moves down.
    int exponent = int(bits - 1060439283u) >> 23u;
    float mantissa = uintBitsToFloat(bits - (uint(exponent) << 23u));
    float z = (mantissa - 1.0) / (mantissa + 1.0);
    float z2 = z * z;
    return float(exponent) + z * (2.88539 + z2 * (0.96179885 + z2 * (0.57671434 + z2 * 0.4317379)));
}

/// ln(x) for normal x > 0.
float log_stable(float x) {
    return LN_2 * log2_stable(x);
}

/// ln(1 - y) for y in [0, 1/4], by the series of atanh.
float log1p_negative_small(float y) {
    float z = y / (2.0 - y);
    float z2 = z * z;
    return -2.0 * z * (1.0 + z2 * (0.33333334 + z2 * (0.2 + z2 * (0.14285715 + z2 * 0.11111111))));
}

/// ln(1 - y) for y in [0, 1): relative accuracy near 0, where 1 - y would round y away.
float log1p_negative(float y) {
    if (y < 0.25) {
        return log1p_negative_small(y);
    }
    return log_stable(max(1.0 - y, 1.1754944e-38));
}

/// sin(x) and cos(x) for |x| <= pi/2: polynomials (absolute error below 2e-7), because WGSL allows
/// 4.9e-4.
vec2 sin_cos_quarter(float x) {
    // x is halved to |h| <= pi/4, where short series suffice, and the result doubled. The series
    // are long enough for f64 to see sines by 1e-11, and end where they err downward: a profile
    // whose cut-off is pi is 0 there, in f64 too.
    float h = 0.5 * x;
    float h2 = h * h;
    float s = h * (1.0 + h2 * (-0.16666667 + h2
        * (0.008333334 + h2 * (-0.0001984127 + h2 * (2.7557319e-6 + h2 * -2.5052108e-8)))));
    float one_minus_c = h2 * (0.5 + h2
        * (-0.041666668 + h2 * (0.0013888889 + h2
        * (-2.4801588e-5 + h2 * (2.755732e-7 + h2 * -2.0876756e-9)))));
    float c = 1.0 - one_minus_c;
    return vec2(2.0 * s * c, 1.0 - 2.0 * s * s);
}

/// sin(x) and cos(x) for any finite x with |x| < 1e5; [\`sin_cos_quarter\`] after reduction to a
/// quarter turn.
vec2 sin_cos(float x) {
    float turns = roundEven(x * 0.31830987);
    // Cody and Waite: pi in three parts, so that the reduced angle keeps its digits.
    float r = x - turns * 3.140625 - turns * 0.00096702576 - turns * 6.2783295e-7;
    float sign_ = 1.0 - 2.0 * abs(turns - 2.0 * trunc(turns * 0.5));
    return sign_ * sin_cos_quarter(clamp(r, -1.5707964, HALF_PI));
}

/// [\`normalize_or\`] for vectors that are known to be no longer than 1e18: one shorter than 1e-15
/// counts as having no direction.
vec3 normalize_moderate(vec3 v, vec3 otherwise) {
    float square = dot(v, v);
    return square > 1e-30 ? v * inversesqrt(max(square, 1e-30)) : otherwise;
}

/// [\`normalize_seen\`] without a direction for what has none: a vector shorter than 1e-15 stays
/// short.
vec3 normalize_seen_balanced(vec3 v) {
    return v * inversesqrt(max(dot(v, v), 1e-30));
}

/// Change of u over one pixel, in radians: |grad u|, at most 0.5. With half-angles the gradient
/// needs no inverse trigonometry: |du| = 2 |d(sin u/2, cos u/2)|. Call it in uniform control flow.
float angle_footprint(Angle u) {
    vec2 half_ = vec2(u.half_sin, u.half_cos);
    vec2 dx = dFdx(half_);
    vec2 dy = dFdy(half_);
    float w = 2.0 * sqrt(dot(dx, dx) + dot(dy, dy));
    return min(w, 0.5);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned(Angle u, vec2 t) {
    float s = u.half_sin - 0.0;
    vec2 upper = u.half_cos <= 0.0 ? vec2(1.0, 0.0) : vec2(s, u.half_cos);
    vec2 turned = (s <= 0.0 && s < u.half_cos) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// u turned by -shift, given the sine and cosine of half the shift; clamped to [0, pi].
Angle angle_turned_2(Angle u, vec2 t) {
    float s = u.half_sin - u.half_cos * 0.0;
    float c = u.half_cos + u.half_sin * 0.0;
    vec2 upper = c <= 0.0 ? vec2(1.0, 0.0) : vec2(s, c);
    vec2 turned = (s <= 0.0 && s < c) ? vec2(0.0, 1.0) : upper;
    return Angle(turned.x, turned.y);
}

/// [\`bounded\`], component by component.
vec3 bounded_vec3(vec3 v) {
    uvec3 bits = floatBitsToUint(v);
    uvec3 magnitude = bits & uvec3(2147483647u);
    vec3 largest = uintBitsToFloat((bits & uvec3(2147483648u)) | uvec3(2139095039u));
    vec3 numbers = mix(vec3(0.0), largest, equal(magnitude, uvec3(2139095040u)));
    return mix(numbers, v, lessThan(magnitude, uvec3(2139095040u)));
}

/// Change of x over one pixel: |grad x|, finite. Call it in uniform control flow.
float footprint_of(float x) {
    vec2 d = vec2(dFdx(x), dFdy(x));
    return sqrt(dot(d, d));
}

/// A unit vector at right angles to the unit vector n, smooth but at one pole (Duff et al. 2017).
vec3 any_orthogonal(vec3 n) {
    float sign_ = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (sign_ + n.z);
    return vec3(1.0 + sign_ * n.x * n.x * a, sign_ * n.x * n.y * a, -sign_ * n.x);
}

/// The direction and its axes, made unit; an axis without a direction does nothing, a direction
/// without one is +z.
DirectionParts direction_within(vec3 direction, vec3 x_axis, vec3 y_axis) {
    vec3 y = y_axis * inversesqrt(max(dot(y_axis, y_axis), 1e-30));
    return DirectionParts(direction, x_axis, y, vec2(dot(direction, x_axis), dot(direction, y)));
}

/// The direction moved along its axes by \`by\`, and unit again; unmoved where nothing is left of it.
vec3 direction_moved(DirectionParts parts, vec2 by) {
    vec2 step_ = clamp(by, vec2(-1000000.0), vec2(1000000.0));
    vec3 moved = parts.direction + step_.x * parts.x_axis + step_.y * parts.y_axis;
    vec3 normalize_moderate_value = normalize_moderate(moved, parts.direction);
    return dot(moved, moved) > 1e-6 ? normalize_moderate_value : parts.direction;
}

/// The direction moved along its axes by \`by\`, and unit again; unmoved where nothing is left of it.
vec3 direction_moved_2(DirectionParts parts, vec2 by) {
    vec3 moved = parts.direction + by.x * parts.x_axis + by.y * parts.y_axis;
    vec3 normalize_moderate_value = normalize_moderate(moved, parts.direction);
    return dot(moved, moved) > 1e-6 ? normalize_moderate_value : parts.direction;
}

/// Unit axes as columns: to the right and upright, both at right angles to \`toward\`, and \`toward\`
/// itself; upright lies along \`up\` as far as that goes.
mat3x3 axes_around(vec3 toward, vec3 up) {
    vec3 y = normalize_moderate(up, vec3(0.0, 1.0, 0.0));
    vec3 leaning = cross(y, toward);
    float square = dot(leaning, leaning);
    vec3 aside = abs(toward.x) > 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
    vec3 across = square > 1e-8 ? leaning : cross(aside, toward);
    vec3 x = normalize_moderate(across - dot(across, toward) * toward, vec3(1.0, 0.0, 0.0));
    return mat3x3(x, cross(toward, x), toward);
}

/// Axes around a direction
///
/// Two directions at right angles to a light or a half-vector: the axes along which a highlight is
/// moved, stretched or split so that it keeps its shape on every object, whatever its texture
/// coordinates.
AxesAround axes(vec3 direction, vec3 up) {
    mat3x3 axes_2 = axes_around(direction, up);
    return AxesAround(axes_2[0], axes_2[1]);
}

/// Half-vector
///
/// Midway between a light and the eye. A highlight lies where it meets the normal: bend either of
/// them with the nodes beside this one, measure the Angle between directions, and the highlight
/// takes another shape.
vec3 half_vector(Light light, vec3 view) {
    vec3 half_ = light.direction + view;
    vec3 any_orthogonal_value = any_orthogonal(view);
    return normalize_or(dot(half_, half_) > 1e-12 ? half_ : any_orthogonal_value, view);
}

/// Split direction
///
/// Cuts a highlight in two along an axis and moves the halves apart, or in four along both: window
/// panes in an eye.
vec3 split_direction(vec3 direction, vec3 x_axis, vec3 y_axis, float x, float y) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    vec2 side = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(bent.place, vec2(0.0)));
    return direction_moved(bent, -max(vec2(x, y), vec2(0.0)) * side);
}

/// Square direction
///
/// Gives a highlight corners: from round to a square whose sides lie along the axes.
vec3 square_direction(vec3 direction, vec3 x_axis, vec3 y_axis, float amount, float sharpness) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    float square = dot(bent.place, bent.place);
    float apart = abs(bent.place.x) - abs(bent.place.y);
    float aside = min(apart * apart / max(square, 1e-20), 1.0);
    float exp2_stable_value = exp2_stable(sharpness * LOG2_E * log1p_negative(aside));
    float corner = (square > 1e-20 && aside < 1.0) ? exp2_stable_value : 0.0;
    return direction_moved_2(bent, -clamp(amount, 0.0, 1.0) * corner * bent.place);
}

/// Stretch direction
///
/// Makes a highlight longer along an axis (above 0) or shorter (below 0): streaks of silk, hair and
/// brushed metal.
vec3 stretch_direction(vec3 direction, vec3 x_axis, vec3 y_axis, float x, float y) {
    DirectionParts bent = direction_within(direction, x_axis, y_axis);
    return direction_moved(bent, -min(vec2(x, y), vec2(1.0)) * bent.place);
}

vec4 blend_alpha(vec4 below, vec4 color, float tone, float opacity, bool clamped) {
    float alpha = below.w + tone * opacity * (1.0 - below.w);
    return clamp(vec4(below.xyz + opacity
        * (below.xyz + tone * (color.xyz - below.xyz) - below.xyz), alpha), vec4(0.0), vec4(1.0));
}

/// alpha of a soft profile where the half-sine from tau is s.
float profile_soft_quick(float s, ProfileShape shape) {
    float q = s * shape.scale;
    return s <= 0.0 ? 1.0 : pow(max(1.0 - q * q, 0.0), shape.exponent);
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w + 12.0 * shape.edge_deviation * shape.edge_deviation);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (shape.edge_mean - from_offset) / width, 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// The ramp of an edge that is narrower than the footprint, from the half-sine s; a hard, inclusive
/// step where the footprint is 0.
float profile_ramp_quick_2(float s, float w, ProfileShape shape) {
    float width = sqrt(w * w);
    float from_offset = s * (2.0 + s * s * 0.33333334);
    float ramp = clamp(0.5 + (0.0 - from_offset) / max(width, 1e-6), 0.0, 1.0);
    return w <= 0.0 ? (s <= 4e-7 ? 1.0 : 0.0) : ramp;
}

/// [\`profile_filtered\`] with the same footprint and quadrature in shorter forms: the two outer
/// points are found by turning the middle one.
float profile_filtered_quick(Angle u, float w, ProfileShape shape) {
    vec2 place = vec2(u.half_sin * shape.half_cos_offset - u.half_cos * shape.half_sin_offset,
        u.half_cos * shape.half_cos_offset + u.half_sin * shape.half_sin_offset);
    bool is_narrow = w > 0.0 && w >= 3.4641016 * shape.edge_deviation;
    if (is_narrow) {
        return profile_ramp_quick(place.x, w, shape);
    }
    float point = profile_soft_quick(place.x, shape);
    if (w < 0.1 * shape.edge_deviation) {
        return point;
    }
    float r = 0.19364917 * w;
    vec2 turn = vec2(r * (1.0 - 0.16666667 * r * r), 1.0 - 0.5 * r * r);
    float before = profile_soft_quick(place.x * turn.y - place.y * turn.x, shape);
    float after = profile_soft_quick(place.x * turn.y + place.y * turn.x, shape);
    return (5.0 * before + 8.0 * point + 5.0 * after) / 18.0;
}

float profile_balanced(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned(angle, vec2(0.0, 1.0));
    return profile_filtered_quick(warped, angle_footprint(warped), shape);
}

float profile_balanced_2(Angle angle, float shift, ProfileShape shape) {
    Angle warped = angle_turned_2(angle, vec2(0.0, 1.0));
    float angle_footprint_value = angle_footprint(warped);
    return profile_ramp_quick_2(warped.half_sin * shape.half_cos_offset - warped.half_cos
        * shape.half_sin_offset, angle_footprint_value, shape);
}

/// Rim light
///
/// A line of light along the silhouette, on the side of a light: what lifts a figure off its
/// background.
float rim(Light light, vec3 normal, vec3 view, float width, float softness, float follow) {
    float facing = clamp(dot(normal, view), 0.0, 1.0);
    float edge = max(width * softness, min(footprint_of(facing), 1.0));
    vec3 aside = normal - view;
    float further = facing > 0.5 ? 0.5 * dot(aside, aside) - (1.0 - width) : width - facing;
    float within = further / edge + 0.0;
    float inside = clamp(within, 0.0, 1.0);
    vec3 across = light.direction - dot(light.direction, view) * view;
    float side = dot(normal - dot(normal, view) * view, across
        * inversesqrt(max(dot(across, across), 1e-30)));
    return inside * mix(1.0, smoothstep(0.0, 0.5, side), follow);
}

/// Rotate vector
///
/// Turns a vector about an axis, counter-clockwise as the axis points at you.
vec3 rotate_vector(vec3 vector, vec3 axis, float angle) {
    vec2 half_ = clamp(sin_cos(0.5 * angle), vec2(-1.0), vec2(1.0));
    vec3 aside = cross(axis, vector);
    return bounded_vec3(vector + 2.0 * half_.x * (half_.y * aside + half_.x * cross(axis, aside)));
}

/// The look at one point of the surface.
vec4 shade(Surface surface) {
    // Parametrization
    Angle turned_from_the_key = Angle(0.5 * length(surface.normal - u_look.key.direction), 0.5
        * length(surface.normal + u_look.key.direction));
    float lit_side = profile_balanced(turned_from_the_key, 0.0, lit_side_shape);
    float in_the_dark = 1.0 - lit_side;
    // Blend
    vec4 shadow = clamp(vec4(u_look.body.xyz
        + (u_look.body.xyz * mix(vec3(1.0), vec3(0.45, 0.36, 0.62), in_the_dark) - u_look.body.xyz),
        u_look.body.w), vec4(0.0), vec4(1.0));
    vec3 normal = surface.normal;
    vec3 half_ = half_vector(u_look.key, surface.view);
    vec3 turn = rotate_vector(vec3(0.0, 1.0, 0.0), half_, u_look.turn_angle);
    AxesAround axes_of_the_highlight = axes(half_, turn);
    // Shift direction
    vec3 move_2 = direction_moved(direction_within(normal, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis), vec2(u_look.move_x, u_look.move_y));
    vec3 stretch = stretch_direction(move_2, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, u_look.stretch_x, u_look.stretch_y);
    vec3 split = split_direction(stretch, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, u_look.split_x, u_look.split_y);
    vec3 square = square_direction(split, axes_of_the_highlight.x_axis,
        axes_of_the_highlight.y_axis, u_look.square_amount, 4.0);
    // Angle between directions
    Angle from_the_highlight = Angle(0.5 * length(square - half_), 0.5 * length(square + half_));
    float highlight = profile_balanced_2(from_the_highlight, 0.0, highlight_shape);
    vec4 highlight_on_top = blend_alpha(shadow, vec4(1.0, 0.98, 0.92, 1.0), highlight, 0.96, true);
    float rim_2 = rim(u_look.back, surface.normal, surface.view, 0.3, 0.2, 1.0);
    // Blend
    vec4 rim_s_light = clamp(vec4(highlight_on_top.xyz + 0.5
        * (highlight_on_top.xyz + rim_2 * vec3(0.55, 0.75, 1.0) - highlight_on_top.xyz),
        highlight_on_top.w), vec4(0.0), vec4(1.0));
    vec4 output_ = finite_vec4(rim_s_light.w
        <= 0.0 ? rim_s_light : vec4(rim_s_light.xyz / vec3(rim_s_light.w), rim_s_light.w));
    return output_;
}

void main() {
    Varyings in_ = Varyings(gl_FragCoord, v_position, v_normal);
    bool is_front = gl_FrontFacing;
    vec3 facing = normalize_seen_balanced(in_.normal);
    vec3 normal = is_front ? facing : -facing;
    Surface surface = Surface(normal, normalize(u_view.eye.xyz - u_view.eye.w * in_.position));
    out_color = finite_vec4(shade(surface));
}
`
        },
        "prepare": (state) => prepared(state, draw_numbers, []),
      },
    }
  };
})()
;
