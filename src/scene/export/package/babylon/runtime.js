// Looks in Babylon.js: a module's GLSL or WGSL in a ShaderMaterial.

import {
  Constants, Matrix, RawTexture, ShaderLanguage, ShaderMaterial, Texture, UniformBuffer, Vector3,
} from "@babylonjs/core";
import { write } from "./uniforms.js";
import { LookValues } from "./values.js";

const RECODE = {
  wgsl: `
fn chiaro_encoded(x: vec3f) -> vec3f {
  return select(1.055 * pow(x, vec3f(1.0 / 2.4)) - 0.055, 12.92 * x, x <= vec3f(0.0031308));
}
fn chiaro_decoded(x: vec3f) -> vec3f {
  return select(pow((x + 0.055) / 1.055, vec3f(2.4)), x / 12.92, x <= vec3f(0.04045));
}
`,
  glsl: `
vec3 chiaro_encoded(vec3 x) {
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}
vec3 chiaro_decoded(vec3 x) {
  return mix(pow((x + 0.055) / 1.055, vec3(2.4)), x / 12.92, lessThanEqual(x, vec3(0.04045)));
}
`,
};

/** The function that brings a look's colors to what is drawn on; none where they fit. */
function recodingOf(look, target) {
  if (target === look.colorSpace) return null;
  return target === "display" ? "chiaro_encoded" : "chiaro_decoded";
}

/** The shaders in GLSL; attributes have the names that Babylon.js gives them. */
function glslOf({ glsl, attributes }, recoding) {
  const color = /layout\(location = 0\) out vec4 (\w+);/.exec(glsl.fragment)[1];
  const vertex = attributes.reduce(
    (text, { name }) => text.replace(new RegExp(`\\ba_${name}\\b`, "g"), name), glsl.vertex);
  const fragment = recoding
    ? `${glsl.fragment.replace("void main()", "void chiaro_main()")}${RECODE.glsl}
void main() {
  chiaro_main();
  ${color}.rgb = ${recoding}(clamp(${color}.rgb, 0.0, 1.0));
}
` : glsl.fragment;
  return { vertexSource: vertex, fragmentSource: fragment };
}

/** Names and types after the attributes in a list of members or arguments. */
function entriesOf(list) {
  const entry = /((?:@\w+(?:\([^)]*\))?\s*)*)(\w+)\s*:\s*([\w<>]+)/g;
  return Array.from(list.replace(/\/\/.*/g, "").matchAll(entry),
    ([, attributes, name, type]) => ({ attributes, name, type }));
}

const structOf = (text, name) =>
  entriesOf(new RegExp(`struct ${name} \\{([^}]*)\\}`).exec(text)[1]);

/** The shaders in the WGSL of Babylon.js, which binds and declares what is between them. */
function wgslOf(module, recoding) {
  const entries = {};
  let text = module.wgsl.replace(/@group\(\d+\)\s*@binding\(\d+\)\s*/g, "").replace(
    /@(vertex|fragment)\s+fn (\w+)\(([^{]*?)\)(\s*->[^{]*)?\{/g,
    (_, stage, name, list, result = "") => {
      const type = result.replace(/->|@\w+(\([^)]*\))?/g, "").trim();
      entries[stage] = { name, list: entriesOf(list), type };
      return `fn ${name}(${list.replace(/@\w+(\([^)]*\))?\s*/g, "")}) -> ${type} {`;
    },
  );
  const textures = module.bindings.filter(({ kind }) => kind === "texture");
  for (const { name, feed } of module.bindings.filter(({ kind }) => kind === "sampler")) {
    const own = textures.find((texture) => texture.feed.image === feed.image);
    text = text.replace(new RegExp(`(?<!\\.)\\b${name}\\b`, "g"), `${own.name}Sampler`);
  }
  const between = structOf(text, entries.vertex.type);
  const isClip = ({ attributes }) => attributes.includes("position");
  const carried = between.filter((member) => !isClip(member));
  const declared = (word, { name, type, attributes }) => {
    const flat = attributes?.includes("flat") ? "flat " : "";
    return `${flat}${word} ${name} : ${type};\n`;
  };
  const varyings = carried.map((member) =>
    declared("varying", { ...member, name: `v_${member.name}` })).join("");
  const vertex = entries.vertex.list.map(({ type }) =>
    `${type}(${structOf(text, type).map(({ name }) => `vertexInputs.${name}`).join(", ")})`);
  const fragment = entries.fragment.list.map(({ attributes, type }) =>
    attributes.includes("front_facing") ? "fragmentInputs.frontFacing"
      : `${type}(${between.map((member) => isClip(member)
        ? "fragmentInputs.position" : `fragmentInputs.v_${member.name}`).join(", ")})`);
  const shaded = `${entries.fragment.name}(${fragment.join(", ")})`;
  const inside = "clamp(color.rgb, vec3f(0.0), vec3f(1.0))";
  const recoded = recoding ? `color = vec4f(${recoding}(${inside}), color.a);` : "";
  const results = between.map((member) => isClip(member)
    ? `  vertexOutputs.position = result.${member.name};\n`
    : `  vertexOutputs.v_${member.name} = result.${member.name};\n`);
  return {
    vertexSource: `${module.attributes.map((one) => declared("attribute", one)).join("")}${varyings}
${text}
@vertex
fn main(input : VertexInputs) -> FragmentInputs {
  let result = ${entries.vertex.name}(${vertex.join(", ")});
${results.join("")}}
`,
    fragmentSource: `#define DISABLE_UNIFORMITY_ANALYSIS
${varyings}
${text}${recoding ? RECODE.wgsl : ""}
@fragment
fn main(input : FragmentInputs) -> FragmentOutputs {
  var color = ${shaded};
  ${recoded}
  fragmentOutputs.color = color;
}
`,
  };
}

const columns = (m) => [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]];

const normalized = ([x, y, z]) => {
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
};

const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

/** Mirrors z: from left-handed axes of Babylon.js to right-handed ones of looks, and back. */
const MIRROR = Matrix.Scaling(1, 1, -1);

let count = 0;
const ids = new WeakMap();

/** A look as a material for Babylon.js. Use the class of the look, which is made from this. */
export class LookMaterial extends ShaderMaterial {
  constructor(name, scene, look, base, { parameters, encoding = "display" } = {}) {
    const module = look.modules.draw;
    const isWebGPU = scene.getEngine().isWebGPU === true;
    const recoding = recodingOf(look, encoding);
    const sources = isWebGPU ? wgslOf(module, recoding) : glslOf(module, recoding);
    const nameOf = (binding) => (isWebGPU ? binding.name : binding.glsl?.name);
    const blocks = module.bindings.filter(({ kind }) => kind === "uniform");
    const pictures = module.bindings.filter(({ kind }) => kind === "texture");
    super(name, scene, sources, {
      attributes: module.attributes.map((attribute) => attribute.name),
      uniforms: [],
      uniformBuffers: blocks.map(nameOf),
      samplers: pictures.map(nameOf),
      needAlphaBlending: look.opaque === false,
      shaderLanguage: isWebGPU ? ShaderLanguage.WGSL : ShaderLanguage.GLSL,
    });
    this.look = look;
    this.values = new LookValues(look);
    this.parameters = this.values.parameters;
    this.lights = this.values.lights;
    this.backFaceCulling = look.passes.at(-1).sides !== "both";
    // Looks write depth where they are transparent, too.
    this.forceDepthWrite = true;
    this.blocks = blocks.map((binding) => {
      const size = Math.ceil(binding.size / 16);
      const buffer = new UniformBuffer(scene.getEngine(), undefined, true, nameOf(binding));
      buffer.addUniform("bytes", 4, size);
      buffer.create();
      return { ...binding, block: nameOf(binding), buffer, floats: new Float32Array(4 * size) };
    });
    this.ready = Promise.all(pictures.map((binding) => {
      const image = look.images[binding.feed.image];
      const { texture, loaded } = loadImage(scene, look, image, base);
      this.setTexture(nameOf(binding), texture);
      return loaded;
    })).then(() => this);
    this.ready.catch((error) => console.error(`Chiaro: ${look.name}: ${error.message}`));
    Object.assign(this.parameters, parameters);
  }

  /** Seconds, for looks that change with time. */
  get time() {
    return this.values.time;
  }

  set time(seconds) {
    this.values.time = seconds;
  }

  bind(world, mesh, effectOverride, subMesh) {
    const effect = effectOverride ?? subMesh?.effect ?? this.getEffect();
    if (!effect) return;
    super.bind(world, mesh, effectOverride, subMesh);
    const scene = this.getScene();
    const isLeft = !scene.useRightHandedSystem;
    const place = this.placeOf(scene, mesh, world, isLeft);
    for (const { feed, members, buffer, floats, block } of this.blocks) {
      if (feed.from === "look") {
        floats.set(new Float32Array(this.look.modules.draw.prepare(this.values.state(place))));
      } else {
        write(floats, members, feed.from === "view" ? place.view : place.matrices);
      }
      buffer.updateUniformArray("bytes", floats, floats.length);
      buffer.update();
      effect.bindUniformBuffer(buffer.getBuffer(), block);
    }
  }

  /** What the look asks of the scene, in right-handed axes. */
  placeOf(scene, mesh, world, isLeft) {
    const mirrored = (matrix) => (isLeft ? matrix.multiply(MIRROR) : matrix);
    // Babylon's matrices have their rows where those of looks have columns.
    const view = isLeft
      ? MIRROR.multiply(scene.getViewMatrix()).multiply(MIRROR) : scene.getViewMatrix();
    const clip = isLeft
      ? MIRROR.multiply(scene.getTransformMatrix()) : scene.getTransformMatrix();
    const model = mirrored(world).asArray();
    const normal = Matrix.Invert(mirrored(world)).transpose().asArray();
    const eye = Matrix.Invert(view).asArray();
    const engine = scene.getEngine();
    const [width, height] = [engine.getRenderWidth(), engine.getRenderHeight()];
    const { center } = mesh.getBoundingInfo().boundingBox;
    const middle = Vector3.TransformCoordinates(center, mirrored(world)).asArray();
    const x = normalized(model.slice(0, 3));
    const along = x[0] * model[4] + x[1] * model[5] + x[2] * model[6];
    const y = normalized([4, 5, 6].map((i) => model[i] - along * x[i - 4]));
    if (!ids.has(mesh)) ids.set(mesh, count++ % 262144);
    const isParallel = scene.activeCamera.mode === Constants.ORTHOGRAPHIC_CAMERA
      || scene.activeCamera.mode === 1;
    const toward = normalized(eye.slice(8, 11));
    const position = eye.slice(12, 15);
    return {
      camera: { rotation: columns(view.asArray()), eye: position, parallel: isParallel, toward },
      object: { id: ids.get(mesh), axes: [...x, ...y, ...cross(x, y)], middle },
      viewport: [width, height],
      view: {
        clip_from_world: clip.asArray(),
        camera_from_world: view.asArray(),
        eye: isParallel ? [...toward, 0] : [...position, 1],
        // Babylon.js counts rows upward in WebGPU, too.
        screen: [1, -1, 0, height],
      },
      matrices: {
        world_from_object: model,
        world_from_normal: columns(normal),
        id: ids.get(mesh),
        material: 0,
        look: 0,
      },
    };
  }

  dispose(...options) {
    for (const { buffer } of this.blocks) buffer.dispose();
    super.dispose(...options);
  }
}

/** An image of the look: rows as they lie in the file, one level, no color management. */
function loadImage(scene, look, image, base) {
  const filter = image.filter === "nearest"
    ? Texture.NEAREST_SAMPLINGMODE : Texture.BILINEAR_SAMPLINGMODE;
  if (!image.file) {
    const white = new Uint8Array([255, 255, 255, 255]);
    const texture = RawTexture.CreateRGBATexture(white, 1, 1, scene, false, false, filter);
    return { texture, loaded: Promise.resolve() };
  }
  const url = new URL(encodeURIComponent(image.file), base).href;
  let texture;
  const loaded = new Promise((resolve, reject) => {
    texture = new Texture(url, scene, {
      noMipmap: true,
      invertY: false,
      samplingMode: filter,
      useSRGBBuffer: image.encoding === "color" && look.colorSpace === "linear",
      onLoad: resolve,
      onError: (message) => reject(new Error(`${url}: ${message}`)),
    });
  });
  const modes = { repeat: Texture.WRAP_ADDRESSMODE, mirror: Texture.MIRROR_ADDRESSMODE };
  texture.wrapU = texture.wrapV = modes[image.wrap] ?? Texture.CLAMP_ADDRESSMODE;
  texture.anisotropicFilteringLevel = 1;
  return { texture, loaded };
}
