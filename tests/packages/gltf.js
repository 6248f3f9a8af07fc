// A mesh of a page as a file for Chiaro: glTF, which holds the page's own tangents.

/** Shapes of attributes by their number of values. */
const TYPES = { 1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4" };

/** Kinds of numbers in glTF. */
const KINDS = { Float32Array: 5126, Uint32Array: 5125 };

/** The text of a file; `uvs` have v up, and `indices` their fronts counterclockwise. */
export function gltfOf({ positions, normals, uvs, tangents, indices }) {
  const down = uvs.map((x, i) => (i % 2 ? 1 - x : x));
  const lists = [[positions, 3], [normals, 3], [down, 2], [tangents, 4], [indices, 1]]
    .map(([list, size], i) => [i < 4 ? Float32Array.from(list) : Uint32Array.from(list), size]);
  const bufferViews = [];
  let byteLength = 0;
  for (const [list] of lists) {
    bufferViews.push({ buffer: 0, byteOffset: byteLength, byteLength: list.byteLength });
    byteLength += list.byteLength;
  }
  const bytes = new Uint8Array(byteLength);
  lists.forEach(([{ buffer }], i) => bytes.set(new Uint8Array(buffer), bufferViews[i].byteOffset));
  const data = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  const accessors = lists.map(([list, size], bufferView) => ({
    bufferView, componentType: KINDS[list.constructor.name], type: TYPES[size],
    count: list.length / size,
  }));
  const ends = [Math.min, Math.max].map((end) =>
    [0, 1, 2].map((k) => lists[0][0].filter((_, i) => i % 3 === k).reduce((a, b) => end(a, b))));
  [accessors[0].min, accessors[0].max] = ends;
  const attributes = { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2, TANGENT: 3 };
  return JSON.stringify({
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes, indices: 4 }] }],
    accessors,
    bufferViews,
    buffers: [{ byteLength, uri: `data:application/octet-stream;base64,${data}` }],
  });
}
