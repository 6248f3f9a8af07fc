// Looks in Babylon.js: a module's GLSL or WGSL in a ShaderMaterial.

import { Constants, ShaderMaterial } from "@babylonjs/core";
import { LookModule } from "./module.js";
import { checkMesh, objectValues, placeOf, viewValues } from "./scene.js";
import { recodingOf } from "./shaders.js";
import { passesFor } from "./targets.js";
import { loadImage } from "./textures.js";
import { write } from "./uniforms.js";
import { LookValues } from "./values.js";

/** A look as a material for Babylon.js. Use the class of the look, which is made from this. */
export class LookMaterial extends ShaderMaterial {
  constructor(name, scene, look, files, { parameters, encoding = "display" } = {}) {
    const pass = look.passes.at(-1);
    const module = new LookModule(scene, look, pass, recodingOf(look, encoding));
    super(name, scene, module.sources, {
      ...module.names, uniforms: [], needAlphaBlending: look.opaque === false,
    });
    this.look = look;
    this.module = module;
    this.values = new LookValues(look);
    this.parameters = this.values.parameters;
    this.lights = this.values.lights;
    // Where a parameter decides, it does so from here on.
    this.backFaceCulling = pass.sides !== "both" || pass.sides_parameter !== undefined;
    // Without culling, Babylon.js tells fronts only to materials that light both sides.
    this._twoSidedLighting = true;
    // Looks write depth where they are transparent, too, and cover what they are drawn over: the
    // usual mode of Babylon.js adds up alpha.
    this.forceDepthWrite = true;
    this.alphaMode = Constants.ALPHA_LAYER_ACCUMULATE;
    this.passes = passesFor(scene, look, this);
    this.getRenderTargetTextures = this.passes && (() => this.passes.begin());
    this.passes?.connect(pass, module, (binding, target) => this.setTexture(binding, target));
    /** The look's images by their names in the shader. */
    this.images = new Map();
    const images = module.textures.filter(({ feed }) => feed.from === "image");
    /** Resolves when the look's images are there. */
    this.ready = Promise.all(images.map(async ({ feed, shaderName }) => {
      const { texture, loaded } = loadImage(scene, look, look.images[feed.image], files);
      this.take(shaderName, texture);
      this.take(shaderName, await loaded);
    })).then(() => this);
    this.ready.catch((error) => console.error(`Chiaro: ${look.name}: ${error.message}`));
    Object.assign(this.parameters, parameters);
  }

  /** Takes a texture of this material's own in the place of the one before. */
  take(shaderName, texture) {
    const before = this.images?.get(shaderName);
    if (before !== texture) before?.dispose();
    if (!this.images) texture.dispose();
    else {
      this.images.set(shaderName, texture);
      this.setTexture(shaderName, texture);
    }
  }

  get hasRenderTargetTextures() {
    return Boolean(this.passes);
  }

  /** Seconds, for looks that change with time. */
  get time() {
    return this.values.time;
  }

  set time(seconds) {
    this.values.time = seconds;
  }

  /** Both sides are shown while a parameter of the look cuts parts away. */
  get backFaceCulling() {
    const pass = this.look?.passes.at(-1);
    return super.backFaceCulling && !(this.parameters?.[pass?.sides_parameter] > 0);
  }

  set backFaceCulling(isCulled) {
    super.backFaceCulling = isCulled;
  }

  bind(world, mesh, effectOverride, subMesh) {
    const effect = effectOverride ?? subMesh?.effect ?? this.getEffect();
    if (!effect) return;
    checkMesh(this.look, this.module, mesh);
    super.bind(world, mesh, effectOverride, subMesh);
    this.module.bind(effect, (block) => this.fill(block, mesh, world));
  }

  /** Writes the bytes of a block. */
  fill({ feed, members, floats }, mesh, world) {
    const scene = this.getScene();
    const engine = scene.getEngine();
    const size = [engine.getRenderWidth(), engine.getRenderHeight()];
    if (feed.from === "view") write(floats, members, viewValues(scene, size[1]));
    else if (feed.from === "object") write(floats, members, objectValues(scene, mesh, world));
    else {
      const state = this.values.state(placeOf(scene, mesh, world, size));
      const lights = { ...state.lights };
      for (const [id, place] of Object.entries(this.passes?.shadows?.places ?? {})) {
        lights[id] = { ...lights[id], shadow_map: place };
      }
      floats.set(new Float32Array(this.module.prepare({ ...state, lights })));
    }
  }

  dispose(...options) {
    this.module.dispose();
    this.passes?.release(this);
    for (const texture of this.images?.values() ?? []) texture.dispose();
    // Images that come later are not kept.
    this.images = null;
    super.dispose(...options);
  }
}
