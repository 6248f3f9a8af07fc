// The values in the bytes of a uniform, for WebGL.

import { SHAPES } from "./uniforms.js";

/** Types and names of the members of each struct in a text of GLSL. */
function structsOf(text) {
  const structs = text.replace(/\/\/.*/g, "").matchAll(/struct (\w+) \{([^}]*)\}/g);
  return new Map(Array.from(structs, ([, struct, body]) => {
    const members = body.matchAll(/(\w+) (\w+)(?:\[\d+\])?;/g);
    return [struct, Array.from(members, ([, type, name]) => ({ type, name }))];
  }));
}

/**
 * The members of a uniform as an object of numbers and arrays, as WebGL programs take them one by
 * one. `value` stays the same object while its bytes change.
 */
export class UniformMirror {
  /** `struct` is the uniform's type in `text`, the shader in GLSL. */
  constructor({ members, size }, struct, text) {
    /** Names of members are those of GLSL, whose own words cannot be names. */
    this.structs = structsOf(text);
    this.bytes = new ArrayBuffer(Math.ceil(size / 16) * 16);
    /** Functions that read again what is copied out of the bytes. */
    this.readers = [];
    this.value = this.struct(members, 0, struct);
  }

  /** Takes over the bytes of a uniform. */
  update(bytes) {
    new Uint8Array(this.bytes).set(new Uint8Array(bytes));
    for (const read of this.readers) read();
  }

  struct(members, start, struct) {
    const object = {};
    this.structs.get(struct).forEach(({ type, name }, i) =>
      this.member(object, name, members[i], start + members[i].offset, type));
    return object;
  }

  member(object, key, { type, members, stride }, start, struct) {
    const array = /^array<(.+), (\d+)>$/.exec(type);
    if (array) {
      const places = Array.from({ length: Number(array[2]) }, (_, i) => start + i * stride);
      if (members) object[key] = places.map((at) => this.struct(members, at, struct));
      else object[key] = this.copies(array[1], places);
    } else if (members) {
      object[key] = this.struct(members, start, struct);
    } else if (type === "f32" || type === "u32" || type === "i32") {
      const Numbers = { f32: Float32Array, u32: Uint32Array, i32: Int32Array }[type];
      const number = new Numbers(this.bytes, start, 1);
      this.readers.push(() => (object[key] = number[0]));
      object[key] = 0;
    } else {
      object[key] = this.copies(type, [start]);
    }
  }

  /** Numbers of vectors and matrices without the gaps between columns and elements. */
  copies(type, places) {
    const [columns, rows] = SHAPES[type];
    const starts = places.flatMap((at) => Array.from({ length: columns }, (_, c) => at + 16 * c));
    const parts = starts.map((at) => new Float32Array(this.bytes, at, rows));
    const numbers = new Float32Array(parts.length * rows);
    this.readers.push(() => parts.forEach((part, i) => numbers.set(part, i * rows)));
    return numbers;
  }
}
