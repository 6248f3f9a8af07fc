// A module of a look as shaders of Babylon.js, and the buffers that they read.

import { ShaderLanguage, UniformBuffer } from "@babylonjs/core";
import { glslOf, wgslOf } from "./shaders.js";

/** The module that a pass runs, for the engine of a scene. */
export class LookModule {
  constructor(scene, look, pass, recoding = null) {
    const module = look.modules[pass.module];
    const engine = scene.getEngine();
    const isWebGPU = engine.isWebGPU === true;
    const nameOf = (binding) => (isWebGPU ? binding.name : binding.glsl?.name);
    const named = (kind) => module.bindings.filter((binding) => binding.kind === kind)
      .map((binding) => ({ ...binding, shaderName: nameOf(binding) }));
    this.sources = (isWebGPU ? wgslOf : glslOf)(module, pass, recoding);
    this.language = isWebGPU ? ShaderLanguage.WGSL : ShaderLanguage.GLSL;
    this.attributes = module.attributes.map(({ name }) => name);
    this.textures = named("texture");
    this.prepare = module.prepare;
    this.blocks = named("uniform").map((binding) => {
      const size = Math.ceil(binding.size / 16);
      // Not a dynamic one, for in WebGPU all draws of a frame would read what was written last.
      const buffer = new UniformBuffer(engine, undefined, false, binding.shaderName);
      buffer.addUniform("bytes", 4, size);
      buffer.create();
      return { ...binding, buffer, floats: new Float32Array(4 * size) };
    });
  }

  /** Names as the constructors of materials and effects take them. */
  get names() {
    return {
      attributes: this.attributes,
      uniformBuffers: this.blocks.map(({ shaderName }) => shaderName),
      samplers: this.textures.map(({ shaderName }) => shaderName),
      shaderLanguage: this.language,
    };
  }

  /** Gives the buffers their bytes: `fill` writes those of a block. */
  bind(effect, fill) {
    for (const block of this.blocks) {
      const { buffer, floats, shaderName } = block;
      fill(block);
      buffer.updateUniformArray("bytes", floats, floats.length);
      buffer.update();
      effect.bindUniformBuffer(buffer.getBuffer(), shaderName);
    }
  }

  dispose() {
    for (const { buffer } of this.blocks) buffer.dispose();
  }
}
