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
    const isDrawn = () => (byId("waiting").hidden = true);
    player.addEventListener("drawn", isDrawn, { once: true });
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
