// Looks in three.js by WebGLRenderer: the module's GLSL ES 3.00 in a RawShaderMaterial.

import * as THREE from "three";
import { Users, optionsOf, withLook } from "./look.js";
import { arePassesShared, passesBefore, sourceOf } from "./passes.js";
import {
  casterValues, castsShadow, checkAttributes, curvatureValues, objectValues, placeOf, shadowMapsOf,
  viewValues, withMaterials, withShadows,
} from "./scene.js";
import { layersOf } from "./shadows.js";
import { UniformMirror } from "./mirror.js";

/** What a look's colors are turned into: `chiaro_encoding` of the shader. */
const ENCODINGS = { none: 0, display: 1, linear: 2 };

const ENCODE = `
uniform int chiaro_encoding;
vec3 chiaro_encoded(vec3 x) {
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}
vec3 chiaro_decoded(vec3 x) {
  return mix(pow((x + 0.055) / 1.055, vec3(2.4)), x / 12.92, lessThanEqual(x, vec3(0.04045)));
}
`;

/** Uniform blocks as plain uniforms, which three.js can set for each object. */
const BLOCK = /layout\(std140\) uniform (\w+) \{ (\w+) (\w+); \};/g;

/** The module's shaders as three.js takes them, and type and name of the uniform in each block. */
function shadersOf({ glsl, attributes }, pass) {
  const blocks = new Map();
  // Rows of Chiaro's pictures run downward; layers of shadow maps are drawn upside down.
  const downward = (text) =>
    (pass.draws === "lights" ? text : text.replace(/\bdFdy\(/g, "-dFdy("));
  const [vertex, fragment] = [glsl.vertex, glsl.fragment].map((text) =>
    downward(text).replace(/^#version.*\n/, "").replace(BLOCK, (_, block, type, name) => {
      blocks.set(block, { type, name });
      return `uniform ${type} ${name};`;
    }),
  );
  return {
    vertexShader: attributes.reduce(withAttribute, vertex),
    fragmentShader: pass.name === "draw" ? withEncoding(fragment) : fragment,
    blocks,
  };
}

/** Attributes have three's names: `position`, `normal`, `uv`, `tangent`, `color`. */
function withAttribute(text, { name }) {
  if (name !== "uv") return `#define a_${name} ${name}\n${text}`;
  return text.replace("in vec2 a_uv;", `in vec2 uv;
uniform float chiaro_flip_v;
#define a_uv vec2(uv.x, mix(uv.y, 1.0 - uv.y, chiaro_flip_v))`);
}

function withEncoding(text) {
  const color = /layout\(location = 0\) out vec4 (\w+);/.exec(text)[1];
  return `${text.replace("void main()", "void chiaro_main()")}${ENCODE}
void main() {
  chiaro_main();
  vec3 color = clamp(${color}.rgb, 0.0, 1.0);
  if (chiaro_encoding == 1) ${color}.rgb = chiaro_encoded(color);
  if (chiaro_encoding == 2) ${color}.rgb = chiaro_decoded(color);
}
`;
}

/** A material that runs one module of a look. `pass` is the pass that it draws. */
class ModuleMaterial extends THREE.RawShaderMaterial {
  constructor(look, pass, options) {
    const module = look.modules[pass.module];
    const { blocks, ...shaders } = shadersOf(module, pass);
    super({ glslVersion: THREE.GLSL3, ...shaders, ...options });
    this.feeds = module.bindings.map((binding) => {
      const name = blocks.get(binding.glsl?.name)?.name ?? binding.glsl?.name;
      if (name && binding.kind !== "sampler") this.uniforms[name] = { value: null };
      return { ...binding, uniform: this.uniforms[name] };
    });
    this.pass = pass;
    this.uniforms.chiaro_flip_v = { value: 0 };
    this.uniforms.chiaro_encoding = { value: 0 };
    const own = this.feeds.find(({ feed }) => feed.from === "look");
    const struct = blocks.get(own?.glsl?.name)?.type;
    const text = shaders.vertexShader + shaders.fragmentShader;
    this.mirror = own && new UniformMirror(own, struct, text);
    this.prepare = module.prepare;
    this.normal = new THREE.Matrix3();
    this.clip = new THREE.Matrix4();
  }

  /** Sets all uniforms for an object. `frame` has the picture's numbers and the passes' targets. */
  fill({ camera, object, height, samples, state, targets, images, flipV, layer }) {
    const values = {
      view: () => {
        this.clip.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
        return viewValues(camera, this.clip, height);
      },
      object: () => objectValues(object, this.normal, 0),
      curvature: () => curvatureValues(camera, height, true, samples),
      look: () => {
        this.mirror.update(this.prepare(state));
        return this.mirror.value;
      },
      image: ({ image }) => images[image].texture,
      light_layer: () => layer,
      light_caster: () => casterValues(object),
    };
    const drawn = (feed, name) => targets.get(sourceOf(this.pass, { feed, name }));
    for (const { feed, name, uniform } of this.feeds) {
      if (uniform) uniform.value = (values[feed.from] ?? drawn)(feed, name);
    }
    this.uniforms.chiaro_flip_v.value = flipV ? 1 : 0;
    this.uniformsNeedUpdate = true;
  }
}

const FORMATS = {
  rgba32float: THREE.RGBAFormat, rg32float: THREE.RGFormat, r32float: THREE.RedFormat,
};

/** The passes before a look's picture, for one renderer. */
class Passes {
  constructor(look, renderer) {
    this.look = look;
    this.renderer = renderer;
    this.targets = new Map();
    this.frame = -1;
    const screen = new THREE.BufferGeometry();
    screen.setAttribute("position", new THREE.BufferAttribute(new Float32Array(9), 3));
    this.steps = passesBefore(look).map((pass) => {
      const options = { blending: THREE.NoBlending, toneMapped: false };
      const [format, ...others] = pass.outputs.map((output) => FORMATS[output.format]);
      if (!format || others.length) {
        throw new Error(`Chiaro: ${look.name}: the pass ${pass.name} has a target unknown here`);
      }
      const isScreen = pass.draws === "screen";
      const layers = pass.draws === "lights" ? Math.max(layersOf(look), 2) : 0;
      const settings = {
        format, type: THREE.FloatType,
        minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
        depthBuffer: !isScreen, generateMipmaps: false,
      };
      const target = layers ? new THREE.WebGLArrayRenderTarget(1, 1, layers, settings)
        : new THREE.WebGLRenderTarget(1, 1, settings);
      this.targets.set(`${pass.name}.${pass.outputs[0].name}`, target.texture);
      if (layers) {
        const both = new ModuleMaterial(look, pass, { ...options, side: THREE.DoubleSide });
        return { target, layers, both };
      }
      if (!isScreen) {
        const front = new ModuleMaterial(look, pass, options);
        const both = new ModuleMaterial(look, pass, { ...options, side: THREE.DoubleSide });
        return { target, front, both };
      }
      const test = { depthTest: false, depthWrite: false };
      const material = new ModuleMaterial(look, pass, { ...options, ...test });
      const triangle = new THREE.Mesh(screen, material);
      triangle.frustumCulled = false;
      return { target, triangle, scene: new THREE.Scene().add(triangle) };
    });
    this.camera = new THREE.OrthographicCamera();
    this.light = new THREE.Camera();
    this.viewport = new THREE.Vector4();
    this.size = new THREE.Vector2();
    this.color = new THREE.Color();
    this.users = new Users(() => this.dispose());
  }

  /** Draws the passes for a picture of the scene, once for each call of `render`. */
  update(scene, camera, frame) {
    const { renderer } = this;
    if (this.frame === renderer.info.render.frame) return;
    const { autoClear, xr, shadowMap } = renderer;
    const [target, face, level] =
      [renderer.getRenderTarget(), renderer.getActiveCubeFace(), renderer.getActiveMipmapLevel()];
    const color = renderer.getClearColor(this.color).clone();
    const alpha = renderer.getClearAlpha();
    const [hasXr, hasShadows] = [xr.enabled, shadowMap.autoUpdate];
    renderer.getCurrentViewport(this.viewport);
    renderer.setClearColor(0, 0);
    renderer.autoClear = true;
    xr.enabled = false;
    shadowMap.autoUpdate = false;
    try {
      if (this.steps.some(({ layers }) => layers)) {
        const clip = { isReversed: camera.reversedDepth, isWebGL: true };
        this.shadows = shadowMapsOf(this.look, frame.state, scene, frame.height, clip);
      }
      for (const step of this.steps) {
        if (step.layers) this.runLayers(step, scene, camera, frame);
        else this.run(step, scene, camera, frame);
      }
    } finally {
      Object.assign(renderer, { autoClear });
      xr.enabled = hasXr;
      shadowMap.autoUpdate = hasShadows;
      renderer.setClearColor(color, alpha);
      renderer.setRenderTarget(target, face, level);
      if (camera.viewport) renderer.state.viewport(camera.viewport);
      this.frame = renderer.info.render.frame;
    }
  }

  run({ target, front, both, triangle, scene: screen }, scene, camera, frame) {
    const { renderer } = this;
    const [width, height] = frame.size;
    target.setSize(width, height);
    target.viewport.copy(this.viewport);
    target.scissor.copy(this.viewport);
    renderer.setRenderTarget(target);
    const fill = (material, object) =>
      material.fill({ ...frame, camera, object, targets: this.targets });
    if (triangle) {
      fill(triangle.material, triangle);
      renderer.render(screen, this.camera);
      return;
    }
    for (const material of [front, both]) {
      material.onBeforeRender = (...given) => fill(material, given[4]);
    }
    const choose = ({ material }) => {
      const [first] = Array.isArray(material) ? material : [material];
      return first.side === THREE.DoubleSide ? both : front;
    };
    withMaterials(scene, choose, () => renderer.render(scene, camera));
  }

  /** Draws the layers of a pass over shadow maps. */
  runLayers({ target, layers, both }, scene, camera, frame) {
    const { renderer, light, shadows } = this;
    target.setSize(shadows.side, shadows.side, layers);
    light.layers.mask = camera.layers.mask;
    light._reversedDepth = camera.reversedDepth;
    shadows.layers.forEach((layer, index) => {
      // The camera only decides what is left out.
      light.projectionMatrix.fromArray(layer.clip_from_world);
      both.onBeforeRender = (...given) =>
        both.fill({ ...frame, camera, object: given[4], layer, targets: this.targets });
      renderer.setRenderTarget(target, index);
      const choose = (object) => castsShadow(object) && both;
      withMaterials(scene, choose, () => renderer.render(scene, light));
    });
  }

  dispose() {
    for (const { target, front, both, triangle } of this.steps) {
      target.dispose();
      for (const material of [front, both, triangle?.material]) material?.dispose();
      triangle?.geometry.dispose();
    }
  }
}

/** The passes of looks, shared by all materials of a look where its values do not count. */
const passesOf = new WeakMap();

function passesFor(material, renderer) {
  const { look } = material;
  if (look.passes.length === 1) return null;
  if (!passesOf.has(renderer)) passesOf.set(renderer, new WeakMap());
  const known = passesOf.get(renderer);
  const owner = arePassesShared(look) ? look : material;
  if (!known.has(owner)) known.set(owner, new Passes(look, renderer));
  const passes = known.get(owner);
  passes.users.add(material);
  return passes;
}

/** A look as a material for WebGLRenderer. Use the class of the look, which is made from this. */
export class LookMaterial extends withLook(ModuleMaterial, THREE) {
  constructor(look, files, { parameters, flipV = false, ...options } = {}) {
    const pass = look.passes.find(({ name }) => name === "draw");
    super(look, pass, optionsOf(THREE, look, pass, options));
    // WebGPURenderer names the type of what it cannot draw.
    this.type = `${this.name} for WebGLRenderer`;
    /** Whether texture coordinates have v down, as those of GLTFLoader. */
    this.flipV = flipV;
    this.begin(look, files, parameters);
  }

  onBeforeRender(renderer, scene, camera, _geometry, object) {
    checkAttributes(this.look, object);
    this.updateSide();
    const target = renderer.getRenderTarget();
    const size = this.pictureSize(renderer);
    const context = renderer.getContext();
    const samples = target ? target.samples : context.getParameter(context.SAMPLES);
    const state = this.stateOf(placeOf(camera, object, size));
    const frame = {
      size, height: size[1], samples: Math.max(samples, 1), state, images: this.images,
      flipV: this.flipV,
    };
    const passes = passesFor(this, renderer);
    passes?.update(scene, camera, frame);
    const lit = withShadows(state, passes?.shadows);
    this.fill({ ...frame, state: lit, camera, object, targets: passes?.targets });
    this.uniforms.chiaro_encoding.value = ENCODINGS[this.encodingFor(renderer, target)];
  }

  /** Canvases show encoded colors, and targets of three.js hold light. */
  encodingFor(renderer, target) {
    if (this.encoding !== "auto") return this.encoding;
    const isLight = target && !target.isXRRenderTarget;
    if (this.look.colorSpace === "display") return isLight ? "linear" : "none";
    return !isLight && renderer.outputColorSpace === THREE.SRGBColorSpace ? "display" : "none";
  }

  copy(source) {
    super.copy(source);
    this.flipV = source.flipV;
    return this;
  }
}
