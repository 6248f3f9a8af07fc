// Gestures on the canvas: drags turn the view or a light, the wheel and two fingers go nearer.

/** Turn for a drag over the height of the canvas, in radians. */
const TURN = Math.PI;

/** Turn, and step nearer, for an arrow key. */
const STEP = { turn: Math.PI / 36, nearer: 1.08 };

class Gestures {
  /** Drags turn what `subject` names: `"view"`, `"lights"`, or the id of a light. */
  subject = "view";

  /**
   * @param wheel who may turn the wheel to come nearer: `true`, whoever is over the canvas;
   *   `"focus"`, whoever has clicked it; `"ctrl"`, whoever holds Ctrl; `false`, nobody. Otherwise
   *   the page scrolls.
   */
  constructor(player, { wheel = true } = {}) {
    if (![true, false, "focus", "ctrl"].includes(wheel)) {
      throw new Error(`wheel is true, false, "focus" or "ctrl", not ${JSON.stringify(wheel)}`);
    }
    this.player = player;
    this.wheelFor = wheel;
    this.listen();
  }

  /** Hears what happens on the player's canvas, which can be reached by the keyboard. */
  listen() {
    this.close();
    this.pointers = new Map();
    this.closing = new AbortController();
    const { canvas, look } = this.player;
    const { signal } = this.closing;
    const listen = (type, listener) =>
      canvas.addEventListener(type, listener, { passive: false, signal });
    listen("pointerdown", (event) => this.down(event));
    listen("pointermove", (event) => this.move(event));
    listen("pointerup", (event) => this.up(event));
    listen("pointercancel", (event) => this.up(event));
    listen("wheel", (event) => this.wheel(event));
    listen("keydown", (event) => this.key(event));
    listen("dblclick", () => this.resetView());
    listen("contextmenu", (event) => event.preventDefault());
    // A browser that scrolls by the same finger would break the drag off.
    canvas.style.touchAction = "none";
    if (!canvas.hasAttribute("tabindex")) canvas.tabIndex = 0;
    if (!canvas.hasAttribute("role")) canvas.setAttribute("role", "application");
    if (!canvas.hasAttribute("aria-label")) {
      const keys = "Arrow keys turn it, plus and minus go nearer, Home resets the view.";
      canvas.setAttribute("aria-label", `${look.name}: a picture that can be turned. ${keys}`);
    }
  }

  /** Hears nothing any more. */
  close() {
    this.closing?.abort();
  }

  down(event) {
    this.player.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  up(event) {
    this.pointers.delete(event.pointerId);
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const height = Math.max(this.player.canvas.clientHeight, 1);
    const [x, y] = subtract(now, before).map((way) => way / height);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers.set(event.pointerId, now);
    if (other) {
      // Two fingers: as near as they are apart, and sideways with their middle.
      const apart = (point) => Math.max(length(subtract(point, other)), 1);
      this.nearer(apart(before) / apart(now));
      this.pan(x / 2, y / 2);
    } else if (event.buttons & 6) {
      this.pan(x, y);
    } else {
      this.turn(x * TURN, y * TURN, event.shiftKey ? "lights" : this.subject);
    }
  }

  wheel(event) {
    const isOn = {
      ctrl: event.ctrlKey || event.metaKey,
      focus: document.activeElement === this.player.canvas,
    };
    if (!(isOn[this.wheelFor] ?? this.wheelFor)) return;
    event.preventDefault();
    const lines = event.deltaMode === 0 ? event.deltaY / 100 : event.deltaY / 3;
    this.nearer(1.15 ** clamp(lines, -3, 3));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const subject = event.shiftKey ? "lights" : this.subject;
    const steps = {
      ArrowLeft: () => this.turn(-STEP.turn, 0, subject),
      ArrowRight: () => this.turn(STEP.turn, 0, subject),
      ArrowUp: () => this.turn(0, -STEP.turn, subject),
      ArrowDown: () => this.turn(0, STEP.turn, subject),
      "+": () => this.nearer(1 / STEP.nearer),
      "=": () => this.nearer(1 / STEP.nearer),
      "-": () => this.nearer(STEP.nearer),
      Home: () => this.resetView(),
    };
    if (!steps[event.key]) return;
    event.preventDefault();
    steps[event.key]();
  }

  /** Turns the view, all lights or one light, to the right and down, in radians. */
  turn(right, down, subject) {
    const { player } = this;
    if (subject === "view") {
      player.camera = orbit(player.camera, -right, down);
    } else {
      const view = player.view([1, 1]);
      const [x, y] = columns3(transpose3(view.rotation));
      // What is dragged lies on the near side, and follows the pointer.
      const turned = multiply3(rotation3(y, right), rotation3(x, down));
      if (subject === "lights") {
        player.illumination = multiply3(turned, player.illumination);
      } else {
        this.turnLight(subject, turned, view);
      }
    }
    player.invalidate();
    player.tell("view");
  }

  turnLight(id, turned, view) {
    const { player } = this;
    const light = player.lightNow(id);
    const { rotation: worldFromOwn } = lightFrame(light.space, player.state(view, [1, 1]));
    const ownTurn = multiply3(transpose3(worldFromOwn), multiply3(turned, worldFromOwn));
    if (light.type === "directional") {
      player.light(id, { direction: turn(ownTurn, normalize(light.direction)) });
    } else {
      player.light(id, { position: turn(ownTurn, light.position), aim: turn(ownTurn, light.aim) });
    }
  }

  nearer(factor) {
    const { player } = this;
    const { radius } = player.mesh.sphere;
    player.camera = dolly(player.camera, factor, 0.2 * radius, 40 * radius);
    player.invalidate();
    player.tell("view");
  }

  pan(x, y) {
    const { player } = this;
    player.camera = pan(player.camera, x, y);
    player.invalidate();
    player.tell("view");
  }

  resetView() {
    const { player } = this;
    player.camera = { ...player.scene.camera };
    player.invalidate();
    player.tell("view");
  }
}
