// Looks in three.js by WebGPURenderer: the module's WGSL, called by the nodes of a NodeMaterial.

import * as THREE from "three/webgpu";
import {
  attribute, code, frontFacing, screenCoordinate, texture, uint, varying, vertexIndex, wgslFn,
} from "three/tsl";
import { Users, optionsOf, withLook } from "./look.js";
import { arePassesShared, passesBefore, sourceOf } from "./passes.js";
import {
  casterValues, castsShadow, checkAttributes, curvatureValues, objectValues, placeOf, shadowMapsOf,
  viewValues, withMaterials, withShadows,
} from "./scene.js";
import { layersOf } from "./shadows.js";
import { blank } from "./textures.js";
import { write } from "./uniforms.js";

/** What a look's colors are turned into: `chiaro_target` of the shader. */
const ENCODINGS = { none: 0, display: 1, linear: 2 };

const ENCODE = `
fn chiaro_recoded(color: vec4f, encoding: f32) -> vec4f {
  let x = clamp(color.rgb, vec3f(0.0), vec3f(1.0));
  let encoded = select(1.055 * pow(x, vec3f(1.0 / 2.4)) - 0.055, 12.92 * x, x <= vec3f(0.0031308));
  let decoded = select(pow((x + 0.055) / 1.055, vec3f(2.4)), x / 12.92, x <= vec3f(0.04045));
  let recoded = select(encoded, decoded, encoding > 1.5);
  return vec4f(select(color.rgb, recoded, encoding > 0.5), color.a);
}
`;

const ATTRIBUTES = String.raw`(?:@\w+(?:\([^)]*\))?\s*)*`;

/** Names and types after the attributes in a list of members or arguments. */
function entriesOf(list) {
  const entries = list.replace(/\/\/.*/g, "").matchAll(
    new RegExp(`(${ATTRIBUTES})(\\w+)\\s*:\\s*([\\w<>]+)`, "g"));
  return Array.from(entries, ([, attributes, name, type]) => ({ attributes, name, type }));
}

const structOf = (text, name) => {
  const found = new RegExp(`struct ${name} \\{([^}]*)\\}`).exec(text);
  return found && entriesOf(found[1]);
};

/** Name of a uniform's variable: `object` is three's own where it has morph targets or skins. */
const variableOf = (name) => (name === "object" ? "look_object" : name);

/** The text with these names for variables; members of structs and comments stay. */
const withVariables = (text) => text.replace(
  /\/\/.*|struct \w+ \{[^}]*\}|(?<![\w.])object\b/g,
  (found) => (found === "object" ? variableOf(found) : found));

/**
 * The module as three.js takes it. three.js binds what a module reads, so that uniforms are private
 * variables here, which the calls below fill, and textures have the names that three.js gives.
 */
function moduleCode(module) {
  const entries = {};
  let text = module.wgsl.replace(
    /@(vertex|fragment)\s+fn (\w+)\(([^{]*?)\)(\s*->[^{]*)?\{/g,
    (_, stage, name, list, result = "") => {
      const type = result.replace(/->|@\w+(\([^)]*\))?/g, "").trim();
      entries[stage] = { name, list: entriesOf(list), result: type };
      const plain = (part) => part.replace(/@\w+(\([^)]*\))?\s*/g, "");
      return `fn ${name}(${plain(list)})${plain(result)}{`;
    },
  );
  const samplers = module.bindings.filter(({ kind }) => kind === "sampler");
  for (const binding of module.bindings) {
    const declaration = new RegExp(
      String.raw`@group\(\d+\)\s*@binding\(\d+\)\s*var(?:<uniform>)?\s+${binding.name}` +
      String.raw`\s*:\s*([^;]+);`);
    const named = declaration.exec(text)[1].trim();
    // Nodes want the types of textures themselves.
    const type = new RegExp(`alias ${named} = (texture_[^;]+);`).exec(text)?.[1] ?? named;
    binding.type = type;
    const isUniform = binding.kind === "uniform";
    text = text.replace(declaration, isUniform ? `var<private> ${binding.name}: ${type};` : "");
    // Arrays of uniforms want elements of a multiple of 16 bytes.
    const struct = new RegExp(String.raw`struct ${type} \{(?!\s*@align)`);
    if (isUniform) text = text.replace(struct, "$& @align(16)");
  }
  text = withVariables(text);
  // Names that three.js has for itself, where functions of the look have them too.
  text = text.replace(/(?<![\w.])(output|varyings|main|render|frame)(?=\s*\()/g, "look_$1");
  for (const sampler of samplers) {
    const read = new RegExp(`(\\w+)\\s*,\\s*${sampler.name}\\b`).exec(text);
    const textures = module.bindings.filter(({ kind }) => kind === "texture");
    const own = textures.find(({ name }) => name === read?.[1])
      ?? textures.find(({ feed }) => feed.image !== undefined && feed.image === sampler.feed.image);
    text = text.replace(new RegExp(`(?<!\\.)\\b${sampler.name}\\b`, "g"), `${own.name}_sampler`);
  }
  return { text: text + ENCODE, entries };
}

/** A material that runs one module of a look. `pass` is the pass that it draws. */
class ModuleMaterial extends THREE.NodeMaterial {
  constructor(look, pass, options, flipV = false) {
    super();
    this.flipV = flipV;
    const module = { ...look.modules[pass.module] };
    module.bindings = module.bindings.map((binding) => ({ ...binding }));
    this.module = module;
    this.pass = pass;
    this.fog = false;
    this.normal = new THREE.Matrix3();
    this.clip = new THREE.Matrix4();
    this.textures = [];
    this.frame = null;
    this.connect();
    this.setValues(options);
  }

  setup(builder) {
    if (!builder.renderer.backend.isWebGPUBackend) {
      throw new Error(`Chiaro: ${this.name}: this browser has no WebGPU, and WebGPURenderer has ` +
        "fallen back to WebGL: take WebGLRenderer and the other class of the look");
    }
    return super.setup(builder);
  }

  /** Nodes that give the module its uniforms, textures and attributes, and take its results. */
  connect() {
    const { module } = this;
    const { text, entries } = moduleCode(module);
    const included = code(text, [], "wgsl");
    // Arguments of every function: what the module reads from bindings.
    const uniforms = module.bindings.filter(({ kind }) => kind === "uniform");
    const pictures = module.bindings.filter(({ kind }) => kind === "texture");
    const inputs = {};
    for (const binding of uniforms) {
      inputs[`${binding.name}_`] = this.block(binding).element(uint(0));
    }
    for (const binding of pictures) inputs[`${binding.name}_`] = this.picture(binding);
    const bound = [...uniforms, ...pictures].map(({ name, type }) => `${name}_: ${type}`);
    const fill = uniforms.map(({ name }) => `  ${variableOf(name)} = ${name}_;\n`).join("");
    const call = (name, type, arguments_, result) => {
      const list = [...bound, ...arguments_.map(({ name: own, type: its }) => `${own}: ${its}`)];
      const body = `fn ${name}(${list.join(", ")}) -> ${type} {\n${fill}  return ${result};\n}`;
      const nodes = Object.fromEntries(arguments_.map(({ name: own, node }) => [own, node]));
      return wgslFn(body, [included])({ ...inputs, ...nodes });
    };
    const vertex = this.vertexArguments(entries.vertex, text);
    const run = `${entries.vertex.name}(${vertex.call})`;
    const varyings = structOf(text, entries.vertex.result);
    const clip = varyings?.find(({ attributes }) => attributes.includes("position"));
    this.vertexNode = call("chiaro_clip", "vec4f", vertex.list, clip ? `${run}.${clip.name}` : run);
    const carried = (varyings ?? []).filter((member) => member !== clip).map((member) => {
      const node = call(`chiaro_${member.name}`, member.type, vertex.list, `${run}.${member.name}`);
      const between = varying(node, `chiaro_v_${member.name}`);
      const flat = /@interpolate\((\w+)/.exec(member.attributes);
      if (flat) between.setInterpolation(flat[1]);
      return { name: `v_${member.name}`, type: member.type, node: between };
    });
    const seen = [
      { name: "frag_coord", type: "vec2f", node: screenCoordinate },
      { name: "is_front_", type: "bool", node: frontFacing },
    ];
    const members = (varyings ?? []).map((member) =>
      member === clip ? "vec4f(frag_coord, 0.0, 1.0)" : `v_${member.name}`);
    const given = entries.fragment.list.map(({ attributes, type }) => {
      if (attributes.includes("front_facing")) return "is_front_";
      if (attributes.includes("position")) return "vec4f(frag_coord, 0.0, 1.0)";
      return `${type}(${members.join(", ")})`;
    });
    const shaded = `${entries.fragment.name}(${given.join(", ")})`;
    const color = entries.fragment.result === "f32" ? `vec4f(${shaded}, 0.0, 0.0, 1.0)` : shaded;
    if (this.pass.name !== "draw") {
      this.fragmentNode = call("chiaro_color", "vec4f", [...carried, ...seen], color);
      return;
    }
    this.target = new Float32Array(4);
    const target = new THREE.BufferNode(this.target, "vec4", 1).setName("chiaro_target");
    const encoding = { name: "target_", type: "vec4f", node: target.element(uint(0)) };
    this.fragmentNode = call("chiaro_color", "vec4f", [...carried, ...seen, encoding],
      `chiaro_recoded(${color}, target_.x)`);
  }

  /** Arguments of the vertex function, and how it is called with them. */
  vertexArguments({ list }, text) {
    const arguments_ = [];
    const calls = list.map(({ attributes, name, type }) => {
      if (attributes.includes("vertex_index")) {
        arguments_.push({ name: "index_", type: "u32", node: vertexIndex });
        return "index_";
      }
      const members = structOf(text, type) ?? [{ name, type }];
      for (const member of members) {
        const size = { f32: "float", vec2f: "vec2", vec3f: "vec3", vec4f: "vec4" }[member.type];
        const node = attribute(member.name, size);
        arguments_.push({ name: `a_${member.name}`, type: member.type, node });
      }
      const values = members.map((member) =>
        member.name === "uv" && this.flipV ? "vec2f(a_uv.x, 1.0 - a_uv.y)" : `a_${member.name}`);
      return structOf(text, type) ? `${type}(${values.join(", ")})` : values[0];
    });
    return { list: arguments_, call: calls.join(", ") };
  }

  block(binding) {
    const floats = new Float32Array(Math.ceil(binding.size / 16) * 4);
    const node = new THREE.BufferNode(floats, binding.type, 1).setName(`${binding.name}_block`);
    node.onObjectUpdate((frame) => {
      this.fillBlock(binding, floats, frame);
    });
    return node;
  }

  picture(binding) {
    const isArray = binding.type.startsWith("texture_2d_array");
    const node = texture(blank(THREE, isArray)).setName(binding.name);
    // A binding of its own for each name, also where two names have one texture.
    node.getUniformHash = () => `${node.uuid}`;
    this.textures.push({ binding, node });
    return node;
  }

  fillBlock({ feed, members }, floats, { object, camera }) {
    // `compileAsync` asks for the uniforms of a picture that is not drawn yet.
    if (!this.frame) return;
    if (this.pass.name === "draw") checkAttributes(this.look, object);
    const { size, samples, state, shadows, layer } = this.frame;
    if (feed.from === "look") {
      const lit = withShadows(state(object, camera), shadows);
      floats.set(new Float32Array(this.module.prepare(lit)));
      return;
    }
    const values = {
      view: () => {
        this.clip.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
        return viewValues(camera, this.clip, 0);
      },
      object: () => objectValues(object, this.normal, 0),
      // Screen passes have no camera of their own: what counts is the picture's.
      curvature: () => curvatureValues(this.frame.camera, size[1], false, samples),
      light_layer: () => layer,
      light_caster: () => casterValues(object),
    };
    write(floats, members, values[feed.from]());
  }
}

const FORMATS = {
  rgba32float: THREE.RGBAFormat, rg32float: THREE.RGFormat, r32float: THREE.RedFormat,
};

/** The passes before a look's picture, for one renderer. */
class Passes {
  constructor(look) {
    this.look = look;
    this.targets = new Map();
    this.camera = new THREE.OrthographicCamera();
    const screen = new THREE.BufferGeometry();
    screen.setAttribute("position", new THREE.BufferAttribute(new Float32Array(9), 3));
    this.steps = passesBefore(look).map((pass) => {
      const [format, ...others] = pass.outputs.map((output) => FORMATS[output.format]);
      if (!format || others.length) {
        throw new Error(`Chiaro: ${look.name}: the pass ${pass.name} has a target unknown here`);
      }
      const isScreen = pass.draws === "screen";
      const layers = pass.draws === "lights" ? Math.max(layersOf(look), 2) : 1;
      const target = new THREE.RenderTarget(1, 1, {
        format, type: THREE.FloatType, depth: layers,
        minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
        depthBuffer: !isScreen, generateMipmaps: false, samples: 0,
      });
      const options = { blending: THREE.NoBlending, toneMapped: false };
      const material = (more) => {
        const made = new ModuleMaterial(look, pass, { ...options, ...more });
        connectTargets(made, this.targets);
        return made;
      };
      const step = { target };
      if (layers > 1) {
        step.both = material({ side: THREE.DoubleSide });
        step.cameras = Array.from({ length: layersOf(look) }, () => new THREE.Camera());
      } else if (isScreen) {
        step.triangle = new THREE.Mesh(screen, material({ depthTest: false, depthWrite: false }));
        step.triangle.frustumCulled = false;
        step.scene = new THREE.Scene().add(step.triangle);
      } else {
        step.front = material({});
        step.both = material({ side: THREE.DoubleSide });
      }
      this.targets.set(`${pass.name}.${pass.outputs[0].name}`, target.texture);
      return step;
    });
    this.twins = new WeakMap();
    this.users = new Users(() => this.dispose());
  }

  /** A camera like another: WebGPURenderer keeps one list of objects for a scene and a camera. */
  twinOf(camera) {
    if (!this.twins.has(camera)) this.twins.set(camera, new camera.constructor());
    const twin = this.twins.get(camera).copy(camera, false);
    twin.matrixWorldAutoUpdate = false;
    return twin;
  }

  /** Draws the passes for a picture of the scene, once for each call of `render`. */
  update({ renderer, scene, camera, object, renderId }, frame) {
    if (this.renderId === renderId && this.renderer === renderer) return;
    Object.assign(this, { renderId, renderer });
    const before = THREE.RendererUtils.resetRendererState(renderer);
    const twin = this.twinOf(camera);
    const shadows = renderer.shadowMap.autoUpdate;
    renderer.shadowMap.autoUpdate = false;
    renderer.setClearColor(0, 0);
    renderer.autoClear = true;
    try {
      if (this.steps.some(({ cameras }) => cameras)) {
        const clip = { isReversed: camera.reversedDepth, isWebGL: false };
        const state = frame.state(object, camera);
        this.shadows = shadowMapsOf(this.look, state, scene, frame.size[1], clip);
      }
      for (const step of this.steps) {
        const { target, front, both, triangle, scene: screen } = step;
        if (step.cameras) {
          this.updateLayers(step, renderer, scene, { ...frame, camera });
          continue;
        }
        target.setSize(...frame.size);
        renderer.setRenderTarget(target);
        for (const material of [front, both, triangle?.material]) {
          if (material) material.frame = { ...frame, camera };
        }
        if (triangle) renderer.render(screen, this.camera);
        else {
          const choose = ({ material }) => {
            const [first] = Array.isArray(material) ? material : [material];
            return first.side === THREE.DoubleSide ? both : front;
          };
          withMaterials(scene, choose, () => renderer.render(scene, twin));
        }
      }
    } finally {
      renderer.shadowMap.autoUpdate = shadows;
      THREE.RendererUtils.restoreRendererState(renderer, before);
    }
  }

  /** Draws the layers of a pass over shadow maps. */
  updateLayers({ target, both, cameras }, renderer, scene, frame) {
    const { side, layers } = this.shadows;
    target.setSize(side, side, target.depth);
    layers.forEach((layer, index) => {
      // The camera only decides what is left out. WebGPURenderer keeps a list for each.
      const light = cameras[index];
      light.layers.mask = frame.camera.layers.mask;
      light.coordinateSystem = renderer.coordinateSystem;
      light._reversedDepth = frame.camera.reversedDepth;
      light.projectionMatrix.fromArray(layer.clip_from_world);
      both.frame = { ...frame, layer };
      renderer.setRenderTarget(target, index);
      withMaterials(scene, (object) => castsShadow(object) && both,
        () => renderer.render(scene, light));
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

/** Gives a material's textures that come from passes the passes' targets. */
function connectTargets(material, targets) {
  for (const { binding, node } of material.textures) {
    const source = targets.get(sourceOf(material.pass, binding));
    if (source) node.value = source;
  }
}

/** The passes of looks, shared by all materials of a look where its values do not count. */
const passesOf = new WeakMap();

function passesFor(look) {
  if (look.passes.length === 1) return null;
  if (!arePassesShared(look)) return new Passes(look);
  if (!passesOf.has(look)) passesOf.set(look, new Passes(look));
  return passesOf.get(look);
}

/** Runs a function once for each call of `render` that draws a material. */
class EachRenderNode extends THREE.Node {
  constructor(node, run) {
    super("vec4");
    this.node = node;
    this.run = run;
    this.updateBeforeType = THREE.NodeUpdateType.RENDER;
  }

  updateBefore(frame) {
    this.run(frame);
  }

  setup() {
    return this.node;
  }
}

/** Says what to do, which a renderer that cannot draw nodes would not. */
function refuseRenderer(look, renderer) {
  if (!renderer?.isWebGLRenderer) return;
  throw new TypeError(`Chiaro: ${look.name}: this material is for WebGPURenderer: for ` +
    "WebGLRenderer, take the class of the look's .material.js");
}

/** A look as a material for WebGPURenderer. Use the class of the look, which is made from this. */
export class LookNodeMaterial extends withLook(ModuleMaterial, THREE) {
  constructor(look, files, { parameters, flipV = false, ...options } = {}) {
    const pass = look.passes.find(({ name }) => name === "draw");
    super(look, pass, optionsOf(THREE, look, pass, options), flipV);
    this.begin(look, files, parameters);
    for (const { binding, node } of this.textures) {
      const image = binding.feed.from === "image" && this.images[binding.feed.image];
      if (!image) continue;
      const take = () => (node.value = image.texture);
      take();
      image.ready.then(take, () => {});
    }
    this.passes = passesFor(look);
    if (this.passes) connectTargets(this, this.passes.targets);
    this.fragmentNode = new EachRenderNode(this.fragmentNode, (frame) => this.beginRender(frame));
  }

  /** WebGLRenderer calls this before it draws or compiles a material. */
  onBeforeCompile(_shader, renderer) {
    refuseRenderer(this.look, renderer);
  }

  onBeforeRender(renderer) {
    refuseRenderer(this.look, renderer);
  }

  clone() {
    // The nodes of the texture coordinates are made by the constructor.
    return new this.constructor({ flipV: this.flipV }).copy(this);
  }

  /** Numbers of the picture, and the passes before it. */
  beginRender(nodeFrame) {
    const { renderer, camera } = nodeFrame;
    this.updateSide();
    const target = renderer.getRenderTarget();
    const size = this.pictureSize(renderer);
    const samples = Math.max(target ? target.samples : renderer.currentSamples, 1);
    const state = (drawn, seen) => this.stateOf(placeOf(seen, drawn, size));
    this.frame = { size, samples, camera, state };
    this.target[0] = ENCODINGS[this.encodingFor(renderer, target)];
    this.passes?.users.add(this);
    this.passes?.update(nodeFrame, this.frame);
    this.frame.shadows = this.passes?.shadows;
  }

  /** WebGPURenderer draws light, and encodes the picture for the canvas if it does at all. */
  encodingFor(renderer, target) {
    if (this.encoding !== "auto") return this.encoding;
    const isPlain = !target && renderer.outputColorSpace === THREE.LinearSRGBColorSpace;
    return this.look.colorSpace === "display" && !isPlain ? "linear" : "none";
  }
}
