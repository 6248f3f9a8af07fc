// Drawing by WebGL 2, with the methods of `WebGpuExecutor`.
//
// Everything is drawn with its first row at the top, as WebGPU draws it, by turning y over in clip
// space; the last step shows the picture upside down. So derivatives, which graphics cards take
// once for every two by two pixels, are those of WebGPU.

const WEBGL2_SHOWING_VERTEX = `#version 300 es
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}`;

const WEBGL2_SHOWING_FRAGMENT = (isLinear) => `#version 300 es
precision highp float;
uniform highp sampler2D picture;
out vec4 color;

vec3 encode(vec3 x) {
    bvec3 isDark = lessThanEqual(x, vec3(0.0031308));
    return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, isDark);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 found = texelFetch(picture, ivec2(at.x, textureSize(picture, 0).y - 1 - at.y), 0);
    vec3 straight = clamp(found.rgb / max(found.a, 1e-6), 0.0, 1.0);
    color = vec4(${isLinear ? "encode(straight)" : "straight"} * found.a, found.a);
}`;

class WebGl2Executor {
  label = "WebGL 2";
  clip = { near: -1, far: 1, flipsRows: true };

  /** An executor that draws on `canvas`. Rejects, with the reason, where WebGL 2 is missing. */
  static async create(canvas, content) {
    const gl = canvas.getContext("webgl2", { antialias: false, depth: false, alpha: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    if (!gl.getExtension("EXT_color_buffer_float")) {
      throw new Error("this graphics card cannot draw numbers of 32 bits by WebGL 2");
    }
    const executor = new WebGl2Executor();
    Object.assign(executor, content, { canvas, gl });
    executor.compile();
    executor.uploadMesh();
    executor.uploadImages();
    return executor;
  }

  /** Name of what draws. Chromium and Safari tell it aside. */
  get driver() {
    const { gl } = this;
    const name = gl.getParameter(gl.RENDERER);
    const aside = name.startsWith("WebKit") && gl.getExtension("WEBGL_debug_renderer_info");
    return aside ? gl.getParameter(aside.UNMASKED_RENDERER_WEBGL) : name;
  }

  /** Compiles the modules, side by side where the browser can, and finds the places of inputs. */
  compile() {
    const { gl, look } = this;
    const begun = Object.entries(look.modules).map(([name, { glsl }]) =>
      [name, this.begin(glsl.vertex, glsl.fragment)]);
    const isLinear = look.colorSpace === "linear";
    const showing = this.begin(WEBGL2_SHOWING_VERTEX, WEBGL2_SHOWING_FRAGMENT(isLinear));
    this.modules = {};
    for (const [name, program] of begun) {
      this.check(program, name);
      const module = look.modules[name];
      let [blocks, units] = [0, 0];
      const bindings = module.bindings.filter(({ kind }) => kind !== "sampler").map((binding) => {
        if (binding.kind === "uniform") {
          const index = gl.getUniformBlockIndex(program, binding.glsl.name);
          // A block that no stage reads is not there.
          if (index === gl.INVALID_INDEX) return { ...binding, isUnused: true };
          gl.uniformBlockBinding(program, index, blocks);
          return { ...binding, place: blocks++ };
        }
        gl.useProgram(program);
        gl.uniform1i(gl.getUniformLocation(program, binding.glsl.name), units);
        return { ...binding, place: units++ };
      });
      this.modules[name] = { ...module, program, bindings };
    }
    this.check(showing, "show");
    this.showing = showing;
    this.buffers = new Map();
    this.nearest = this.sampler("nearest", "clamp");
    this.nothing = gl.createVertexArray();
  }

  begin(vertex, fragment) {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    return program;
  }

  check(program, name) {
    const { gl } = this;
    if (gl.getProgramParameter(program, gl.LINK_STATUS) || gl.isContextLost()) return;
    const logs = gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader));
    const said = [...logs, gl.getProgramInfoLog(program)].filter(Boolean).join("\n");
    throw new Error(`the shader ${name} does not compile: ${said}`);
  }

  uploadMesh() {
    const { gl, mesh } = this;
    this.meshBuffers = [];
    const upload = (target, array) => {
      const buffer = gl.createBuffer();
      this.meshBuffers.push(buffer);
      gl.bindBuffer(target, buffer);
      gl.bufferData(target, array, gl.STATIC_DRAW);
      return buffer;
    };
    gl.bindVertexArray(null);
    const vertices = {};
    for (const [name, array] of Object.entries(mesh.attributes)) {
      vertices[name] = upload(gl.ARRAY_BUFFER, array);
    }
    const indices = upload(gl.ELEMENT_ARRAY_BUFFER, mesh.indices);
    for (const pass of this.look.passes) {
      const module = this.modules[pass.module];
      if (pass.draws === "screen" || module.vertices) continue;
      module.vertices = gl.createVertexArray();
      gl.bindVertexArray(module.vertices);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
      for (const { name, type, location } of module.attributes) {
        gl.bindBuffer(gl.ARRAY_BUFFER, vertices[name]);
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, Number(type[3]), gl.FLOAT, false, 0, 0);
      }
    }
    gl.bindVertexArray(null);
  }

  uploadImages() {
    this.textures = this.images.map((image, index) => this.uploadImage(image, index));
    this.samplers = this.look.images.map(({ wrap, filter }) => this.sampler(filter, wrap));
  }

  sampler(filter, wrap) {
    const { gl } = this;
    const sampler = gl.createSampler();
    const mode = { repeat: gl.REPEAT, clamp: gl.CLAMP_TO_EDGE, mirror: gl.MIRRORED_REPEAT }[wrap];
    const kind = filter === "nearest" ? gl.NEAREST : gl.LINEAR;
    gl.samplerParameteri(sampler, gl.TEXTURE_MIN_FILTER, kind);
    gl.samplerParameteri(sampler, gl.TEXTURE_MAG_FILTER, kind);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_S, mode);
    gl.samplerParameteri(sampler, gl.TEXTURE_WRAP_T, mode);
    return sampler;
  }

  uploadImage(image, index) {
    const { gl } = this;
    const { width, height, layers = 1 } = image;
    const target = image.isFlat ? gl.TEXTURE_2D : gl.TEXTURE_2D_ARRAY;
    const texture = gl.createTexture();
    gl.bindTexture(target, texture);
    // The first row of the file is the first row of the texture, with its numbers as they are.
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    const flat = isDecodedBySampling(this.look, index) ? gl.SRGB8_ALPHA8 : gl.RGBA8;
    if (image.isBlocks) {
      const blocks = gl.getExtension("EXT_texture_compression_bptc");
      if (!blocks) throw new Error("this graphics card does not read textures in BC7 blocks");
      const format = blocks.COMPRESSED_RGBA_BPTC_UNORM_EXT;
      gl.compressedTexImage3D(target, 0, format, width, height, layers, 0, image.bytes);
    } else if (image.isFlat) {
      const source = image.bitmap
        ?? new ImageData(new Uint8ClampedArray(image.bytes), width, height);
      gl.texImage2D(target, 0, flat, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, source);
    } else {
      const kind = gl.UNSIGNED_BYTE;
      gl.texImage3D(target, 0, flat, width, height, layers, 0, gl.RGBA, kind, image.bytes);
    }
    gl.texParameteri(target, gl.TEXTURE_MAX_LEVEL, 0);
    return { target, texture };
  }

  /** The textures that the passes draw into, for one size. */
  targetsOf([width, height], samples) {
    const { gl } = this;
    const made = [];
    const texture = (format) => {
      const found = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, found);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
      made.push(() => gl.deleteTexture(found));
      return found;
    };
    const renderbuffer = (format, count) => {
      const found = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, found);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, count, format, width, height);
      made.push(() => gl.deleteRenderbuffer(found));
      return found;
    };
    const framebuffer = (attach) => {
      const found = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, found);
      attach();
      if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
        throw new Error("this graphics card cannot draw what the look needs by WebGL 2");
      }
      made.push(() => gl.deleteFramebuffer(found));
      return found;
    };
    const onto = (place, kind, what) => kind === gl.TEXTURE_2D
      ? gl.framebufferTexture2D(gl.FRAMEBUFFER, place, kind, what, 0)
      : gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, kind, what);
    const found = { size: [width, height], samples, images: {}, framebuffers: {} };
    const formats = { rgba32float: gl.RGBA32F, r32float: gl.R32F };
    for (const pass of this.look.passes) {
      if (pass.name === "draw" || pass.draws === "lights") continue;
      const images = pass.outputs.map(({ name, format }) => {
        const image = texture(formats[format]);
        found.images[`${pass.name}.${name}`] = { target: gl.TEXTURE_2D, texture: image };
        return image;
      });
      const depth = pass.draws === "meshes" ? renderbuffer(gl.DEPTH_COMPONENT32F, 0) : null;
      found.framebuffers[pass.name] = framebuffer(() => {
        images.forEach((image, i) => onto(gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, image));
        gl.drawBuffers(images.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        if (depth) onto(gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
      });
    }
    found.picture = texture(gl.RGBA16F);
    const depth = renderbuffer(gl.DEPTH_COMPONENT32F, samples > 1 ? samples : 0);
    const sampled = samples > 1 ? renderbuffer(gl.RGBA16F, samples) : null;
    found.framebuffers.draw = framebuffer(() => {
      if (sampled) onto(gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, sampled);
      else onto(gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, found.picture);
      onto(gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    });
    found.resolved = sampled
      ? framebuffer(() => onto(gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, found.picture))
      : found.framebuffers.draw;
    found.destroy = () => made.forEach((free) => free());
    return found;
  }

  /** Draws all passes of a frame into `targets`. */
  run(frame, targets) {
    const { gl } = this;
    const [width, height] = frame.size;
    gl.depthFunc(gl.LESS);
    gl.depthMask(true);
    // Rows run the other way, and so do corners.
    gl.frontFace(this.mesh.isMirrored ? gl.CCW : gl.CW);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    if (frame.shadows) this.runShadows(frame);
    gl.viewport(0, 0, width, height);
    for (const pass of this.look.passes) {
      if (pass.draws !== "lights") this.runPass(pass, frame, targets);
    }
    if (targets.resolved !== targets.framebuffers.draw) {
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, targets.framebuffers.draw);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, targets.resolved);
      const box = [0, 0, width, height];
      gl.blitFramebuffer(...box, ...box, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }
  }

  /** Draws what lights see, where a light has moved since it was drawn last. */
  runShadows(frame) {
    const { gl } = this;
    const { side, layers } = frame.shadows;
    const passes = this.look.passes.filter(({ draws }) => draws === "lights");
    if (this.shadows?.side !== side || this.shadows.count !== layers.length) {
      this.shadows?.destroy();
      this.shadows = this.shadowTargets(passes, side, layers.length);
    }
    const drawn = JSON.stringify(layers);
    if (drawn === this.shadows.drawn) return;
    this.shadows.drawn = drawn;
    gl.viewport(0, 0, side, side);
    this.enable(gl.BLEND, false);
    this.enable(gl.CULL_FACE, false);
    this.enable(gl.DEPTH_TEST, true);
    for (const pass of passes) {
      const module = this.modules[pass.module];
      gl.useProgram(module.program);
      gl.bindVertexArray(module.vertices);
      layers.forEach((_, layer) => {
        this.bind(pass, module, frame, this.shadows, layer);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadows.framebuffers[pass.name][layer]);
        pass.outputs.forEach(({ clear }, i) => gl.clearBufferfv(gl.COLOR, i, clear));
        gl.clearBufferfv(gl.DEPTH, 0, [1]);
        gl.drawElements(gl.TRIANGLES, this.mesh.indices.length, gl.UNSIGNED_INT, 0);
      });
    }
  }

  /** The textures of shadow maps, with a framebuffer for each layer of each pass. */
  shadowTargets(passes, side, count) {
    const { gl } = this;
    const made = [];
    const depth = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, side, side);
    made.push(() => gl.deleteRenderbuffer(depth));
    const found = { side, count, images: {}, framebuffers: {} };
    for (const pass of passes) {
      const textures = pass.outputs.map(({ name }) => {
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
        gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, gl.RGBA32F, side, side, Math.max(count, 2));
        found.images[`${pass.name}.${name}`] = { target: gl.TEXTURE_2D_ARRAY, texture };
        made.push(() => gl.deleteTexture(texture));
        return texture;
      });
      found.framebuffers[pass.name] = Array.from({ length: count }, (_, layer) => {
        const framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        textures.forEach((texture, i) =>
          gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, texture, 0, layer));
        gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        const kind = gl.RENDERBUFFER;
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, kind, depth);
        made.push(() => gl.deleteFramebuffer(framebuffer));
        return framebuffer;
      });
    }
    found.destroy = () => made.forEach((free) => free());
    return found;
  }

  runPass(pass, frame, targets) {
    const { gl } = this;
    const isPicture = pass.name === "draw";
    gl.bindFramebuffer(gl.FRAMEBUFFER, targets.framebuffers[pass.name]);
    this.enable(gl.BLEND, isPicture);
    this.enable(gl.DEPTH_TEST, pass.draws === "meshes");
    pass.outputs.forEach(({ clear }, i) => gl.clearBufferfv(gl.COLOR, i, clear));
    if (pass.draws === "meshes") gl.clearBufferfv(gl.DEPTH, 0, [1]);
    const module = this.modules[pass.module];
    gl.useProgram(module.program);
    if (pass.draws === "screen") {
      this.enable(gl.CULL_FACE, false);
      this.bind(pass, module, frame, targets, 0);
      gl.bindVertexArray(this.nothing);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      return;
    }
    gl.bindVertexArray(module.vertices);
    this.mesh.parts.forEach((part, number) => {
      this.enable(gl.CULL_FACE, !frame.drawsBoth(pass, part));
      this.bind(pass, module, frame, targets, number);
      gl.drawElements(gl.TRIANGLES, part.count, gl.UNSIGNED_INT, 4 * part.first);
    });
  }

  enable(what, isOn) {
    if (isOn) this.gl.enable(what);
    else this.gl.disable(what);
  }

  bind(pass, module, frame, targets, part) {
    const { gl } = this;
    for (const binding of module.bindings) {
      const { kind, feed, place } = binding;
      if (binding.isUnused) continue;
      if (kind === "uniform") {
        const buffer = this.buffer(`${pass.module} ${binding.name} ${part}`);
        gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
        const bytes = frame.bytes(pass.module, binding, part);
        gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.DYNAMIC_DRAW);
        gl.bindBufferBase(gl.UNIFORM_BUFFER, place, buffer);
        continue;
      }
      const isImage = feed.from === "image";
      const key = sourceOf(pass, binding);
      const source = isImage
        ? this.textures[feed.image]
        : (targets.images[key] ?? this.shadows.images[key]);
      gl.activeTexture(gl.TEXTURE0 + place);
      gl.bindTexture(source.target, source.texture);
      gl.bindSampler(place, isImage ? this.samplers[feed.image] : this.nearest);
    }
  }

  buffer(key) {
    let found = this.buffers.get(key);
    if (!found) {
      found = this.gl.createBuffer();
      this.buffers.set(key, found);
    }
    return found;
  }

  /** Draws a frame on the page. */
  show(frame) {
    const { gl } = this;
    const [width, height] = frame.size;
    const is = this.targets;
    if (!is || is.size[0] !== width || is.size[1] !== height || is.samples !== frame.samples) {
      is?.destroy();
      this.targets = this.targetsOf(frame.size, frame.samples);
    }
    this.run(frame, this.targets);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    [gl.BLEND, gl.DEPTH_TEST, gl.CULL_FACE].forEach((what) => gl.disable(what));
    gl.useProgram(this.showing);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.targets.picture);
    gl.bindSampler(0, this.nearest);
    gl.bindVertexArray(this.nothing);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** The numbers of a frame drawn beside the page: premultiplied RGBA, the top row first. */
  async read(frame) {
    const { gl } = this;
    const [width, height] = frame.size;
    const targets = this.targetsOf(frame.size, frame.samples);
    this.run(frame, targets);
    gl.bindFramebuffer(gl.FRAMEBUFFER, targets.resolved);
    const numbers = new Float32Array(4 * width * height);
    // By way of a buffer, so that the page need not wait for the graphics card.
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, numbers.byteLength, gl.STREAM_READ);
    // Row 0 is the top one here.
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (gl.clientWaitSync(drawn, 0, 0) === gl.TIMEOUT_EXPIRED) {
      await new Promise((resolve) => setTimeout(resolve, 4));
    }
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, numbers);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.deleteSync(drawn);
    gl.deleteBuffer(buffer);
    targets.destroy();
    return numbers;
  }

  /** Calls `then` with the reason when the graphics card is lost, once. */
  onLost(then) {
    const lost = () => this.isClosed || then("the browser took the graphics card away");
    this.canvas.addEventListener("webglcontextlost", lost, { once: true });
  }

  /** Resolves when everything is drawn that was asked for. */
  async finished() {
    const { gl } = this;
    const drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (!this.isClosed && gl.clientWaitSync(drawn, 0, 0) === gl.TIMEOUT_EXPIRED) {
      await new Promise((resolve) => setTimeout(resolve, 2));
    }
    gl.deleteSync(drawn);
  }

  /** Draws another mesh with the same attributes from now on. */
  replaceMesh(mesh) {
    for (const module of Object.values(this.modules)) {
      if (module.vertices) this.gl.deleteVertexArray(module.vertices);
      module.vertices = null;
    }
    this.meshBuffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
    this.mesh = mesh;
    this.uploadMesh();
    this.shadows?.destroy();
    this.shadows = null;
  }

  destroy() {
    this.isClosed = true;
    this.targets?.destroy();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
