// {{name}}: a look made with Chiaro {{version}}. Types of its material for {{renderer}}.

import type { BufferGeometry, Color, Light, Matrix3, Vector2, Vector3, Vector4 } from "three";
import { {{base}} } from "{{module}}";

/** A color: its numbers in the look's own space, or hex, such as `"#40c070"`. */
type ColorValue = Color | Vector3 | Vector4 | readonly number[] | string;

type VectorValue = Vector3 | readonly number[];

/** Values for parameters, as a constructor takes them. */
type Values<P> = {
  [K in keyof P]?: P[K] extends readonly number[] ? Vector2 | VectorValue | ColorValue : P[K];
};

/**
 * What the look exposes. `undefined` brings the look's own value back; vectors are read as arrays.
 */
export interface {{class}}Parameters {
{{parameters}}}

/** Fields of a light, in the light's own frame; `undefined` brings the look's own value back. */
export interface {{class}}Light {
  get direction(): readonly number[];
  set direction(value: VectorValue | undefined);
  get position(): readonly number[];
  set position(value: VectorValue | undefined);
  get aim(): readonly number[];
  set aim(value: VectorValue | undefined);
  get color(): readonly number[];
  set color(value: ColorValue | undefined);
  get intensity(): number;
  set intensity(value: number | undefined);
  get inner(): number;
  set inner(value: number | undefined);
  get outer(): number;
  set outer(value: number | undefined);
  get half_distance(): number;
  set half_distance(value: number | undefined);
  get range(): number;
  set range(value: number | undefined);
}

export class {{type}} extends {{base}} {
  constructor(options?: {
    parameters?: Values<{{class}}Parameters>;
    /** True for geometries whose texture coordinates have v down, as those of GLTFLoader. */
    flipV?: boolean;
    [property: string]: unknown;
  });
  readonly parameters: {{class}}Parameters;
  /** Lights of the look. */
  // @ts-ignore: a boolean in materials of three.js that its lights shine on
  readonly lights: { {{light_members}}};
  /** Seconds, for looks that change with time. */
  time: number;
  /** Rotation that turns the look's lights together. */
  set illumination(matrix: Matrix3);
  /** What is written: `auto` fits the renderer, `none` leaves the look's own numbers. */
  encoding: "auto" | "none" | "display" | "linear";
  /** Resolves when the look's images are there. */
  readonly ready: Promise<this>;
  /** Everything about the look. */
  readonly look: typeof look;
  /** Lets a light of three.js drive where a light of the look shines from; `null` ends that. */
  follow(id: {{light}}, light: Light | null, options?: {
    /** Whether its color and its intensity count, too: false. */
    color?: boolean;
    intensity?: boolean;
  }): this;
}

/** Everything about the look: `look.parameters` has labels, ranges, units and defaults. */
export const look: {
  name: string;
  parameters: { key: string; label: string; type: string; default: unknown;
    min?: number; max?: number; group?: string; help?: string; unit?: string }[];
  [field: string]: unknown;
};

/** Centers a geometry and scales it to a sphere of radius 1, the size that looks are made for. */
export function fit<G extends BufferGeometry>(geometry: G): G;
