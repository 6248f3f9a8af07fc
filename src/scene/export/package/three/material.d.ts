// {{name}}: a look made with Chiaro {{version}}. Types of its material for {{renderer}}.

import type {
  BufferGeometry, Color, Light, Matrix3, Object3D, Vector2, Vector3, Vector4,
} from "three";
import { {{base}} } from "{{module}}";

/** A color of three.js. */
type LibraryColor = Color;

{{values}}

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

/** Centers a geometry and scales it to a sphere of radius 1, the size that looks are made for. */
export function fit<G extends BufferGeometry>(geometry: G): G;

/** Does so for all meshes of a model together, by its common radius; nothing moves or grows. */
export function fitAll<O extends Object3D>(root: O): O;
