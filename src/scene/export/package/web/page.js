// The page: the picture with its tools, a panel of settings, and words where something is wrong.

const byId = (id) => document.getElementById(id);

/** Icons of the tools, as paths in a box of 24. */
const ICONS = {
  home: "M4 11 12 4l8 7M6 10v10h12V10",
  play: "M8 5v14l11-7z",
  pause: "M8 5v14M16 5v14",
  save: "M12 4v11m-5-5 5 5 5-5M5 20h14",
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
  const made = element("button", { type: "button", className: "plain", title: label, onclick });
  made.setAttribute("aria-label", label);
  made.append(icon(name));
  return made;
}

/** The API that the page's address asks for: `?api=webgl2` or `#webgl2`. */
function wantedApi() {
  const inQuery = new URLSearchParams(location.search).get("api");
  const inHash = location.hash.slice(1);
  return inQuery ?? (["webgpu", "webgl2"].includes(inHash) ? inHash : undefined);
}

/** Tells on the page what is wrong, and what helps. */
function tellProblem(title, advice, reason) {
  byId("waiting").hidden = true;
  const said = reason ? element("p", { className: "reason", textContent: reason }) : null;
  const heading = element("h2", { textContent: title });
  const parts = [heading, element("p", { textContent: advice }), said];
  byId("problem").replaceChildren(...parts.filter(Boolean));
  byId("problem").hidden = false;
}

/** What a drag turns: the view, all lights, or one of them. */
function subjects(player) {
  const choices = [
    { id: "view", label: "View", key: "V" },
    ...player.look.lights.map(({ id, label }, i) => ({ id, label: label || id, key: `${i + 1}` })),
  ];
  const options = choices.map(({ id, label, key }) => {
    const input = element("input", { type: "radio", name: "subject", value: id });
    input.checked = id === "view";
    input.onchange = () => choose(id);
    const light = player.look.lights.find((one) => one.id === id);
    const dot = light ? element("span", { className: "dot", dataset: { light: id } }) : null;
    const name = element("span", { textContent: label });
    const title = light ? `Drag turns this light (key ${key})` : `Drag turns the view (key ${key})`;
    return element("label", { title }, input, dot, name);
  });
  const choose = (id) => {
    player.gestures.subject = id;
    options.forEach(({ firstChild }) => (firstChild.checked = firstChild.value === id));
  };
  addEventListener("keydown", (event) => {
    if (event.target.matches?.("input, select") || event.ctrlKey || event.metaKey) return;
    const found = choices.find(({ key }) => key.toLowerCase() === event.key.toLowerCase());
    if (found) choose(found.id);
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
  tools.append(toolButton("save", "Save the picture as a PNG", () => save(player)));
  tools.hidden = false;
}

/** Saves the picture as the page shows it, without the backdrop. */
async function save(player) {
  const { width, height } = player.canvas;
  const picture = await player.picture(width, height, { camera: player.pageCamera });
  const canvas = element("canvas", { width, height });
  canvas.getContext("2d").putImageData(picture, 0, 0);
  canvas.toBlob((blob) => {
    const href = URL.createObjectURL(blob);
    element("a", { href, download: `${player.look.name}.png` }).click();
    setTimeout(() => URL.revokeObjectURL(href), 1000);
  });
}

function fillPanel(player) {
  const { look } = player;
  const rows = [];
  const section = (title, found) => {
    const kept = found.filter(Boolean);
    if (!kept.length) return;
    rows.push(...kept);
    const heading = element("h2", { textContent: title });
    byId("panel").append(element("section", {}, heading, ...kept.map(({ made }) => made)));
  };
  const groups = new Map();
  for (const parameter of look.parameters) {
    const group = parameter.group || "Look";
    groups.set(group, [...(groups.get(group) ?? []), parameterRow(player, parameter)]);
  }
  for (const [group, found] of groups) section(group, found);
  section("Lights", look.lights.map((light) => lightRow(player, light)));
  const all = element("button", { type: "button", className: "all", textContent: "Reset all" });
  all.onclick = () => player.reset();
  const help = "Drag turns what is chosen below the picture; with Shift all lights. The wheel or "
    + "two fingers go nearer.";
  const keys = " Keys: arrows turn, + and - go nearer, Home resets the view.";
  const text = element("p", { className: "help", textContent: help });
  text.append(element("span", { className: "keys", textContent: keys }));
  byId("panel").append(all, text);
  const update = () => {
    rows.forEach((one) => one.update());
    all.disabled = player.isUntouched;
    for (const dot of document.querySelectorAll("[data-light]")) {
      dot.style.setProperty("--color", player.hexOf(player.lightNow(dot.dataset.light).color));
    }
  };
  for (const event of ["value", "light", "view", "reset"]) player.addEventListener(event, update);
  update();
  byId("panel").hidden = !rows.length;
}

async function start() {
  const canvas = byId("picture");
  const [r, g, b] = scene.backdrop ?? [0.16, 0.165, 0.18];
  const byte = (x) => Math.round(255 * x);
  document.body.style.setProperty("--backdrop", `rgb(${byte(r)} ${byte(g)} ${byte(b)})`);
  canvas.setAttribute("role", "application");
  const told = "Arrow keys turn it, plus and minus go nearer, Home resets the view.";
  canvas.setAttribute("aria-label", `${look.name}: a picture that can be turned. ${told}`);
  try {
    const player = await chiaro.open(canvas, { look, scene, textures }, { api: wantedApi() });
    byId("waiting").hidden = true;
    byId("api").textContent = player.api;
    byId("api").title = player.failures.join("\n");
    byId("api").hidden = false;
    player.addEventListener("lost", ({ detail }) => tellProblem(
      "The picture stopped.", "Reload the page to draw it again.", detail,
    ));
    fillTools(player);
    fillPanel(player);
  } catch (failure) {
    console.error(failure);
    const advice = wantedApi()
      ? `The address of the page asks for ${wantedApi()}. Without that it takes what there is.`
      : "It needs WebGPU or WebGL 2. Open the page in a new Chrome, Edge, Firefox or Safari, and "
        + "see that graphics acceleration is turned on in its settings.";
    tellProblem("This look cannot be drawn here.", advice, failure.message);
  }
}

start();
