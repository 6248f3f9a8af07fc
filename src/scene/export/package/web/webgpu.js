// Drawing by WebGPU. `WebGl2Executor` has the same methods.

const WEBGPU_FORMATS = { vec2f: "float32x2", vec3f: "float32x3", vec4f: "float32x4" };

/** Shader that shows the picture on the page. Its alpha is multiplied in, as the page wants it. */
const WEBGPU_SHOWING = (isLinear) => `
@group(0) @binding(0) var picture: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1) * 4.0 - 1.0, f32(index >> 1) * 4.0 - 1.0, 0.0, 1.0);
}

fn encode(x: vec3f) -> vec3f {
    return select(1.055 * pow(x, vec3f(1.0 / 2.4)) - 0.055, 12.92 * x, x <= vec3f(0.0031308));
}

@fragment
fn fs_main(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let found = textureLoad(picture, vec2i(at.xy), 0);
    let straight = clamp(found.rgb / max(found.a, 1e-6), vec3f(0.0), vec3f(1.0));
    return vec4f(${isLinear ? "encode(straight)" : "straight"} * found.a, found.a);
}`;

class WebGpuExecutor {
  label = "WebGPU";
  clip = { near: 0, far: 1, flipsRows: false };

  /** An executor that draws on `canvas`. Rejects, with the reason, where WebGPU is missing. */
  static async create(canvas, content) {
    if (!navigator.gpu) throw new Error("this browser has no WebGPU");
    const adapter = await navigator.gpu.requestAdapter();
    if (!adapter) throw new Error("WebGPU finds no graphics card");
    const blocks = "texture-compression-bc";
    const requiredFeatures = adapter.features.has(blocks) ? [blocks] : [];
    const device = await adapter.requestDevice({ requiredFeatures });
    const executor = new WebGpuExecutor();
    Object.assign(executor, content, { canvas, device, adapter });
    device.pushErrorScope("validation");
    executor.uploadMesh();
    executor.uploadImages();
    const problem = await device.popErrorScope();
    if (problem) throw new Error(problem.message);
    await executor.compile();
    return executor;
  }

  /** Name of what draws. */
  get driver() {
    const { architecture, description } = this.adapter.info ?? {};
    return `${architecture} ${description}`;
  }

  uploadMesh() {
    const upload = (array, usage) => {
      const size = Math.ceil(array.byteLength / 4) * 4;
      const buffer = this.device.createBuffer({ size, usage: usage | GPUBufferUsage.COPY_DST });
      this.device.queue.writeBuffer(buffer, 0, array);
      return buffer;
    };
    this.indices = upload(this.mesh.indices, GPUBufferUsage.INDEX);
    this.vertices = {};
    for (const [name, array] of Object.entries(this.mesh.attributes)) {
      this.vertices[name] = upload(array, GPUBufferUsage.VERTEX);
    }
  }

  uploadImages() {
    this.textures = this.images.map((image, index) => this.uploadImage(image, index));
    this.samplers = this.look.images.map(({ wrap, filter }) => {
      const mode = { repeat: "repeat", clamp: "clamp-to-edge", mirror: "mirror-repeat" }[wrap];
      const filters = { magFilter: filter, minFilter: filter };
      return this.device.createSampler({ addressModeU: mode, addressModeV: mode, ...filters });
    });
  }

  uploadImage(image, index) {
    if (image.isBlocks && !this.device.features.has("texture-compression-bc")) {
      throw new Error("this graphics card does not read textures in BC7 blocks");
    }
    const isDecoded = isDecodedBySampling(this.look, index);
    const flat = isDecoded ? "rgba8unorm-srgb" : "rgba8unorm";
    const format = image.isBlocks ? "bc7-rgba-unorm" : flat;
    const size = [image.width, image.height, image.layers ?? 1];
    const { TEXTURE_BINDING, COPY_DST, RENDER_ATTACHMENT } = GPUTextureUsage;
    const drawn = image.isBlocks ? 0 : RENDER_ATTACHMENT;
    const texture = this.device.createTexture({
      size, format, usage: TEXTURE_BINDING | COPY_DST | drawn,
    });
    if (image.bitmap) {
      const place = { texture, premultipliedAlpha: false };
      this.device.queue.copyExternalImageToTexture({ source: image.bitmap }, place, size);
    } else {
      // Four texels are 16 bytes, and so are the sixteen of a block.
      const bytesPerRow = 4 * image.width;
      const rowsPerImage = image.isBlocks ? image.height / 4 : image.height;
      const layout = { bytesPerRow, rowsPerImage };
      this.device.queue.writeTexture({ texture }, image.bytes, layout, size);
    }
    return texture.createView({ dimension: image.isFlat ? "2d" : "2d-array" });
  }

  /** Compiles the modules, and the pipelines that the first picture needs. */
  async compile() {
    this.modules = {};
    for (const [name, module] of Object.entries(this.look.modules)) {
      const code = this.device.createShaderModule({ code: module.wgsl, label: name });
      const entries = module.bindings.map((binding) => this.layoutEntry(binding));
      const layout = this.device.createBindGroupLayout({ entries });
      const pipelineLayout = this.device.createPipelineLayout({ bindGroupLayouts: [layout] });
      this.modules[name] = { ...module, code, layout, pipelineLayout };
    }
    this.pipelines = new Map();
    this.buffers = new Map();
    this.format = navigator.gpu.getPreferredCanvasFormat();
    const isLinear = this.look.colorSpace === "linear";
    const shown = this.device.createShaderModule({ code: WEBGPU_SHOWING(isLinear) });
    this.showing = await this.device.createRenderPipelineAsync({
      layout: "auto",
      vertex: { module: shown },
      fragment: { module: shown, targets: [{ format: this.format }] },
    });
    this.context = this.canvas.getContext("webgpu");
    const { device, format } = this;
    this.context.configure({ device, format, alphaMode: "premultiplied" });
    const first = this.look.passes.map(async (pass) => {
      const [key, descriptor] = this.pipelineOf(pass, pass.sides === "both", this.samples);
      this.pipelines.set(key, await this.device.createRenderPipelineAsync(descriptor));
    });
    await Promise.all(first);
  }

  layoutEntry({ kind, type, feed, wgsl }) {
    const visibility = GPUShaderStage.VERTEX | GPUShaderStage.FRAGMENT;
    const entry = { binding: wgsl.binding, visibility };
    if (kind === "uniform") return { ...entry, buffer: {} };
    if (kind === "sampler") return { ...entry, sampler: {} };
    const isArray = feed.from === "image" && this.look.images[feed.image].kind === "hcbtf";
    const viewDimension = isArray || type?.includes("array") ? "2d-array" : "2d";
    const sampleType = feed.from === "image" ? "float" : "unfilterable-float";
    return { ...entry, texture: { sampleType, viewDimension } };
  }

  /** Key and descriptor of the pipeline of a pass. */
  pipelineOf(pass, both, samples) {
    const module = this.modules[pass.module];
    const isPicture = pass.name === "draw";
    const drawsMeshes = pass.draws !== "screen";
    const count = isPicture ? samples : 1;
    // What casts shadows does so with both sides.
    const showsBacks = both || pass.draws !== "meshes";
    const { vertex, fragment } = module.entry_points;
    const attributes = drawsMeshes ? module.attributes : [];
    const buffers = attributes.map(({ type, location }) => ({
      arrayStride: 4 * Number(type[3]),
      attributes: [{ shaderLocation: location, offset: 0, format: WEBGPU_FORMATS[type] }],
    }));
    const over = { srcFactor: "src-alpha", dstFactor: "one-minus-src-alpha" };
    const blend = { color: over, alpha: { srcFactor: "one", dstFactor: "one-minus-src-alpha" } };
    const targets = isPicture
      ? [{ format: "rgba16float", blend }]
      : pass.outputs.map(({ format }) => ({ format }));
    const descriptor = {
      label: pass.name,
      layout: module.pipelineLayout,
      vertex: { module: module.code, entryPoint: vertex, buffers },
      fragment: { module: module.code, entryPoint: fragment, targets },
      primitive: {
        frontFace: this.mesh.isMirrored ? "cw" : "ccw",
        cullMode: showsBacks ? "none" : "back",
      },
      multisample: { count },
    };
    if (drawsMeshes) {
      const depth = { format: "depth32float", depthCompare: "less", depthWriteEnabled: true };
      descriptor.depthStencil = depth;
    }
    return [`${pass.name} ${both} ${count}`, descriptor];
  }

  pipeline(pass, both, samples) {
    const [key, descriptor] = this.pipelineOf(pass, both, samples);
    let found = this.pipelines.get(key);
    if (!found) {
      found = this.device.createRenderPipeline(descriptor);
      this.pipelines.set(key, found);
    }
    return found;
  }

  /** The textures that the passes draw into, for one size. */
  targetsOf([width, height], samples) {
    const { RENDER_ATTACHMENT, TEXTURE_BINDING, COPY_SRC } = GPUTextureUsage;
    const all = [];
    const make = (format, usage, sampleCount = 1) => {
      const size = [width, height];
      const texture = this.device.createTexture({ size, format, usage, sampleCount });
      all.push(texture);
      return texture.createView();
    };
    const found = { size: [width, height], samples, images: {}, depths: {} };
    for (const pass of this.look.passes) {
      if (pass.draws === "lights") continue;
      const isPicture = pass.name === "draw";
      if (pass.draws === "meshes") {
        const count = isPicture ? samples : 1;
        found.depths[pass.name] = make("depth32float", RENDER_ATTACHMENT, count);
      }
      for (const output of isPicture ? [] : pass.outputs) {
        const usage = RENDER_ATTACHMENT | TEXTURE_BINDING;
        found.images[`${pass.name}.${output.name}`] = make(output.format, usage);
      }
    }
    found.picture = make("rgba16float", RENDER_ATTACHMENT | TEXTURE_BINDING | COPY_SRC);
    found.pictureTexture = all.at(-1);
    found.sampled = samples > 1 ? make("rgba16float", RENDER_ATTACHMENT, samples) : null;
    found.destroy = () => all.forEach((texture) => texture.destroy());
    return found;
  }

  /** Draws all passes of a frame into `targets`. */
  run(frame, targets) {
    const encoder = this.device.createCommandEncoder();
    if (frame.shadows) this.runShadows(encoder, frame);
    for (const pass of this.look.passes) {
      if (pass.draws !== "lights") this.runPass(encoder, pass, frame, targets);
    }
    return encoder;
  }

  /** Draws what lights see, where a light has moved since it was drawn last. */
  runShadows(encoder, frame) {
    const { side, layers } = frame.shadows;
    const passes = this.look.passes.filter(({ draws }) => draws === "lights");
    if (this.shadows?.side !== side || this.shadows.count !== layers.length) {
      this.shadows?.destroy();
      this.shadows = this.shadowTargets(passes, side, layers.length);
    }
    const drawn = JSON.stringify(layers);
    if (drawn === this.shadows.drawn) return;
    this.shadows.drawn = drawn;
    for (const pass of passes) {
      layers.forEach((_, layer) => {
        const image = ({ name, clear }) => ({
          view: this.shadows.layers[`${pass.name}.${name}`][layer],
          loadOp: "clear", storeOp: "store", clearValue: clear,
        });
        const depth = { depthClearValue: 1, depthLoadOp: "clear", depthStoreOp: "discard" };
        const drawing = encoder.beginRenderPass({
          label: pass.name,
          colorAttachments: pass.outputs.map(image),
          depthStencilAttachment: { view: this.shadows.depth, ...depth },
        });
        drawing.setPipeline(this.pipeline(pass, true, 1));
        const module = this.modules[pass.module];
        drawing.setBindGroup(0, this.bindGroup(pass, module, frame, this.shadows, layer));
        this.bindMesh(drawing, module);
        drawing.drawIndexed(this.mesh.indices.length);
        drawing.end();
      });
    }
  }

  /** The textures of shadow maps, with views of all layers and of each. */
  shadowTargets(passes, side, count) {
    const { RENDER_ATTACHMENT, TEXTURE_BINDING } = GPUTextureUsage;
    const all = [];
    const make = (format, usage, layers) => {
      const texture = this.device.createTexture({ size: [side, side, layers], format, usage });
      all.push(texture);
      return texture;
    };
    const found = { side, count, images: {}, layers: {} };
    for (const pass of passes) {
      for (const { name, format } of pass.outputs) {
        const layers = Math.max(count, 2);
        const texture = make(format, RENDER_ATTACHMENT | TEXTURE_BINDING, layers);
        const key = `${pass.name}.${name}`;
        found.images[key] = texture.createView({ dimension: "2d-array" });
        found.layers[key] = Array.from({ length: layers }, (_, layer) =>
          texture.createView({ dimension: "2d", baseArrayLayer: layer, arrayLayerCount: 1 }));
      }
    }
    found.depth = make("depth32float", RENDER_ATTACHMENT, 1).createView();
    found.destroy = () => all.forEach((texture) => texture.destroy());
    return found;
  }

  runPass(encoder, pass, frame, targets) {
    const isPicture = pass.name === "draw";
    const cleared = { loadOp: "clear", storeOp: "store", clearValue: [0, 0, 0, 0] };
    const picture = targets.sampled
      ? { ...cleared, view: targets.sampled, resolveTarget: targets.picture, storeOp: "discard" }
      : { ...cleared, view: targets.picture };
    const image = ({ name, clear }) =>
      ({ ...cleared, clearValue: clear, view: targets.images[`${pass.name}.${name}`] });
    const colorAttachments = isPicture ? [picture] : pass.outputs.map(image);
    const descriptor = { colorAttachments, label: pass.name };
    if (pass.draws === "meshes") {
      const view = targets.depths[pass.name];
      const depth = { view, depthClearValue: 1, depthLoadOp: "clear", depthStoreOp: "discard" };
      descriptor.depthStencilAttachment = depth;
    }
    const drawing = encoder.beginRenderPass(descriptor);
    const module = this.modules[pass.module];
    if (pass.draws === "screen") {
      drawing.setPipeline(this.pipeline(pass, false, 1));
      drawing.setBindGroup(0, this.bindGroup(pass, module, frame, targets, 0));
      drawing.draw(3);
    } else {
      this.bindMesh(drawing, module);
      this.mesh.parts.forEach((part, number) => {
        const both = frame.drawsBoth(pass, part);
        drawing.setPipeline(this.pipeline(pass, both, frame.samples));
        drawing.setBindGroup(0, this.bindGroup(pass, module, frame, targets, number));
        drawing.drawIndexed(part.count, 1, part.first);
      });
    }
    drawing.end();
  }

  bindMesh(drawing, module) {
    module.attributes.forEach(({ name }, slot) => {
      drawing.setVertexBuffer(slot, this.vertices[name]);
    });
    drawing.setIndexBuffer(this.indices, "uint32");
  }

  bindGroup(pass, module, frame, targets, part) {
    const entries = module.bindings.map((binding) => {
      const { feed, kind, name, wgsl } = binding;
      let resource;
      if (kind === "uniform") {
        const buffer = this.buffer(`${pass.module} ${name} ${part}`, binding.size);
        this.device.queue.writeBuffer(buffer, 0, frame.bytes(pass.module, binding, part));
        resource = { buffer };
      } else if (feed.from === "image") {
        resource = this.textures[feed.image];
      } else if (feed.from === "sampler") {
        resource = this.samplers[feed.image];
      } else {
        const source = sourceOf(pass, binding);
        resource = targets.images[source] ?? this.shadows.images[source];
      }
      return { binding: wgsl.binding, resource };
    });
    return this.device.createBindGroup({ layout: module.layout, entries });
  }

  buffer(key, size) {
    let found = this.buffers.get(key);
    if (!found) {
      const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
      found = this.device.createBuffer({ size: Math.ceil(size / 16) * 16, usage });
      this.buffers.set(key, found);
    }
    return found;
  }

  /** Draws a frame on the page. */
  show(frame) {
    const [width, height] = frame.size;
    const is = this.targets;
    if (!is || is.size[0] !== width || is.size[1] !== height || is.samples !== frame.samples) {
      is?.destroy();
      this.targets = this.targetsOf(frame.size, frame.samples);
    }
    const encoder = this.run(frame, this.targets);
    const view = this.context.getCurrentTexture().createView();
    const drawing = encoder.beginRenderPass({
      colorAttachments: [{ view, loadOp: "clear", storeOp: "store" }],
    });
    drawing.setPipeline(this.showing);
    const entries = [{ binding: 0, resource: this.targets.picture }];
    const layout = this.showing.getBindGroupLayout(0);
    drawing.setBindGroup(0, this.device.createBindGroup({ layout, entries }));
    drawing.draw(3);
    drawing.end();
    this.device.queue.submit([encoder.finish()]);
  }

  /** The numbers of a frame drawn beside the page: premultiplied RGBA, the top row first. */
  async read(frame) {
    const targets = this.targetsOf(frame.size, frame.samples);
    const encoder = this.run(frame, targets);
    const [width, height] = frame.size;
    const bytesPerRow = Math.ceil((8 * width) / 256) * 256;
    const usage = GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ;
    const buffer = this.device.createBuffer({ size: bytesPerRow * height, usage });
    encoder.copyTextureToBuffer(
      { texture: targets.pictureTexture }, { buffer, bytesPerRow }, [width, height],
    );
    this.device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const halves = new Uint16Array(buffer.getMappedRange());
    const numbers = new Float32Array(4 * width * height);
    for (let row = 0; row < height; row++) {
      for (let i = 0; i < 4 * width; i++) {
        numbers[row * 4 * width + i] = numberFromHalf(halves[(row * bytesPerRow) / 2 + i]);
      }
    }
    buffer.destroy();
    targets.destroy();
    return numbers;
  }

  /** Calls `then` with the reason when the graphics card is lost, once. */
  onLost(then) {
    this.device.lost.then(({ message }) => this.isClosed || then(message));
  }

  /** Resolves when everything is drawn that was asked for. */
  finished() {
    return this.device.queue.onSubmittedWorkDone();
  }

  /** Draws another mesh with the same attributes from now on. */
  replaceMesh(mesh) {
    const before = [this.indices, ...Object.values(this.vertices)];
    this.mesh = mesh;
    this.uploadMesh();
    before.forEach((buffer) => buffer.destroy());
    // Which side is the front is part of a pipeline, and shadow maps show the mesh before.
    this.pipelines.clear();
    this.shadows?.destroy();
    this.shadows = null;
  }

  destroy() {
    this.isClosed = true;
    this.targets?.destroy();
    this.shadows?.destroy();
    this.device.destroy();
  }
}
