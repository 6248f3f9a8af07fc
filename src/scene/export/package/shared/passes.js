// The passes of a look.

/** The image that a texture of a pass reads: the output of an earlier pass. */
export function sourceOf(pass, { feed, name }) {
  const input = feed.from === "pass" ? feed : pass.inputs?.find(({ binding }) => binding === name);
  return input && `${input.pass}.${input.output}`;
}

/** The passes before the picture. */
export const passesBefore = (look) => look.passes.filter(({ name }) => name !== "draw");

/** True where the passes before the picture are the same whatever the values of the look. */
export const arePassesShared = (look) => passesBefore(look).every(({ draws, module }) =>
  draws !== "lights" && look.modules[module].bindings.every(({ feed }) => feed.from !== "look"));
