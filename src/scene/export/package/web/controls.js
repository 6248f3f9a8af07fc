// Controls: a row for each exposed parameter, and for each light.

const element = (tag, properties = {}, ...children) => {
  const { dataset, style, ...others } = properties;
  const made = Object.assign(document.createElement(tag), others);
  Object.assign(made.dataset, dataset);
  for (const [name, value] of Object.entries(style ?? {})) made.style.setProperty(name, value);
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
};

let lastId = 0;
const freshId = () => `control-${(lastId += 1)}`;

/** A number as people read it: four digits that count. */
const shortNumber = (x) => String(Number(Number(x).toPrecision(4)));

/** Radians are shown as degrees. */
const DISPLAYED_UNITS = { rad: { factor: 180 / Math.PI, text: "°" } };

/** Ends of a slider where the artist gave none: around the default. */
function rangeOf({ min, max, default: value }) {
  const size = Math.abs(value) || 1;
  const isShare = value > 0 && value <= 1;
  return [min ?? (value > 0 ? 0 : value - size), max ?? (isShare ? 1 : value + size)];
}

/**
 * A row: a label, a value and a button that gives back the default. `control` makes what lies in
 * it: `value` beside the label, `wide` below, `show(value)`, and `input`, which the label names.
 * `spoken` is the label with its group, which tells rows of the same label apart; `own` the value
 * that the button gives back, in words.
 */
function row({ label, spoken = label, help, control, read, reset, isDefault, own }) {
  const id = freshId();
  control.input.id = id;
  const name = element("label", { htmlFor: id, textContent: label, title: help ?? "" });
  control.input.setAttribute("aria-label", spoken);
  const told = own ? `Back to ${own}` : "Back to the look's own";
  const back = element("button", {
    type: "button", className: "reset", title: told, textContent: "↺", onclick: reset,
  });
  back.setAttribute("aria-label", `${spoken}: ${told.toLowerCase()}`);
  const made = element("div", { className: "row", title: help ?? "" }, name, control.value, back);
  if (control.wide) made.append(control.wide);
  if (help) {
    const described = element("span", { id: `${id}-help`, className: "aside", textContent: help });
    control.input.setAttribute("aria-describedby", described.id);
    made.append(described);
  }
  const update = () => {
    control.show(read());
    back.disabled = isDefault();
  };
  return { made, update, isChanged: () => !isDefault() };
}

/** A slider with a number beside it. */
function slider({ range: [least, most], unit, isWhole, set, label, isOpen }) {
  const { factor = 1, text = unit ?? "" } = DISPLAYED_UNITS[unit] ?? {};
  // A step of the arrow keys is a hundredth of the way.
  const step = isWhole ? Math.max(1, Math.round((most - least) / 100)) : (most - least) / 100;
  const input = element("input", {
    type: "range", min: least, max: most, step: isWhole ? 1 : "any",
  });
  input.onkeydown = (event) => {
    const way = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (!way) return;
    event.preventDefault();
    set(clampNumber(Number(input.value) + way * step, least, most));
  };
  // The slider is enough for whoever goes through the page by Tab.
  const number = element("input", { type: "number", step: "any", tabIndex: -1 });
  number.setAttribute("aria-label", `${label}, as a number`);
  number.onkeydown = (event) => {
    const way = { ArrowDown: -1, ArrowUp: 1 }[event.key];
    if (!way) return;
    event.preventDefault();
    number.value = shortNumber((number.valueAsNumber || 0) + way * step * factor);
    number.onchange();
  };
  input.oninput = () => set(Number(input.value));
  number.onchange = () => {
    const wanted = number.valueAsNumber / factor;
    if (!Number.isFinite(wanted)) return show(latest);
    const whole = isWhole ? Math.round(wanted) : wanted;
    set(isOpen ? Math.max(whole, least) : clampNumber(whole, least, most));
    show(latest);
  };
  let latest = least;
  const show = (value) => {
    latest = value;
    input.value = value;
    const share = (clampNumber(value, least, most) - least) / (most - least || 1);
    input.style.setProperty("--share", `${100 * share}%`);
    const shown = shortNumber(value * factor);
    input.setAttribute("aria-valuetext", `${shown}${text}`);
    if (number.value !== shown) number.value = shown;
  };
  const mark = text ? element("span", { className: "unit", textContent: text }) : null;
  const value = element("span", { className: "value" }, number, mark);
  return { input, value, wide: element("div", { className: "wide" }, input), show };
}

const clampNumber = (x, least, most) => Math.min(Math.max(x, least), most);

function colorWell({ set, toHex }) {
  const input = element("input", { type: "color" });
  input.oninput = () => set(input.value);
  return { input, value: input, show: (value) => (input.value = toHex(value)) };
}

function switchOf({ set }) {
  const input = element("input", { type: "checkbox", className: "switch" });
  input.setAttribute("role", "switch");
  input.onchange = () => set(input.checked);
  return { input, value: input, show: (value) => (input.checked = Boolean(value)) };
}

function choiceOf({ options, set }) {
  const words = options.map((word) => element("option", { textContent: word }));
  const input = element("select", {}, ...words);
  input.onchange = () => set(input.value);
  return { input, value: input, show: (value) => (input.value = value) };
}

/** Numbers side by side. */
function numbersOf({ count, set, read, label }) {
  const inputs = Array.from({ length: count }, (_, i) => {
    const input = element("input", { type: "number", step: "any" });
    input.setAttribute("aria-label", `${label} ${"xyzw"[i]}`);
    input.onchange = () => {
      const numbers = [...read()];
      if (Number.isFinite(input.valueAsNumber)) numbers[i] = input.valueAsNumber;
      else input.value = shortNumber(numbers[i]);
      set(numbers);
    };
    return input;
  });
  const wide = element("div", { className: "wide numbers" }, ...inputs);
  const show = (value) => inputs.forEach((input, i) => (input.value = shortNumber(value[i] ?? 0)));
  return { input: inputs[0], value: element("span"), wide, show };
}

/** What a value that is not live shows: it was decided when the shader was made. */
function fixed(value) {
  const text = Array.isArray(value) ? value.map(shortNumber).join(", ") : String(value);
  const input = element("output", { textContent: text });
  return { input, value: input, show: () => {} };
}

/** The control of a parameter; `null` for one that no control shows, such as a curve. */
function controlOf(player, parameter) {
  const { key, type, label, unit, options } = parameter;
  const set = (value) => player.set(key, value);
  const read = () => player.get(key);
  if (!parameter.live) return ["curve", "ramp"].includes(type) ? null : fixed(parameter.default);
  if (options?.length) return choiceOf({ options, set });
  switch (type) {
    case "float":
    case "int":
      return slider({ range: rangeOf(parameter), unit, isWhole: type === "int", set, label });
    case "bool":
    case "switch":
      return switchOf({ set });
    case "color":
      return colorWell({ set, toHex: (value) => player.hexOf(value) });
    case "vec2":
    case "vec3":
    case "vec4":
      return numbersOf({ count: Number(type[3]), set, read, label });
    default:
      return null;
  }
}

/** A value of a parameter in words, as its control shows it. */
function wordsOf(player, { type, unit }, value) {
  if (type === "color") return player.hexOf(value);
  if (typeof value === "boolean") return value ? "on" : "off";
  const { factor = 1, text = unit ? ` ${unit}` : "" } = DISPLAYED_UNITS[unit] ?? {};
  if (typeof value === "number") return `${shortNumber(value * factor)}${text}`;
  return Array.isArray(value) ? value.map(shortNumber).join(", ") : String(value);
}

/** The row of a parameter. */
function parameterRow(player, parameter) {
  const { key, label, help, group } = parameter;
  const spoken = group ? `${group}: ${label}` : label;
  const control = controlOf(player, { ...parameter, label: spoken });
  if (!control) return null;
  const found = row({
    label,
    spoken,
    help: parameter.live ? help : "Decided when the look was exported.",
    control,
    read: () => player.get(key),
    reset: () => player.reset(key),
    isDefault: () => !(key in player.values),
    own: wordsOf(player, parameter, parameter.default),
  });
  found.made.dataset.parameter = key;
  if (!parameter.live) found.made.classList.add("is-fixed");
  return { ...found, keys: [key] };
}

/** The row of a light: its color, and how bright it is. */
function lightRow(player, light) {
  const { id, label } = light;
  const name = label || id;
  const spoken = `Light ${name}`;
  const color = colorWell({
    set: (hex) => player.light(id, { color: hex }),
    toHex: (value) => player.hexOf(value),
  });
  color.input.setAttribute("aria-label", `${spoken}: color`);
  const bright = slider({
    range: [0, Math.max(2, 2 * light.intensity)],
    set: (value) => player.light(id, { intensity: value }),
    label: `${spoken}: intensity`,
    isOpen: true,
  });
  const value = element("span", { className: "value" }, color.input, bright.value);
  const show = (now) => {
    color.show(now.color);
    bright.show(now.intensity);
  };
  const fields = ["color", "intensity", "direction", "position", "aim"];
  const isOwn = (field) => String(player.lightNow(id)[field]) === String(light[field]);
  return row({
    label: name,
    spoken: `${spoken}: intensity`,
    help: "The light's color, and how bright it is. To turn it, choose it below the picture.",
    control: { ...bright, value, show },
    read: () => player.lightNow(id),
    reset: () => player.resetLight(id),
    isDefault: () => fields.every(isOwn),
    own: `intensity ${shortNumber(light.intensity)}, and where it was`,
  });
}

/** The row that tells how far all lights were turned together. */
function illuminationRow(player) {
  const input = element("output");
  const angle = () => {
    const own = player.scene.illumination;
    const trace = player.illumination.reduce((sum, x, i) => sum + x * own[i], 0);
    return Math.acos(clampNumber((trace - 1) / 2, -1, 1));
  };
  const show = (value) => {
    const degrees = Math.round(value * 180 / Math.PI);
    input.textContent = degrees ? `turned by ${degrees}°` : "as they were";
  };
  const found = row({
    label: "All lights",
    help: "Drag with Shift to turn all lights together.",
    control: { input, value: input, show },
    read: angle,
    reset: () => player.resetIllumination(),
    isDefault: () => String(player.illumination) === String(player.scene.illumination),
    own: "where they were",
  });
  return found;
}
