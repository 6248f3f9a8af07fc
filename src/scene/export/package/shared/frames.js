// Frames of lights and objects, as docs/hosts.md says.

import {
  columns3, cross, dot, identity3, linear3, normalize, scale, subtract, transpose3,
} from "./math.js";

/** Axes of an object for lights that belong to it: the model matrix's, unit and at right angles. */
export function objectAxes(worldFromObject) {
  const [x, y] = columns3(linear3(worldFromObject));
  const first = normalize(x, [1, 0, 0]);
  const second = normalize(subtract(y, scale(first, dot(first, y))), [0, 1, 0]);
  return [...first, ...second, ...cross(first, second)];
}

/** Rotation to the world, as columns, and origin of the frame that a light is in. */
export function lightFrame(space, { camera, object, illumination }) {
  const rotations = {
    illumination,
    world: identity3,
    camera: transpose3(camera.rotation),
    object: object.axes,
  };
  return { rotation: rotations[space], origin: space === "object" ? object.middle : [0, 0, 0] };
}

/** A light with the look's values, those of parameters, and those that are set on it. */
export function lightNow(look, { parameters, lights }, id) {
  const light = { ...look.lights.find((one) => one.id === id) };
  for (const { key, target } of look.parameters) {
    const [kind, of, field] = target?.split(".") ?? [];
    const value = parameters[key];
    if (kind === "lights" && of === id && value !== undefined) light[field] = value;
  }
  return { ...light, ...lights[id] };
}
