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
