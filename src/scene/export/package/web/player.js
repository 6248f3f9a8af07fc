// The player: draws a look on a canvas, and draws again when something has changed. A page at rest
// costs nothing.

/** True for an image whose numbers the sampler turns into linear light. */
const isDecodedBySampling = (look, index) =>
  look.colorSpace === "linear" && look.images[index].encoding === "color"
  && look.images[index].kind !== "hcbtf";

/** Executors, in the order in which they are tried. */
const EXECUTORS = { webgpu: WebGpuExecutor, webgl2: WebGl2Executor };

/** The most device pixels for a pixel of the page. */
const MOST_PIXELS = 2;

/** The longest side of the picture on the page, in device pixels. */
const MOST_SIDE = 4096;

/** A device that is lost within this time, in milliseconds, had not drawn well at all. */
const EARLY = 5000;

/** Names of drivers that draw without a graphics card. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Frames that take longer than this, in milliseconds, are drawn coarser while things move. */
const SLOW = 50;

/** Time without a change, in milliseconds, after which the picture is drawn finely again. */
const REST = 200;

/** The canvas that events and styles are given to; a new one where another API has taken it. */
function freshCanvas(canvas) {
  const fresh = canvas.cloneNode(false);
  canvas.replaceWith(fresh);
  return fresh;
}

class Player extends EventTarget {
  /**
   * Draws a look on a canvas. Rejects, with the reason in words, where that cannot be.
   *
   * @param canvas a canvas of the page; a fresh one takes its place where an API fails on it.
   * @param content `look`, `scene` and `textures`, as the package's scripts define them.
   * @param options `api`: `webgpu` or `webgl2`, else the first that works. `samples`: 1, or 4 for
   *   smooth edges.
   */
  static async open(canvas, content, { api, samples = 4 } = {}) {
    checkContent(content);
    const { look, scene, textures = {} } = content;
    const player = new Player();
    const images = await readImages(look, textures);
    const mesh = readMesh(scene.mesh);
    mesh.isMirrored = determinant3(linear3(mesh.worldFromObject)) < 0;
    Object.assign(player, { canvas, look, scene, mesh, samples });
    player.content = { look, mesh, images, samples };
    player.camera = { ...scene.camera };
    player.reset();
    const wanted = api?.toLowerCase();
    if (wanted && !EXECUTORS[wanted]) throw new Error(`api is "webgpu" or "webgl2", not "${api}"`);
    player.failures = [];
    await player.begin(wanted ? [wanted] : Object.keys(EXECUTORS));
    player.watchSize();
    return player;
  }

  /** Draws by the first of some APIs that works; a canvas that one has failed on is replaced. */
  async begin(names) {
    for (const [at, name] of names.entries()) {
      if (this.failures.length) this.canvas = freshCanvas(this.canvas);
      try {
        this.executor = await EXECUTORS[name].create(this.canvas, this.content);
        this.begun = performance.now();
        // Software shows something soon, and then the same finely.
        this.slowness = SOFTWARE.test(this.executor.driver) ? Infinity : 0;
        this.executor.onLost((reason) => this.recover(reason, names.slice(at + 1)));
        return;
      } catch (failure) {
        this.failures.push(`${name}: ${failure.message}`);
      }
    }
    throw new Error(this.failures.join("; "));
  }

  /** Goes on by another API where the first was lost at once; tells of it where none is left. */
  async recover(reason, others) {
    const { executor } = this;
    if (!executor) return;
    this.executor = null;
    const told = reason || "the graphics card was lost";
    try {
      if (!others.length || performance.now() - this.begun > EARLY) throw new Error(told);
      this.failures.push(`${executor.label}: ${told}`);
      await this.begin(others);
      this.sizes.disconnect();
      this.watchSize();
      this.gestures?.listen();
      this.isDrawing = false;
      this.draw();
      this.tell("api");
    } catch (failure) {
      this.isPlaying = false;
      this.tell("lost", failure.message);
    }
  }

  /** Name of the API that draws: `WebGPU` or `WebGL 2`. */
  get api() {
    return this.executor?.label;
  }

  // Values.

  /** Sets an exposed parameter by the name that the artist gave it. */
  set(key, value) {
    const parameter = this.parameter(key);
    const checked = checkedValue(parameter, value);
    // Keys move a value only while it is not set.
    if (!parameter.keyed && this.isSame(parameter, checked)) delete this.values[key];
    else this.values[key] = checked;
    this.invalidate();
    this.tell("value", key);
  }

  /** The value of an exposed parameter. */
  get(key) {
    const parameter = this.parameter(key);
    return key in this.values ? this.values[key] : parameter.default;
  }

  parameter(key) {
    const found = this.look.parameters.find((one) => one.key === key);
    if (found) return found;
    const known = this.look.parameters.map((one) => one.key).join(", ");
    throw new Error(`there is no parameter ${key}; there are: ${known || "none"}`);
  }

  /** True for the value that a parameter has in the look. */
  isSame({ type, default: own }, value) {
    if (type === "color") {
      return this.hexOf(value) === this.hexOf(own) && this.isAsOpaque(value, own);
    }
    return String(value) === String(own);
  }

  /** True for colors of the same alpha. */
  isAsOpaque(...colors) {
    const alphaOf = (color) =>
      typeof color === "string" ? colorFromHex(color)[3] : (color[3] ?? 1);
    const [first, second] = colors.map(alphaOf);
    return Math.abs(first - second) < 1 / 512;
  }

  /** Sets fields of a light, in its own frame: `direction`, `position`, `color`, `intensity`... */
  light(id, fields) {
    const light = this.look.lights.find((one) => one.id === id);
    if (!light) {
      const known = this.look.lights.map((one) => one.id).join(", ");
      throw new Error(`there is no light ${id}; there are: ${known || "none"}`);
    }
    const checked = checkedFields(light, fields, (hex) => this.numbersOfHex(hex));
    this.lights[id] = { ...this.lights[id], ...checked };
    this.invalidate();
    this.tell("light", id);
  }

  /** A light as it is now: with the look's values, those of parameters, and those that are set. */
  lightNow(id) {
    return lightNow(this.look, { parameters: this.values, lights: this.lights }, id);
  }

  /** Gives everything, or one parameter, the value that it has in the look. The view stays. */
  reset(key) {
    if (key !== undefined) {
      this.get(key);
      delete this.values[key];
      this.tell("value", key);
    } else {
      this.values = {};
      this.lights = {};
      this.illumination = [...this.scene.illumination];
      this.time = 0;
      this.tell("reset");
    }
    this.invalidate();
  }

  /** Gives a light the values that it has in the look. */
  resetLight(id) {
    delete this.lights[id];
    this.invalidate();
    this.tell("light", id);
  }

  /** Turns all lights back, which were turned together. */
  resetIllumination() {
    this.illumination = [...this.scene.illumination];
    this.invalidate();
    this.tell("view");
  }

  /** True while everything is as the look has it, but for the view. */
  get isUntouched() {
    const isTurned = this.illumination.some((x, i) => x !== this.scene.illumination[i]);
    return !isTurned && ![this.values, this.lights].some((set) => Object.keys(set).length);
  }

  /** `#rrggbb` of a color of the look, or of one that is written so already. */
  hexOf(color) {
    if (typeof color === "string") return color.slice(0, 7);
    return hexFromColor(this.look.colorSpace === "linear" ? color.map(encode) : color);
  }

  /** The numbers of a color that is written as `#rrggbb`, in the look's own space. */
  numbersOfHex(hex) {
    const [r, g, b, a] = colorFromHex(hex);
    return this.look.colorSpace === "linear" ? [decode(r), decode(g), decode(b), a] : [r, g, b, a];
  }

  /** True where the picture changes with time. */
  get isAnimated() {
    const bytes = (time) => {
      const now = this.state(this.view([64, 64]), [64, 64]);
      const state = { ...now, time, frame: Math.floor(time * 24) };
      return Object.values(this.look.modules).flatMap(({ prepare }) =>
        prepare ? [...new Uint8Array(prepare(state))] : []);
    };
    const [first, ...others] = [0, 0.37, 1.9, 7.3].map((time) => String(bytes(time)));
    return others.some((other) => other !== first);
  }

  // Frames.

  view(size, camera = this.camera) {
    const clip = this.executor?.clip ?? { near: 0, far: 1 };
    return viewOf(camera, size, this.mesh.sphere, clip);
  }

  /** The shadow maps of a picture; `null` for a look that asks for none. */
  shadows(view, size) {
    if (!this.look.passes.some(({ draws }) => draws === "lights")) return null;
    const state = this.state(view, size);
    return shadowMaps(this.look, state, this.mesh.sphere, size[1], this.executor.clip);
  }

  /** The middle of the mesh's box, in world space. */
  get middle() {
    return transformPoint(this.mesh.worldFromObject, this.mesh.middle);
  }

  /** What `prepare` of the look asks for. */
  state(view, size, shadows) {
    const lights = { ...this.lights };
    for (const [id, place] of Object.entries(shadows?.places ?? {})) {
      lights[id] = { ...lights[id], shadow_map: place };
    }
    const parameters = Object.fromEntries(this.look.parameters.map(({ key, type }) => {
      const value = this.get(key);
      const isHex = type === "color" && typeof value === "string";
      return [key, isHex ? this.numbersOfHex(value) : value];
    }));
    const { rotation, eye, parallel, toward } = view;
    return {
      parameters,
      lights,
      illumination: this.illumination,
      camera: { rotation, eye, parallel, toward },
      object: {
        id: 0,
        axes: objectAxes(this.mesh.worldFromObject),
        middle: this.middle,
      },
      viewport: size,
      time: this.time,
      frame: Math.floor(24 * this.time),
    };
  }

  /** Everything that an executor asks for while it draws. */
  frame(size, samples, camera) {
    const view = this.view(size, camera);
    const shadows = this.shadows(view, size);
    const state = this.state(view, size, shadows);
    const looks = new Map();
    const lookBytes = (module) => {
      if (!looks.has(module)) looks.set(module, this.look.modules[module].prepare(state));
      return looks.get(module);
    };
    // `number` is that of a part of the mesh, or of a layer of shadow maps.
    const objectBytes = (binding, number) =>
      pack(binding, objectValues(this.mesh, this.mesh.parts[number].material));
    const bytes = (module, binding, number) => {
      switch (binding.feed.from) {
        case "look": return lookBytes(module);
        case "view": return pack(binding, viewValues(view));
        case "object": return objectBytes(binding, number);
        case "light_layer": return pack(binding, shadows.layers[number]);
        case "light_caster": return pack(binding, casterValues(this.mesh));
        default: return pack(binding, numbersOf(view, size, samples));
      }
    };
    const { center, radius } = this.mesh.sphere;
    const isWithin = length(subtract(view.eye, center)) < radius;
    const drawsBoth = (pass, part) => part.twoSided || isWithin || this.cuts(pass, state);
    return { size, samples, bytes, drawsBoth, shadows };
  }

  /** True where the look cuts parts away, so that backs are seen through them. */
  cuts(pass, state) {
    const by = pass.sides_parameter;
    const key = typeof by === "number" ? this.look.parameters[by]?.key : by;
    return key === undefined || key === null
      ? pass.sides === "both"
      : Number(state.parameters[key]) > 0;
  }

  /** Has the page drawn again before it is shown next, or once the frame before is done. */
  invalidate() {
    this.changed = performance.now();
    this.schedule();
  }

  /** Asks for the next frame. */
  schedule() {
    if (!this.executor || this.awaited) return;
    if (this.isDrawing) {
      this.isBehind = true;
      return;
    }
    this.awaited = requestAnimationFrame((now) => {
      this.awaited = 0;
      if (this.isPlaying) {
        this.time += Math.min((now - (this.last ?? now)) / 1000, 0.1);
        this.last = now;
        this.invalidate();
      }
      this.draw();
    });
  }

  play(isPlaying) {
    this.isPlaying = isPlaying;
    this.last = undefined;
    this.invalidate();
  }

  /** The camera of the page: a page that is higher than wide shows as much in width. */
  get pageCamera() {
    return { ...this.camera, aspect: this.camera.aspect || 1 };
  }

  draw() {
    if (!this.executor) return;
    if (this.isDrawing) {
      this.isBehind = true;
      return;
    }
    clearTimeout(this.resting);
    // What is slow is drawn with half the width and height while it moves.
    const isMoving = this.isPlaying || performance.now() - this.changed < REST;
    const isCoarse = this.slowness > SLOW && isMoving;
    const size = this.pageSize.map((side) => (isCoarse ? Math.ceil(side / 2) : side));
    if (!size[0] || !size[1]) return;
    if (size[0] !== this.canvas.width || size[1] !== this.canvas.height) {
      [this.canvas.width, this.canvas.height] = size;
    }
    try {
      this.executor.show(this.frame(size, this.samples, this.pageCamera));
      this.drawn = (this.drawn ?? 0) + 1;
      this.tell("drawn");
    } catch (failure) {
      this.isPlaying = false;
      this.tell("lost", failure.message);
      return;
    }
    this.isDrawing = true;
    const begun = performance.now();
    const { executor } = this;
    executor.finished().then(() => {
      if (executor !== this.executor) return;
      this.isDrawing = false;
      // The first frame counts little: drivers finish shaders during it.
      if (!isCoarse && this.drawn > 1) this.slowness = performance.now() - begun;
      if (this.isBehind) {
        this.isBehind = false;
        this.schedule();
      } else if (isCoarse) {
        this.resting = setTimeout(() => this.draw(), REST);
      }
    }, () => (this.isDrawing = false));
  }

  /**
   * The picture at another size, as `ImageData`: straight RGBA of 8 bits, the top row first,
   * transparent where nothing is.
   *
   * @param options `camera`, else the page's; `samples`, 1 or 4, else the page's.
   */
  async picture(width, height, { camera, samples = this.samples } = {}) {
    const whole = { ...this.camera, ...camera };
    const numbers = await this.executor.read(this.frame([width, height], samples, whole));
    const isLinear = this.look.colorSpace === "linear";
    const pixels = new Uint8ClampedArray(numbers.length);
    for (let at = 0; at < numbers.length; at += 4) {
      const alpha = numbers[at + 3];
      for (let i = 0; i < 3; i++) {
        const straight = alpha > 0 ? numbers[at + i] / alpha : 0;
        const shown = isLinear ? encode(Math.max(straight, 0)) : straight;
        pixels[at + i] = Math.floor(255 * clamp(shown, 0, 1) + 0.5);
      }
      pixels[at + 3] = Math.floor(255 * clamp(alpha, 0, 1) + 0.5);
    }
    return new ImageData(pixels, width, height);
  }

  /** Width and height of the picture on the page, in device pixels. */
  get pageSize() {
    const pixels = Math.min(devicePixelRatio || 1, MOST_PIXELS);
    const { clientWidth, clientHeight } = this.canvas;
    const sideOf = (side) => Math.min(Math.round(side * pixels), MOST_SIDE);
    return [clientWidth, clientHeight].map(sideOf);
  }

  /** The numbers of the picture with other values of parameters: a few pixels, to compare. */
  trial(values, side) {
    const own = this.values;
    this.values = { ...own, ...values };
    try {
      // Everything is asked for before the first wait.
      return this.executor.read(this.frame([side, side], 1, this.pageCamera));
    } finally {
      this.values = own;
    }
  }

  /** Draws again, at the right size, when the canvas has another one. */
  watchSize() {
    this.sizes = new ResizeObserver(() => {
      const [width, height] = this.pageSize;
      if (width !== this.canvas.width || height !== this.canvas.height) this.draw();
    });
    this.sizes.observe(this.canvas);
  }

  /**
   * Shows the look on a mesh of the page's own, brought to the size and the place of the first
   * one: `positions`, `indices`, `normals`, `uvs`, as arrays of numbers.
   */
  wear(given) {
    const wanted = Object.keys(this.mesh.attributes);
    const mesh = { ...meshOf(given, wanted, this.mesh.sphere), isMirrored: false };
    this.mesh = mesh;
    this.content.mesh = mesh;
    this.executor?.replaceMesh(mesh);
    this.invalidate();
    this.tell("mesh");
  }

  /** Tells listeners of `value`, `light`, `view`, `reset`, `mesh`, `drawn`, `api` or `lost`. */
  tell(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  /** Frees the graphics card. */
  close() {
    cancelAnimationFrame(this.awaited);
    clearTimeout(this.resting);
    this.sizes?.disconnect();
    this.gestures?.close();
    this.executor?.destroy();
    this.executor = null;
  }
}
