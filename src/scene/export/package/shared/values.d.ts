/** A color: its numbers in the look's own space, or hex, such as `"#40c070"` or `0x40c070`. */
type ColorValue = LibraryColor | Vector3 | Vector4 | readonly number[] | string | number;

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

/** Everything about the look: `look.parameters` has labels, ranges, units and defaults. */
export const look: {
  name: string;
  parameters: { key: string; label: string; type: string; default: unknown;
    min?: number; max?: number; group?: string; help?: string; unit?: string }[];
  [field: string]: unknown;
};
