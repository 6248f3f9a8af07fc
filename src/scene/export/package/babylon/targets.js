// The passes before a look's picture: render target textures, which Babylon.js draws before the
// picture of each camera, as it does mirrors.

import {
  Color4, Constants, DrawWrapper, EffectRenderer, Observable, RenderTargetTexture, ShaderMaterial,
  SmartArray,
} from "@babylonjs/core";
import { LookModule } from "./module.js";
import { arePassesShared, passesBefore, sourceOf } from "./passes.js";
import {
  casterValues, curvatureValues, isDrawn, objectValues, placeOf, sphereOf, viewValues,
} from "./scene.js";
import { layersOf, shadowMaps, sphereAround } from "./shadows.js";
import { write } from "./uniforms.js";

const FORMATS = {
  rgba32float: Constants.TEXTUREFORMAT_RGBA,
  rg32float: Constants.TEXTUREFORMAT_RG,
  r32float: Constants.TEXTUREFORMAT_R,
};

/** Size in pixels of the picture that the scene's camera draws next. */
function pictureSize(scene) {
  const drawn = scene.activeCamera.outputRenderTarget ?? scene.getEngine();
  return [drawn.getRenderWidth(), drawn.getRenderHeight()];
}

/** Samples a pixel of that picture. */
function samplesOf(scene) {
  const target = scene.activeCamera.outputRenderTarget;
  if (target) return target.samples;
  const engine = scene.getEngine();
  return engine.currentSampleCount ?? engine._gl.getParameter(engine._gl.SAMPLES);
}

/** Clip space of what is drawn into textures: rows run upward in both engines. */
function clipOf(engine) {
  const ends = [engine.isNDCHalfZRange ? 0 : -1, 1];
  const [near, far] = engine.useReverseDepthBuffer ? ends.reverse() : ends;
  return { near, far, flipsRows: true };
}

/** A material that draws one pass over meshes. */
class PassMaterial extends ShaderMaterial {
  constructor(scene, module, name, fill) {
    super(name, scene, module.sources, { ...module.names, uniforms: [] });
    this.module = module;
    this.fill = fill;
    // Without culling, Babylon.js tells fronts only to materials that light both sides.
    this._twoSidedLighting = true;
    this.alphaMode = Constants.ALPHA_DISABLE;
    this.doNotSerialize = true;
  }

  bind(world, mesh, effectOverride, subMesh) {
    super.bind(world, mesh, effectOverride, subMesh);
    const effect = effectOverride ?? this.getEffect();
    if (effect) this.module.bind(effect, (block) => this.fill(block, mesh, world));
  }
}

/** A pass over the meshes of the scene, or over what casts shadows. */
class MeshTarget extends RenderTargetTexture {
  constructor(passes, pass, layers) {
    const { scene, look } = passes;
    super(pass.name, layers ? { width: 1, height: 1, layers } : { width: 1, height: 1 }, scene, {
      type: Constants.TEXTURETYPE_FLOAT,
      format: FORMATS[pass.outputs[0].format],
      samplingMode: Constants.TEXTURE_NEAREST_SAMPLINGMODE,
      gammaSpace: false,
    });
    this.passes = passes;
    this.pass = pass;
    this.clearColor = new Color4(...pass.outputs[0].clear);
    this.ignoreCameraViewport = layers > 0;
    this.forceLayerMaskCheck = layers === 0;
    this.renderSprites = this.renderParticles = false;
    this.isLayered = layers > 0;
    this.layer = 0;
    this.made = new Map();
    this.module = () => new LookModule(scene, look, pass);
    this.renderListPredicate = isDrawn;
    this.onBeforeBindObservable.add(() => this.begin());
    this.onBeforeRenderObservable.add((layer) => (this.layer = layer));
  }

  /** Sizes the target, and gives each mesh the material that shows the sides that it has. */
  begin() {
    const { passes } = this;
    const [width, height] = this.isLayered ? passes.beginShadows() : pictureSize(passes.scene);
    if (this.getRenderWidth() !== width || this.getRenderHeight() !== height) {
      this.resize(this.isLayered
        ? { width, height, layers: this.getRenderLayers() } : { width, height });
    }
    for (const mesh of this.renderList) this.setMaterialForRendering(mesh, this.materialOf(mesh));
  }

  materialOf(mesh) {
    const { passes } = this;
    const own = mesh.material ?? passes.scene.defaultMaterial;
    const isCulled = own.backFaceCulling && !this.isLayered;
    const key = `${isCulled} ${own.sideOrientation}`;
    if (!this.made.has(key)) {
      const fill = (block, drawn, world) => passes.fill(this, block, drawn, world);
      const made = new PassMaterial(passes.scene, this.module(), this.pass.name, fill);
      Object.assign(made, { backFaceCulling: isCulled, sideOrientation: own.sideOrientation });
      passes.connect(this.pass, made.module, (name, texture) => made.setTexture(name, texture));
      this.made.set(key, made);
    }
    return this.made.get(key);
  }

  dispose() {
    for (const made of this.made?.values() ?? []) {
      made.module.dispose();
      made.dispose();
    }
    super.dispose();
  }
}

/** One triangle that covers a picture. */
const TRIANGLE = { positions: [-1, -1, 3, -1, -1, 3], indices: [0, 1, 2] };

/** A pass over the pixels of the picture. */
class ScreenTarget extends RenderTargetTexture {
  constructor(passes, pass) {
    const { scene, look } = passes;
    super(pass.name, { width: 1, height: 1 }, scene, {
      type: Constants.TEXTURETYPE_FLOAT,
      format: FORMATS[pass.outputs[0].format],
      samplingMode: Constants.TEXTURE_NEAREST_SAMPLINGMODE,
      gammaSpace: false,
      generateDepthBuffer: false,
    });
    Object.assign(this, { passes, pass });
    const engine = scene.getEngine();
    this.module = new LookModule(scene, look, pass);
    const { names } = this.module;
    this.effect = engine.createEffect(this.module.sources, {
      attributes: [],
      uniformsNames: [],
      uniformBuffersNames: names.uniformBuffers,
      samplers: names.samplers,
      defines: "",
      shaderLanguage: names.shaderLanguage,
    }, engine);
    const drawWrapper = new DrawWrapper(engine);
    drawWrapper.effect = this.effect;
    const onApplyObservable = new Observable();
    onApplyObservable.add(() => {
      passes.connect(pass, this.module, (name, texture) => this.effect.setTexture(name, texture));
      this.module.bind(this.effect, (block) => passes.fill(this, block));
    });
    this.wrapper = { effect: this.effect, drawWrapper, onApplyObservable };
    this.screen = new EffectRenderer(engine, TRIANGLE);
  }

  isReadyForRendering() {
    return this.effect.isReady();
  }

  render() {
    const [width, height] = pictureSize(this.passes.scene);
    if (this.getRenderWidth() !== width || this.getRenderHeight() !== height) {
      this.resize({ width, height });
    }
    const engine = this.getScene().getEngine();
    engine.setAlphaMode(Constants.ALPHA_DISABLE);
    this.screen.render(this.wrapper, this);
    this.getScene().resetCachedMaterial();
  }

  dispose() {
    this.screen?.dispose();
    this.module?.dispose();
    super.dispose();
  }
}

/** The passes of a look in a scene. */
export class Passes {
  constructor(scene, look) {
    this.scene = scene;
    this.look = look;
    /** Targets by the names of pass and output, in the order in which they are drawn. */
    this.targets = new Map();
    this.list = new SmartArray(4);
    /** Materials that have these passes, which are freed with the last of them. */
    this.users = new Set();
    for (const pass of passesBefore(look)) {
      if (!FORMATS[pass.outputs[0].format] || pass.outputs.length > 1) {
        throw new Error(`Chiaro: ${look.name}: the pass ${pass.name} has a target unknown here`);
      }
      const layers = pass.draws === "lights" ? Math.max(layersOf(look), 2) : 0;
      const target = pass.draws === "screen"
        ? new ScreenTarget(this, pass) : new MeshTarget(this, pass, layers);
      this.targets.set(`${pass.name}.${pass.outputs[0].name}`, target);
      this.list.push(target);
    }
  }

  /** Gives a module's textures the targets that they read. */
  connect(pass, { textures }, set) {
    for (const binding of textures) {
      const target = this.targets.get(sourceOf(pass, binding));
      if (target) set(binding.shaderName, target);
    }
  }

  /** A material and the first mesh that wears it, for what lights and the look are about. */
  wearer() {
    const mesh = this.scene.meshes.find(({ material }) => material?.passes === this);
    return { mesh, material: mesh?.material };
  }

  /** The look's state for a mesh. */
  state(mesh, material) {
    const size = pictureSize(this.scene);
    return material.values.state(placeOf(this.scene, mesh, mesh.getWorldMatrix(), size));
  }

  /** Places the layers of shadow maps for the picture; the size of a layer. */
  beginShadows() {
    const { mesh, material } = this.wearer();
    if (!mesh) return [1, 1];
    const spheres = this.scene.meshes.filter(isDrawn).map((one) => sphereOf(this.scene, one));
    const [, height] = pictureSize(this.scene);
    const clip = clipOf(this.scene.getEngine());
    const sphere = sphereAround(spheres);
    this.shadows = shadowMaps(this.look, this.state(mesh, material), sphere, height, clip);
    return [this.shadows.side, this.shadows.side];
  }

  /** Writes the bytes of a block of a pass. */
  fill(target, { feed, members, floats }, mesh, world) {
    const { scene } = this;
    const height = target.getRenderHeight();
    const values = {
      view: () => viewValues(scene, height),
      object: () => objectValues(scene, mesh, world),
      curvature: () => curvatureValues(scene, height, this.samples),
      light_layer: () => this.shadows?.layers[target.layer] ?? {},
      light_caster: () => casterValues(scene, mesh, world),
    };
    if (feed.from !== "look") {
      write(floats, members, values[feed.from]());
      return;
    }
    const wearer = this.wearer();
    if (!wearer.mesh) return;
    const state = this.state(mesh ?? wearer.mesh, wearer.material);
    floats.set(new Float32Array(this.look.modules[target.pass.module].prepare(state)));
  }

  /** The targets, as Babylon.js asks for them before it draws a camera's picture. */
  begin() {
    if (this.scene.activeCamera) this.samples = Math.max(samplesOf(this.scene), 1);
    return this.list;
  }

  /** Frees what is drawn for a material, unless other materials have it, too. */
  release(material) {
    if (!this.users.delete(material) || this.users.size > 0) return;
    const shared = sharedOf.get(this.scene);
    if (shared?.get(this.look) === this) shared.delete(this.look);
    for (const target of this.targets.values()) target.dispose();
  }
}

/** Passes that are the same for all materials of a look. */
const sharedOf = new WeakMap();

/** The passes of a look for a new material; `null` for a look without any. */
export function passesFor(scene, look, material) {
  if (passesBefore(look).length === 0) return null;
  if (!sharedOf.has(scene)) sharedOf.set(scene, new Map());
  const known = arePassesShared(look) ? sharedOf.get(scene) : new Map();
  if (!known.has(look)) known.set(look, new Passes(scene, look));
  const passes = known.get(look);
  passes.users.add(material);
  return passes;
}
