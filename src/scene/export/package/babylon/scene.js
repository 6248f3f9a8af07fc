// What a look asks of a camera and a mesh of Babylon.js, in right-handed axes.

import { Constants, Matrix } from "@babylonjs/core";
import { objectAxes } from "./frames.js";
import { linear3, normalize, transformPoint } from "./math.js";

/** Mirrors z: from left-handed axes of Babylon.js to right-handed ones of looks, and back. */
const MIRROR = Matrix.Scaling(1, 1, -1);

let count = 0;
const ids = new WeakMap();

/** Number of a mesh, from 0 on in the order in which meshes are first drawn. */
function idOf(mesh) {
  if (!ids.has(mesh)) ids.set(mesh, count++ % 262144);
  return ids.get(mesh);
}

const isLeftHanded = (scene) => !scene.useRightHandedSystem;

/** A matrix from a mesh to the world of looks. */
const modelOf = (scene, world) => (isLeftHanded(scene) ? world.multiply(MIRROR) : world);

/** Part `camera` of the state of a look, and the view matrix. */
function cameraState(scene) {
  // Babylon's matrices have their rows where those of looks have columns.
  const view = isLeftHanded(scene)
    ? MIRROR.multiply(scene.getViewMatrix()).multiply(MIRROR) : scene.getViewMatrix();
  const world = Matrix.Invert(view).asArray();
  return {
    view,
    camera: {
      rotation: linear3(view.asArray()),
      eye: world.slice(12, 15),
      parallel: scene.activeCamera.mode === Constants.ORTHOGRAPHIC_CAMERA
        || scene.activeCamera.mode === 1,
      toward: normalize(world.slice(8, 11)),
    },
  };
}

/** The state of a look that camera, mesh and picture give; `size` is the picture's, in pixels. */
export function placeOf(scene, mesh, world, size) {
  const model = modelOf(scene, world).asArray();
  const { center } = mesh.getBoundingInfo().boundingBox;
  return {
    camera: cameraState(scene).camera,
    object: {
      id: idOf(mesh),
      axes: objectAxes(model),
      middle: transformPoint(model, center.asArray()),
    },
    viewport: size,
  };
}

/** Values of the uniform `view`. */
export function viewValues(scene, height) {
  const { view, camera } = cameraState(scene);
  const clip = isLeftHanded(scene)
    ? MIRROR.multiply(scene.getTransformMatrix()) : scene.getTransformMatrix();
  return {
    clip_from_world: clip.asArray(),
    camera_from_world: view.asArray(),
    eye: camera.parallel ? [...camera.toward, 0] : [...camera.eye, 1],
    // Babylon.js counts rows upward in WebGPU, too.
    screen: [1, -1, 0, height],
  };
}

/** Values of the uniform `object`. */
export function objectValues(scene, mesh, world) {
  const model = modelOf(scene, world);
  return {
    world_from_object: model.asArray(),
    world_from_normal: linear3(Matrix.Invert(model).transpose().asArray()),
    id: idOf(mesh),
    material: 0,
    look: 0,
  };
}

/** Values of the uniform of a mesh that casts shadows; meshes count from 1. */
export const casterValues = (scene, mesh, world) =>
  ({ world_from_object: modelOf(scene, world).asArray(), number: idOf(mesh) + 1 });

/** Values of the uniform `curvature`: numbers of a picture of this height, in pixels. */
export function curvatureValues(scene, height, samples) {
  const seen = height * scene.activeCamera.viewport.height;
  return {
    pixel: 2 / (scene.getProjectionMatrix().asArray()[5] * seen),
    perspective: cameraState(scene).camera.parallel ? 0 : 1,
    viewport_height: height,
    rows_up: 1,
    samples,
  };
}

const reaches = new WeakMap();

/** Distance of a mesh's farthest vertex from the middle of its box; found anew for another box. */
function reachOf(mesh) {
  const { geometry } = mesh;
  const { minimum, maximum, center } = mesh.getBoundingInfo().boundingBox;
  const box = [...minimum.asArray(), ...maximum.asArray()].join();
  if (reaches.get(geometry)?.box !== box) {
    const places = mesh.getVerticesData("position");
    let reach = 0;
    for (let i = 0; i < places.length; i += 3) {
      const [x, y, z] = [places[i] - center.x, places[i + 1] - center.y, places[i + 2] - center.z];
      reach = Math.max(reach, Math.hypot(x, y, z));
    }
    reaches.set(geometry, { box, reach });
  }
  return reaches.get(geometry).reach;
}

/** The sphere about a mesh, in the world of looks. */
export function sphereOf(scene, mesh) {
  const model = modelOf(scene, mesh.getWorldMatrix()).asArray();
  const { center } = mesh.getBoundingInfo().boundingBox;
  const sizes = [0, 4, 8].map((at) => Math.hypot(...model.slice(at, at + 3)));
  return {
    center: transformPoint(model, center.asArray()),
    radius: reachOf(mesh) * Math.max(...sizes),
  };
}

/** True for meshes that passes draw: those that nothing but their matrix moves. */
export const isDrawn = (mesh) =>
  mesh.isVisible && mesh.isEnabled() && mesh.geometry && mesh.isVerticesDataPresent("normal")
  && !(mesh.skeleton || mesh.morphTargetManager || mesh.hasInstances || mesh.hasThinInstances
    || mesh.isAnInstance || mesh.infiniteDistance);

/** What a look does not follow of meshes, and what to do. */
const UNFOLLOWED = [
  [(mesh) => mesh.skeleton, "skeletons: take a mesh in its pose"],
  [(mesh) => mesh.morphTargetManager, "morph targets: bake them into the mesh"],
  [(mesh) => mesh.hasInstances || mesh.hasThinInstances, "instances: take a clone for each"],
];

const toldOf = new WeakMap();

/** Says once for each mesh what of it the look does not draw, and what the look needs of it. */
export function checkMesh(look, { attributes }, mesh) {
  if (!toldOf.has(mesh)) toldOf.set(mesh, new Set());
  const told = toldOf.get(mesh);
  const tell = (text) => {
    if (told.has(text)) return;
    told.add(text);
    console.error(`Chiaro: ${look.name} on "${mesh.name}" ${text}`);
  };
  for (const [has, help] of UNFOLLOWED) if (has(mesh)) tell(`does not follow ${help}`);
  for (const name of attributes) {
    if (!mesh.isVerticesDataPresent(name)) tell(`needs the vertex data "${name}"`);
  }
}
