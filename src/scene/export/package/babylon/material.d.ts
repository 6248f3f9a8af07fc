// {{name}}: a look made with Chiaro {{version}}. Types of its material for Babylon.js.

import type { Scene } from "@babylonjs/core";
import { ShaderMaterial, Vector2, Vector3, Vector4 } from "@babylonjs/core";

/** Numbers of a vector; reading gives an array that cannot be changed. */
type Numbers<V> = V | readonly number[];

/** A color is its numbers in the look's own space. */
type Color = readonly number[];

/** What the look exposes. `undefined` brings the look's own value back. */
export interface {{class}}Parameters {
{{parameters}}}

/** Fields of a light, in the light's own frame. */
export interface {{class}}Light {
  direction: Numbers<Vector3>;
  position: Numbers<Vector3>;
  aim: Numbers<Vector3>;
  color: Numbers<Vector3>;
  intensity: number;
  inner: number;
  outer: number;
  half_distance: number;
  range: number;
}

export class {{class}}Material extends ShaderMaterial {
  constructor(name: string, scene: Scene, options?: {
    parameters?: Partial<{{class}}Parameters>;
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
}

/** Everything about the look: `look.parameters` has labels, ranges, units and defaults. */
export const look: { name: string; [field: string]: unknown };
