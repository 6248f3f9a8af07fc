// What pages use: `chiaro.open` for a player of one's own, and the rest for the first player of the
// page.

const opening = Promise.withResolvers?.() ?? {};
opening.promise ??= new Promise((resolve, reject) => Object.assign(opening, { resolve, reject }));
// Who awaits `ready` is told of a failure; the page tells it anyway.
opening.promise.catch(() => {});

/** The first player of the page. */
let first = null;

const player = () => {
  if (!first) throw new Error("nothing is drawn yet: await chiaro.ready");
  return first;
};

window.chiaro = {
  /** The first player of the page, as soon as it draws; rejects where it cannot. */
  ready: opening.promise,

  /** The first player of the page, once it draws. */
  get player() {
    return player();
  },

  /**
   * Draws an export on a canvas: `await chiaro.open(canvas, chiaroExports["clay"])`. The result
   * has the methods below.
   *
   * @param options `api` and `samples`, as the player takes them; `gestures`: `false` for a
   *   canvas that is not dragged; `wheel`: `true`, `"focus"`, `"ctrl"` or `false`.
   */
  async open(canvas, content, options = {}) {
    try {
      const found = await Player.open(canvas, content, options);
      if (options.gestures !== false) found.gestures = new Gestures(found, options);
      // With the next frame of the page, which has laid itself out and set its values by then.
      found.invalidate();
      first ??= found;
      opening.resolve(found);
      return found;
    } catch (failure) {
      opening.reject(failure);
      throw failure;
    }
  },

  /** Sets an exposed parameter: `chiaro.set("warmth", 0.3)`. */
  set: (key, value) => player().set(key, value),

  /** The value of an exposed parameter. */
  get: (key) => player().get(key),

  /** Sets fields of a light, in its own frame: `chiaro.light("key", { intensity: 2 })`. */
  light: (id, fields) => player().light(id, fields),

  /** Gives a light the values that it has in the look. */
  resetLight: (id) => player().resetLight(id),

  /** Shows the look on a mesh of the page's own: arrays of `positions`, `indices`, `normals`... */
  wear: (mesh) => player().wear(mesh),

  /** Gives everything, or one parameter, the value that it has in the look. */
  reset: (key) => player().reset(key),

  /** The picture at any size, as `ImageData`: `await chiaro.picture(1920, 1080)`. */
  picture: (width, height, options) => player().picture(width, height, options),
};
