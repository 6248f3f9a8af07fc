// {{name}}: a look made with Chiaro {{version}}. Types of its material for Babylon.js.

import type { Color3, Color4, Scene, Vector2, Vector3, Vector4 } from "@babylonjs/core";
import { ShaderMaterial } from "@babylonjs/core";

/** A color of Babylon.js. */
type LibraryColor = Color3 | Color4;

{{values}}

export class {{class}}Material extends ShaderMaterial {
  constructor(name: string, scene: Scene, options?: {
    parameters?: Values<{{class}}Parameters>;
    /** Where the material draws: `display` on a canvas, `linear` before image processing. */
    encoding?: "display" | "linear";
  });
  readonly parameters: {{class}}Parameters;
  /** Lights of the look. */
  readonly lights: { {{light_members}}};
  /** Seconds, for looks that change with time. */
  time: number;
  /** Resolves when the look's images are there. */
  readonly ready: Promise<this>;
  /** Everything about the look. */
  readonly look: typeof look;
}
