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
