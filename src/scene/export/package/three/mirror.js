// The values in the bytes of a uniform, for WebGL.

import { SHAPES } from "./uniforms.js";

/**
 * The members of a uniform as an object of numbers and arrays, as WebGL programs take them one by
 * one. `value` stays the same object while its bytes change.
 */
export class UniformMirror {
  constructor({ members, size }) {
    this.bytes = new ArrayBuffer(Math.ceil(size / 16) * 16);
    /** Functions that read again what is copied out of the bytes. */
    this.readers = [];
    this.value = this.struct(members, 0);
  }

  /** Takes over the bytes of a uniform. */
  update(bytes) {
    new Uint8Array(this.bytes).set(new Uint8Array(bytes));
    for (const read of this.readers) read();
  }

  struct(members, start) {
    const object = {};
    for (const member of members) this.member(object, member.name, member, start + member.offset);
    return object;
  }

  member(object, key, { type, members, stride }, start) {
    const array = /^array<(.+), (\d+)>$/.exec(type);
    if (array) {
      const places = Array.from({ length: Number(array[2]) }, (_, i) => start + i * stride);
      if (members) object[key] = places.map((at) => this.struct(members, at));
      else object[key] = this.copies(array[1], places);
    } else if (members) {
      object[key] = this.struct(members, start);
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
