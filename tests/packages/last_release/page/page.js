// A highlight, moved: made by Chiaro 0.1.0. This is the page's tools and settings.
(() => {
"use strict";

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

// Which parameters change the picture as everything else is set: a layer may cover another, and an
// angle at its end leaves nothing for the next one. What has no effect is shown quietly; it can be
// set all the same.

/** Width and height of the pictures that are compared. */
const TRIAL_SIDE = 96;

/** Difference of a number of a color that is seen, and of how many numbers. */
const SEEN = { difference: 1 / 200, count: 4 };

/** Shares of a range at which a number is tried. */
const TRIED = [0.02, 0.3, 0.7, 1];

/** Time without a change, in milliseconds, before anything is tried. */
const QUIET = 600;

/** The longest time of a trial, in milliseconds, on a graphics card that is asked again. */
const PATIENCE = 150;

/** Trials in that time or longer, after which none is made any more. */
const SLOW_TRIALS = 4;

/** Values that a parameter is tried with. */
function triedValues(player, parameter) {
  const { key, type, options } = parameter;
  const now = player.get(key);
  if (options?.length) return options.filter((word) => word !== now);
  switch (type) {
    case "bool":
    case "switch":
      return [!now];
    case "color":
      return ["#ff00ff", "#00ff00"];
    case "float":
    case "int": {
      const [least, most] = rangeOf(parameter);
      const values = TRIED.map((share) => least + share * (most - least));
      return type === "int" ? values.map(Math.round) : values;
    }
    default:
      return Array.isArray(now) ? [now.map((x) => x + 0.5), now.map((x) => x - 0.5)] : [];
  }
}

function isSeen(one, other) {
  let count = 0;
  for (let i = 0; i < one.length; i++) {
    if (Math.abs(one[i] - other[i]) > SEEN.difference && (count += 1) > SEEN.count) return true;
  }
  return false;
}

const pause = (time) => new Promise((resolve) => setTimeout(resolve, time));

/** Tries the parameters of rows that are shown, whenever nothing has changed for a while. */
class Effects {
  /** @param listed gives the keys to try now; `tell(key, hasEffect)` hears what was found. */
  constructor(player, listed, tell) {
    Object.assign(this, { player, listed, tell });
    this.turn = 0;
    for (const event of ["value", "light", "view", "reset", "mesh", "api"]) {
      player.addEventListener(event, () => this.again());
    }
    this.again();
  }

  /** Begins anew once the page is at rest. */
  again() {
    clearTimeout(this.awaited);
    this.turn += 1;
    this.awaited = setTimeout(() => this.run(this.turn).catch(() => {}), QUIET);
  }

  async run(turn) {
    const { player } = this;
    // A picture that moves by itself would tell nothing, and a slow card has better things to do.
    if (player.isPlaying || !player.executor || this.slowTrials >= SLOW_TRIALS) return;
    const keys = this.listed();
    if (!keys.length) return;
    if (player.isDrawing) return this.again();
    const now = await player.trial({}, TRIAL_SIDE);
    const begun = performance.now();
    await player.trial({}, TRIAL_SIDE);
    if (turn !== this.turn) return;
    if (performance.now() - begun > PATIENCE) {
      // A machine that is busy for a moment is asked again.
      this.slowTrials = (this.slowTrials ?? 0) + 1;
      if (this.slowTrials < SLOW_TRIALS) this.again();
      return;
    }
    for (const key of keys) {
      const parameter = player.look.parameters.find((one) => one.key === key);
      if (!parameter?.live) continue;
      let hasEffect = false;
      for (const value of triedValues(player, parameter)) {
        if (turn !== this.turn || !player.executor) return;
        hasEffect = isSeen(now, await player.trial({ [key]: value }, TRIAL_SIDE));
        if (hasEffect) break;
        await pause(0);
      }
      if (turn !== this.turn) return;
      this.tell(key, hasEffect);
    }
  }
}

// A link to the page as it is: what was changed stands behind the # of its address.

const LINK = "set=";

const rounded = (value) =>
  JSON.parse(JSON.stringify(value, (_, x) => (typeof x === "number" ? +x.toPrecision(6) : x)));

/** What differs from the look, as the end of an address. */
function linkOf(player) {
  const { values, lights, illumination, camera, scene } = player;
  const isOwn = (one, other) => JSON.stringify(one) === JSON.stringify(other);
  const changed = {
    values,
    lights,
    ...(isOwn(illumination, scene.illumination) ? {} : { illumination }),
    ...(isOwn(camera, scene.camera) ? {} : { camera }),
  };
  const address = location.href.split("#")[0];
  return `${address}#${LINK}${encodeURIComponent(JSON.stringify(rounded(changed)))}`;
}

/** Sets what the address says; what does not belong to this look, or is wrong, is passed over. */
function takeLink(player) {
  const text = location.hash.slice(1);
  if (!text.startsWith(LINK)) return;
  const attempt = (act) => {
    try {
      act();
    } catch (problem) {
      console.warn(`The link: ${problem.message}`);
    }
  };
  attempt(() => {
    const { values, lights, illumination, camera } =
      JSON.parse(decodeURIComponent(text.slice(LINK.length)));
    for (const [key, value] of Object.entries(values ?? {})) {
      attempt(() => player.set(key, value));
    }
    for (const [id, fields] of Object.entries(lights ?? {})) {
      attempt(() => player.light(id, fields));
    }
    const isNumbers = (list, count) =>
      Array.isArray(list) && list.length === count && list.every(Number.isFinite);
    if (isNumbers(illumination, 9)) player.illumination = illumination;
    const { eye, target, up } = camera ?? {};
    if ([eye, target, up].every((list) => isNumbers(list, 3))) {
      const height = Number.isFinite(camera.height) ? camera.height : player.camera.height;
      player.camera = { ...player.camera, eye, target, up, height };
    }
    player.invalidate();
    player.tell("view");
  });
}

// The panel: groups of rows that fold, with what concerns all of them at its top.

/** A group of rows under a heading that folds it; the heading is marked where a row was changed. */
function groupOf(title, rows) {
  const summary = element("summary", { textContent: title });
  const made = element("details", { className: "group" }, summary, ...rows.map((it) => it.made));
  const update = () => {
    rows.forEach((one) => one.update());
    summary.classList.toggle("is-changed", rows.some((one) => one.isChanged()));
  };
  const keys = rows.flatMap((one) => one.keys ?? []);
  return { title, made, update, keys };
}

/** Groups of the look's parameters, in the artist's order, after the lights. */
function groupsOf(player) {
  const { look } = player;
  const groups = new Map();
  const put = (group, found) => groups.set(group, [...(groups.get(group) ?? []), found]);
  for (const light of look.lights) put("Lights", lightRow(player, light));
  if (look.lights.length > 1) put("Lights", illuminationRow(player));
  for (const parameter of look.parameters) {
    const found = parameterRow(player, parameter);
    if (found) put(parameter.group || "Look", found);
  }
  return [...groups].map(([title, rows]) => groupOf(title, rows));
}

/** While the button is held, the picture is that of the look without changes. */
function holdToCompare(player, button) {
  let kept = null;
  const show = () => {
    if (kept) return;
    const { values, lights, illumination } = player;
    kept = { values, lights, illumination };
    const own = { values: {}, lights: {}, illumination: [...player.scene.illumination] };
    Object.assign(player, own);
    player.invalidate();
    button.classList.add("is-on");
  };
  const giveBack = () => {
    if (!kept) return;
    Object.assign(player, kept);
    kept = null;
    player.invalidate();
    button.classList.remove("is-on");
  };
  button.onpointerdown = (event) => {
    button.setPointerCapture(event.pointerId);
    show();
  };
  button.onpointerup = giveBack;
  button.onpointercancel = giveBack;
  button.onblur = giveBack;
  button.onkeydown = (event) => [" ", "Enter"].includes(event.key) && show();
  button.onkeyup = giveBack;
}

/** Copies a link to what is shown now; the address of the page is that link, too. */
async function copyLink(player, button) {
  const link = linkOf(player);
  history.replaceState(null, "", link);
  const told = await navigator.clipboard?.writeText(link).then(
    () => "Copied", () => undefined,
  );
  const text = told ?? "The address of the page has it";
  byId("told").textContent = text;
  button.classList.add("is-on");
  setTimeout(() => {
    byId("told").textContent = "";
    button.classList.remove("is-on");
  }, 2500);
}

function fillPanel(player) {
  const groups = groupsOf(player);
  if (!groups.length) return;
  const first = groups.find(({ keys }) => keys.length);
  for (const group of [groups[0], first]) if (group) group.made.open = true;
  byId("groups").append(...groups.map(({ made }) => made));
  const compare = toolButton("compare", "Hold to see the look without your changes", null);
  holdToCompare(player, compare);
  const link = toolButton("link", "Copy a link to what you see", () => copyLink(player, link));
  const all = element("button", { type: "button", className: "all", textContent: "Reset all" });
  all.title = "Give everything the look's own values; the view stays";
  all.onclick = () => player.reset();
  byId("actions").append(compare, link, all);

  const update = () => {
    groups.forEach((group) => group.update());
    all.disabled = player.isUntouched;
    compare.disabled = player.isUntouched && !compare.classList.contains("is-on");
    markLights(player);
  };
  for (const event of ["value", "light", "view", "reset"]) player.addEventListener(event, update);
  update();
  byId("panel").hidden = false;
  showEffects(player, groups, first);
}

/** Shows quietly what has no effect now. */
function showEffects(player, groups, first) {
  const rows = new Map([...document.querySelectorAll("[data-parameter]")].map((made) =>
    [made.dataset.parameter, made]));
  const found = new Map();
  let isTouched = false;
  const open = () => groups.filter(({ made }) => made.open).flatMap(({ keys }) => keys);
  const tell = (key, hasEffect) => {
    found.set(key, hasEffect);
    const made = rows.get(key);
    made.classList.toggle("is-idle", !hasEffect);
    const note = "Changes nothing while the others are set like this.";
    const label = made.querySelector("label");
    label.dataset.help ??= label.title;
    label.title = hasEffect ? label.dataset.help : `${note} ${label.dataset.help}`;
    // The group that is open at the start has something to play with.
    const isDone = first.keys.every((one) => found.has(one));
    if (isTouched || !isDone || first.keys.some((one) => found.get(one))) return;
    const next = groups.slice(groups.indexOf(first) + 1).find(({ keys }) => keys.length);
    if (!next) return;
    first.made.open = false;
    next.made.open = true;
    first = next;
  };
  const effects = new Effects(player, open, tell);
  for (const { made } of groups) made.addEventListener("toggle", () => effects.again());
  byId("groups").addEventListener("pointerdown", () => (isTouched = true));
  byId("groups").addEventListener("keydown", () => (isTouched = true));
}

/** The colors of lights before their names, where lights differ in color. */
function markLights(player) {
  const colors = player.look.lights.map(({ id }) => player.hexOf(player.lightNow(id).color));
  const differ = colors.some((color) => color !== colors[0]);
  document.querySelectorAll("[data-light]").forEach((dot) => {
    const color = player.hexOf(player.lightNow(dot.dataset.light).color);
    dot.style.setProperty("--color", color);
    dot.hidden = !differ;
  });
}

// The page: the picture with its tools, a panel of settings, and words where something is wrong.

const byId = (id) => document.getElementById(id);

/** Icons of the tools, as paths in a box of 24. */
const ICONS = {
  home: "M4 11 12 4l8 7M6 10v10h12V10",
  play: "M8 5v14l11-7z",
  pause: "M8 5v14M16 5v14",
  save: "M12 4v11m-5-5 5 5 5-5M5 20h14",
  full: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  help: "M9 9.2a3 3 0 1 1 4.3 2.7c-.9.5-1.3 1-1.3 2.1M12 17.6v.2",
  settings: "M4 7h9m4 0h3M4 17h3m4 0h9M15 4.5v5M9 14.5v5",
  compare: "M12 4v16M9 6H4v12h5M15 6h5v12h-5",
  link: "M10 14a4 4 0 0 0 5.7 0l3-3A4 4 0 0 0 13 5.3l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 "
    + "5.7 5.7l1-1",
};

function icon(name) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  made.setAttribute("viewBox", "0 0 24 24");
  made.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", ICONS[name]);
  made.append(path);
  return made;
}

function toolButton(name, label, onclick) {
  const made = element("button", {
    type: "button", className: `plain ${name}`, title: label, onclick,
  });
  made.setAttribute("aria-label", label);
  made.append(icon(name));
  return made;
}

const query = new URLSearchParams(location.search);

/** True but where the page's address says `?NAME=0`, as the address of a frame may. */
const isWanted = (name) => query.get(name) !== "0";

/** The API that the page's address asks for: `?api=webgl2`. */
const wantedApi = () => query.get("api")?.toLowerCase() || undefined;

/** Tells on the page what is wrong, and what helps. */
function tellProblem(title, advice, reason) {
  byId("waiting").hidden = true;
  const said = reason ? element("p", { className: "reason", textContent: reason }) : null;
  const heading = element("h2", { textContent: title });
  const parts = [heading, element("p", { textContent: advice }), said];
  byId("problem").replaceChildren(...parts.filter(Boolean));
  byId("problem").hidden = false;
}

/** What a drag turns: the view, or one of the lights. */
function subjects(player) {
  const choices = [
    { id: "view", label: "View", key: "V" },
    ...player.look.lights.map(({ id, label }, i) => ({ id, label: label || id, key: `${i + 1}` })),
  ];
  const options = choices.map(({ id, label, key }) => {
    const input = element("input", { type: "radio", name: "subject", value: id });
    input.checked = id === "view";
    input.onchange = () => choose(id);
    // A click leaves the keys to the picture; who goes by keys stays among the choices.
    input.onpointerup = () => setTimeout(() => player.canvas.focus({ preventScroll: true }));
    const light = player.look.lights.find((one) => one.id === id);
    const dot = light ? element("span", { className: "dot", dataset: { light: id } }) : null;
    const name = element("span", { className: "word", textContent: label });
    const title = light ? `Drag turns this light (key ${key})` : `Drag turns the view (key ${key})`;
    return element("label", { title }, input, dot, name);
  });
  const choose = (id) => {
    player.gestures.subject = id;
    options.forEach(({ firstChild }) => (firstChild.checked = firstChild.value === id));
  };
  addEventListener("keydown", (event) => {
    const isTyping = event.target.matches?.('input[type="number"], input[type="text"], select');
    if (isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
    const found = choices.find(({ key }) => key.toLowerCase() === event.key.toLowerCase());
    if (!found) return;
    choose(found.id);
    player.canvas.focus({ preventScroll: true });
  });
  const made = element("fieldset", { className: "choices" }, ...options);
  made.setAttribute("aria-label", "A drag turns");
  return made;
}

function fillTools(player) {
  const tools = byId("tools");
  if (player.look.lights.length) tools.append(subjects(player));
  const resetView = () => player.gestures.resetView();
  tools.append(toolButton("home", "Show the view as at the start (Home)", resetView));
  if (player.isAnimated) {
    const button = toolButton("pause", "Stop", () => setPlaying(!player.isPlaying));
    const setPlaying = (isPlaying) => {
      player.play(isPlaying);
      const label = isPlaying ? "Stop" : "Play";
      button.replaceChildren(icon(isPlaying ? "pause" : "play"));
      button.title = label;
      button.setAttribute("aria-label", label);
    };
    setPlaying(!matchMedia("(prefers-reduced-motion: reduce)").matches);
    tools.append(button);
  }
  const saved = toolButton("save", "Save the picture as a PNG", () => save(player));
  saved.onpointerenter = () => {
    const [width, height] = player.pageSize;
    saved.title = `Save the picture as a PNG, transparent around, ${width} × ${height}`;
  };
  tools.append(saved);
  if (document.fullscreenEnabled) {
    const turnFull = () =>
      (document.fullscreenElement ? document.exitFullscreen() : document.body.requestFullscreen());
    tools.append(toolButton("full", "Fill the screen", turnFull));
  }
  tools.append(toolButton("help", "Help", () => byId("help").showModal()));
  byId("help").onclick = ({ target }) => target === byId("help") && byId("help").close();
  tools.hidden = !isWanted("tools");
}

/** Saves the picture as the page shows it, without the backdrop. */
async function save(player) {
  const [width, height] = player.pageSize;
  const picture = await player.picture(width, height, { camera: player.pageCamera });
  const canvas = element("canvas", { width, height });
  canvas.getContext("2d").putImageData(picture, 0, 0);
  canvas.toBlob((blob) => {
    const href = URL.createObjectURL(blob);
    element("a", { href, download: `${player.look.name}.png` }).click();
    setTimeout(() => URL.revokeObjectURL(href), 1000);
  });
}

/** The button that folds the panel, which a small page has folded at first. */
function fillFold() {
  const panel = byId("panel");
  if (panel.hidden) return;
  const button = toolButton("settings", "Settings", () => fold(!panel.hidden));
  const fold = (isFolded) => {
    panel.hidden = isFolded;
    button.setAttribute("aria-expanded", String(!isFolded));
    button.classList.toggle("is-on", !isFolded);
  };
  button.setAttribute("aria-controls", "panel");
  byId("corner").append(button);
  fold(!isWanted("panel") || Math.min(innerWidth, innerHeight) < 480);
  button.hidden = !isWanted("panel");
}

/** Says which API draws; a click draws by the other one. */
function tellApi(player) {
  const button = byId("api");
  const other = player.api === "WebGPU" ? "WebGL 2" : "WebGPU";
  button.textContent = player.api;
  button.title = [`Draw by ${other} instead`, ...player.failures].join("\n");
  button.onclick = () => {
    const address = new URL(linkOf(player));
    address.searchParams.set("api", other.toLowerCase().replace(" ", ""));
    history.replaceState(null, "", address);
    location.reload();
  };
  button.hidden = !isWanted("tools");
}

async function start() {
  const canvas = byId("picture");
  const exported = Object.values(window.chiaroExports ?? {})[0];
  const [r, g, b] = exported?.scene?.backdrop ?? [0.16, 0.165, 0.18];
  const byte = (x) => Math.round(255 * x);
  document.body.style.setProperty("--backdrop", `rgb(${byte(r)} ${byte(g)} ${byte(b)})`);
  try {
    // A bare picture lies in another page, which scrolls.
    const isBare = !isWanted("tools");
    document.body.classList.toggle("is-bare", isBare);
    const wheel = isBare ? "focus" : true;
    const player = await chiaro.open(canvas, exported, { api: wantedApi(), wheel });
    byId("waiting").hidden = true;
    tellApi(player);
    player.addEventListener("api", () => tellApi(player));
    player.addEventListener("lost", ({ detail }) => tellProblem(
      "The picture stopped.", "Reload the page to draw it again.", detail,
    ));
    takeLink(player);
    fillTools(player);
    fillPanel(player);
    fillFold();
    markLights(player);
    byId("hint").hidden = false;
    player.addEventListener("view", () => (byId("hint").hidden = true), { once: true });
  } catch (failure) {
    console.error(failure);
    const advice = wantedApi()
      ? `The address of the page asks for api=${wantedApi()}. Leave that out, and the page takes `
        + "WebGPU or WebGL 2, whichever works."
      : "It needs WebGPU or WebGL 2. Open the page in a new Chrome, Edge, Firefox or Safari, and "
        + "see that graphics acceleration is turned on in its settings.";
    tellProblem("This look cannot be drawn here.", advice, failure.message);
  }
}

start();
})();
