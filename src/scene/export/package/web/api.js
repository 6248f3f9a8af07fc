// What pages use: `chiaro.open` for a player of one's own, and the rest for the first player of the
// page.

let opened;

const ready = new Promise((resolve) => {
  opened = resolve;
});

/** The first player of the page. */
let first = null;

const player = () => {
  if (!first) throw new Error("nothing is drawn yet: await chiaro.ready");
  return first;
};

window.chiaro = {
  /** The first player of the page, as soon as it draws. */
  ready,

  /**
   * Draws a look on a canvas: `await chiaro.open(canvas, { look, scene, textures })`. The result
   * has the methods below. Without `gestures: false` the canvas is dragged with the pointer.
   */
  async open(canvas, content, options = {}) {
    const found = await Player.open(canvas, content, options);
    if (options.gestures !== false) found.gestures = new Gestures(found);
    found.draw();
    first ??= found;
    opened(found);
    return found;
  },

  /** Sets an exposed parameter: `chiaro.set("warmth", 0.3)`. */
  set: (key, value) => player().set(key, value),

  /** The value of an exposed parameter. */
  get: (key) => player().get(key),

  /** Sets fields of a light, in its own frame: `chiaro.light("key", { intensity: 2 })`. */
  light: (id, fields) => player().light(id, fields),

  /** Gives everything, or one parameter, the value that it has in the look. */
  reset: (key) => player().reset(key),

  /** The picture at any size, as `ImageData`: `await chiaro.picture(1920, 1080)`. */
  picture: (width, height, options) => player().picture(width, height, options),
};
