// Values of a look that a program sets: its parameters and lights, by the artist's names.

const isPlain = (value) => ["number", "boolean", "string"].includes(typeof value);

const linearOf = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

/** Numbers of a color such as `#40c070` or `0x40c070`, in the look's space. */
function numbersOfHex(hex, colorSpace) {
  const isNumber = Number.isInteger(hex) && hex >= 0 && hex <= 0xffffff;
  const text = isNumber ? `#${hex.toString(16).padStart(6, "0")}` : hex;
  if (!/^#[0-9a-f]{6}$/i.test(text)) return undefined;
  const shown = [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16) / 255);
  return colorSpace === "display" ? shown : shown.map(linearOf);
}

/**
 * Numbers of a value: an array, a vector, or a color of three.js, of Babylon.js or in hex.
 * `colorSpace` is that of colors, and nothing for other values.
 */
function numbersOf(value, colorSpace) {
  if (isPlain(value)) return colorSpace && numbersOfHex(value, colorSpace);
  if (value?.isColor && colorSpace === "display") {
    // Colors of three.js are linear; looks in display colors want what is shown.
    const shown = value.getRGB({}, "srgb");
    return [shown.r, shown.g, shown.b];
  }
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, Number);
  if (value?.toArray) return Array.from(value.toArray(), Number);
  if (value?.asArray) return Array.from(value.asArray(), Number);
  return undefined;
}

/** The value in the form that the default has; a TypeError that says what is expected. */
function checked(name, value, example, colorSpace) {
  if (isPlain(example)) {
    if (typeof value === typeof example && !Number.isNaN(value)) return value;
    throw new TypeError(`${name} is a ${typeof example}, such as ${JSON.stringify(example)}`);
  }
  const isNumber = typeof value === "number" && !colorSpace;
  const numbers = isNumber ? example.map(() => value) : numbersOf(value, colorSpace);
  if (numbers && !numbers.some(Number.isNaN)) {
    if (numbers.length === example.length) return Object.freeze(numbers);
    // Colors without alpha are opaque.
    if (numbers.length === 3 && example.length === 4) return Object.freeze([...numbers, 1]);
  }
  const hex = colorSpace ? ", or a color such as \"#40c070\" or 0x40c070" : "";
  throw new TypeError(`${name} takes ${example.length} numbers, such as [${example}]${hex}`);
}

/** The names in an object, for errors about another one. */
const namesOf = (object) => Object.keys(object).join(", ") || "none";

/**
 * An object whose properties are values with defaults; other names cannot be set. `spaceOf` tells
 * the space of the colors among them.
 */
function settable(owner, fields, spaceOf, notify) {
  const values = {};
  const object = {};
  for (const [key, example] of Object.entries(fields)) {
    const original = isPlain(example) ? example : Object.freeze([...example]);
    Object.defineProperty(object, key, {
      enumerable: true,
      get: () => values[key] ?? original,
      set(value) {
        if (value === undefined) delete values[key];
        else values[key] = checked(`${owner}${key}`, value, original, spaceOf(key));
        notify();
      },
    });
  }
  const guarded = new Proxy(Object.preventExtensions(object), {
    set(target, key, value) {
      if (!Object.hasOwn(target, key)) {
        throw new TypeError(`there is no ${owner}${String(key)}, but ${namesOf(target)}`);
      }
      target[key] = value;
      return true;
    },
  });
  return { object: guarded, values };
}

/** Fields of lights that a program may set, in the light's own frame. */
const LIGHT_FIELDS = [
  "direction", "position", "aim", "color", "intensity", "inner", "outer", "half_distance", "range",
];

const IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Parameters and lights of one material. What is set to `undefined` has the look's own value. */
export class LookValues {
  constructor(look) {
    /** Counts changes. */
    this.version = 0;
    const notify = () => this.version++;
    const space = look.colorSpace;
    const defaults = Object.fromEntries(look.parameters.map(({ key, default: own }) => [key, own]));
    const types = Object.fromEntries(look.parameters.map(({ key, type }) => [key, type]));
    const spaceOf = (key) => (types[key] === "color" ? space : undefined);
    const parameters = settable("parameters.", defaults, spaceOf, notify);
    this.parameters = parameters.object;
    this.lights = {};
    this.values = { parameters: parameters.values, lights: {} };
    for (const light of look.lights) {
      const names = LIGHT_FIELDS.filter((field) => light[field] !== undefined);
      const fields = Object.fromEntries(names.map((field) => [field, light[field]]));
      const { object, values } = settable(
        `lights.${light.id}.`, fields, (field) => (field === "color" ? space : undefined), notify);
      this.lights[light.id] = object;
      this.values.lights[light.id] = values;
    }
    Object.freeze(this.lights);
    /** Rotation of the illumination frame, which turns its lights together: three columns. */
    this.illumination = IDENTITY;
    /** Seconds, for looks that change with time. */
    this.time = 0;
  }

  /** The state for `prepare`; `place` has camera, object and viewport. */
  state(place) {
    const { parameters, lights } = this.values;
    const { illumination, time } = this;
    return { parameters, lights, illumination, time, frame: 0, ...place };
  }

  /** Takes over the values of another material of the same look. */
  copy(other) {
    for (const key of Object.keys(this.parameters)) {
      this.parameters[key] = other.values.parameters[key];
    }
    for (const [id, light] of Object.entries(this.lights)) {
      for (const field of Object.keys(light)) light[field] = other.values.lights[id][field];
    }
    this.illumination = other.illumination;
    this.time = other.time;
    return this;
  }
}
