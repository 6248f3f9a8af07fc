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
