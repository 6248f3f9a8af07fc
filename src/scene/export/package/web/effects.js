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
