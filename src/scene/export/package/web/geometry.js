// Meshes of a page's own: arrays of numbers as other libraries have them.

/** Names that a mesh of one's own has for the attributes of shaders, with their counts. */
const MESH_ARRAYS = {
  position: ["positions", 3], normal: ["normals", 3], tangent: ["tangents", 4], uv: ["uvs", 2],
  color: ["colors", 4],
};

/**
 * The mesh with the attributes that a look reads, as large as the sphere that the look was made
 * for and in its place.
 *
 * @param given `positions`, three numbers a vertex; `indices`, three a triangle, else every three
 *   vertices are one; `normals`, else smooth ones; `uvs`; `colors` of four numbers; `tangents` of
 *   four. `twoSided` where backs are seen.
 * @param wanted names of the attributes that the look reads.
 */
function meshOf(given, wanted, sphere) {
  const positions = Float32Array.from(given.positions ?? []);
  const count = positions.length / 3;
  if (!count || !Number.isInteger(count) || !positions.every(Number.isFinite)) {
    throw new TypeError("positions are finite numbers, three for every vertex");
  }
  const indices = Uint32Array.from(given.indices ?? positions.subarray(0, count).keys());
  if (!indices.length || indices.length % 3 || indices.some((index) => index >= count)) {
    throw new TypeError(`indices are three for every triangle, below the ${count} vertices`);
  }
  const attributes = {};
  for (const name of wanted) {
    const [key, size] = MESH_ARRAYS[name];
    const array = given[key] && Float32Array.from(given[key]);
    if (array && array.length !== size * count) {
      throw new TypeError(`${key} are ${size} numbers for each of the ${count} vertices`);
    }
    attributes[name] = array ?? new Float32Array(size * count).fill(name === "color" ? 1 : 0);
  }
  if (attributes.normal && !given.normals) smoothNormals(positions, indices, attributes.normal);
  if (attributes.tangent && !given.tangents) {
    tangentsFromUvs({ positions, indices, ...attributes });
  }
  const [least, most] = [[...positions.slice(0, 3)], [...positions.slice(0, 3)]];
  const pointAt = (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)];
  for (let vertex = 0; vertex < count; vertex++) {
    pointAt(vertex).forEach((x, i) => {
      least[i] = Math.min(least[i], x);
      most[i] = Math.max(most[i], x);
    });
  }
  const middle = scale(add(least, most), 0.5);
  let radius = 0;
  for (let vertex = 0; vertex < count; vertex++) {
    radius = Math.max(radius, length(subtract(pointAt(vertex), middle)));
  }
  const size = sphere.radius / Math.max(radius, 1e-9);
  const place = subtract(sphere.center, scale(middle, size));
  const worldFromObject = [size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, ...place, 1];
  const twoSided = Boolean(given.twoSided);
  const parts = [{ first: 0, count: indices.length, twoSided, material: 0 }];
  return { worldFromObject, middle, sphere, parts, attributes, indices };
}

/** Normals that are the sums of the triangles' around a vertex, by their areas. */
function smoothNormals(positions, indices, normals) {
  const pointAt = (vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)];
  for (let at = 0; at < indices.length; at += 3) {
    const corners = indices.subarray(at, at + 3);
    const [a, b, c] = [...corners].map(pointAt);
    const normal = cross(subtract(b, a), subtract(c, a));
    for (const vertex of corners) normal.forEach((x, i) => (normals[3 * vertex + i] += x));
  }
  for (let at = 0; at < normals.length; at += 3) {
    normals.set(normalize([...normals.subarray(at, at + 3)]), at);
  }
}

/** Tangents along the first coordinate of the uvs; along any direction where there are none. */
function tangentsFromUvs({ positions, indices, normal, uv, tangent }) {
  const at = (array, size, vertex) => [...array.subarray(size * vertex, size * (vertex + 1))];
  const sides = new Float64Array(positions.length);
  for (let first = 0; first < indices.length && uv; first += 3) {
    const corners = [...indices.subarray(first, first + 3)];
    const [a, b, c] = corners.map((vertex) => at(positions, 3, vertex));
    const [p, q, r] = corners.map((vertex) => at(uv, 2, vertex));
    const [[du1, dv1], [du2, dv2]] = [subtract(q, p), subtract(r, p)];
    const area = du1 * dv2 - du2 * dv1;
    if (Math.abs(area) < 1e-12) continue;
    const way = scale(subtract(scale(subtract(b, a), dv2), scale(subtract(c, a), dv1)), 1 / area);
    const along = normalize(way, [0, 0, 0]);
    for (const vertex of corners) along.forEach((x, i) => (sides[3 * vertex + i] += x));
  }
  for (let vertex = 0; vertex < positions.length / 3; vertex++) {
    const up = normal ? at(normal, 3, vertex) : [0, 0, 1];
    const along = at(sides, 3, vertex);
    const flat = subtract(along, scale(up, dot(along, up)));
    const other = Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    tangent.set([...normalize(flat, normalize(cross(other, up))), 1], 4 * vertex);
  }
}
