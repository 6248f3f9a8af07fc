// The camera: where it stands, the matrices of a picture, and how it is turned.

/** Least distance of the near plane, as a share of the far plane's. */
const NEAREST = 1e-3;

/**
 * The matrices of a picture.
 *
 * @param camera `eye`, `target`, `up`, `fov` (vertical, in radians) or, where `parallel`, `height`;
 *   `aspect` is the width over the height that it was placed for: a narrower picture shows as much
 *   in width. 0 for any.
 * @param size width and height of the picture, in pixels.
 * @param sphere `center` and `radius` of what is drawn, in world space.
 * @param clip clip space of the API, as `forClipSpace` takes it.
 */
function viewOf(camera, size, sphere, clip) {
  const backward = normalize(subtract(camera.eye, camera.target));
  const other = Math.abs(backward[1]) < 0.9 ? [0, 1, 0] : [0, 0, 1];
  const right = normalize(cross(camera.up, backward), normalize(cross(other, backward)));
  const up = cross(backward, right);
  const rotation = transpose3([...right, ...up, ...backward]);
  const moved = turn(rotation, scale(camera.eye, -1));
  const cameraFromWorld = [
    ...rotation.slice(0, 3), 0,
    ...rotation.slice(3, 6), 0,
    ...rotation.slice(6, 9), 0,
    ...moved, 1,
  ];
  const aspect = Math.max(size[0], 1) / Math.max(size[1], 1);
  const widening = camera.aspect > 0 ? Math.max(camera.aspect / aspect, 1) : 1;
  const distance = dot(backward, subtract(camera.eye, sphere.center));
  const reach = 1.01 * Math.max(sphere.radius, 1e-6);
  const far = Math.max(distance + reach, 1e-3);
  let projection, height;
  if (camera.parallel) {
    height = Math.max(camera.height, 1e-6) * widening;
    const near = distance - reach;
    const half = 0.5 * height;
    projection = orthographic(half * aspect, half, near, Math.max(far, near + 1e-3));
  } else {
    height = 2 * Math.tan(0.5 * camera.fov) * widening;
    const near = Math.max(distance - reach, far * NEAREST);
    projection = perspective(0.5 * height, aspect, near, Math.max(far, 1.001 * near));
  }
  return {
    clipFromWorld: multiply4(forClipSpace(projection, clip), cameraFromWorld),
    cameraFromWorld,
    rotation,
    eye: camera.eye,
    toward: backward,
    parallel: Boolean(camera.parallel),
    // The size of a pixel in scene units: at depth 1 for perspective, at every depth otherwise.
    pixel: height / Math.max(size[1], 1),
  };
}

// Both projections have depths from 0 (near) to 1 (far).

function perspective(half, aspect, near, far) {
  const depth = far / (near - far);
  return [1 / half / aspect, 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, depth, -1, 0, 0, near * depth, 0];
}

function orthographic(halfWidth, halfHeight, near, far) {
  const depth = 1 / (near - far);
  return [1 / halfWidth, 0, 0, 0, 0, 1 / halfHeight, 0, 0, 0, 0, depth, 0, 0, 0, near * depth, 1];
}

/** Turns the camera around its target: to the right and up, in radians. */
function orbit(camera, yaw, pitch) {
  const offset = subtract(camera.eye, camera.target);
  const backward = normalize(offset);
  // Never over the poles, where right and left would change places.
  const height = Math.asin(clamp(dot(backward, normalize(camera.up, [0, 1, 0])), -1, 1));
  const limit = 0.495 * Math.PI;
  const rise = clamp(height + pitch, -Math.max(limit, -height), Math.max(limit, height)) - height;
  const axis = normalize(camera.up, [0, 1, 0]);
  const right = normalize(cross(axis, backward), [1, 0, 0]);
  const turned = turn(rotation3(axis, yaw), turn(rotation3(right, -rise), offset));
  return { ...camera, eye: add(camera.target, turned) };
}

/** Moves the camera nearer (a factor below 1) or farther, between `least` and `most` away. */
function dolly(camera, factor, least, most) {
  const offset = subtract(camera.eye, camera.target);
  const distance = clamp(length(offset) * factor, least, most);
  const eye = add(camera.target, scale(normalize(offset), distance));
  return { ...camera, eye, height: camera.height * (distance / Math.max(length(offset), 1e-9)) };
}

/** Moves the camera and its target sideways, in pictures' heights. */
function pan(camera, x, y) {
  const offset = subtract(camera.eye, camera.target);
  const backward = normalize(offset);
  const right = normalize(cross(camera.up, backward), [1, 0, 0]);
  const up = cross(backward, right);
  const height = camera.parallel ? camera.height : 2 * Math.tan(0.5 * camera.fov) * length(offset);
  const move = add(scale(right, -x * height), scale(up, y * height));
  return { ...camera, eye: add(camera.eye, move), target: add(camera.target, move) };
}
