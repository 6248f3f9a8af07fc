// The page of measure.mjs: compiles every module in turns and draws a picture of 16x16 pixels with
// each. Compilation is that of the pipeline and of its first picture, less a second picture:
// drivers in software compile only where something is drawn. A factor that differs each time stands
// in every module, so that no cache knows it.

const SIZE = 16;
// A triangle over the whole picture, for all attributes alike.
const CORNERS = new Float32Array([-1, -1, 0.5, 1, 3, -1, 0.5, 1, -1, 3, 0.5, 1]);
// Matrices of 1, for all uniforms alike.
const UNITS = Float32Array.from({ length: 4096 }, (_, at) => ((at % 16) % 5 === 0 ? 1 : 0));

const problems = [];

/** Wall time of `work` in ms, and CPU time of the process that compiles. */
async function timed(work) {
  const cpu = async () => (await fetch('/cpu')).json();
  const before = await cpu();
  const start = performance.now();
  const result = await work();
  const wall = performance.now() - start;
  return { wall, cpu: (await cpu()) - before, result };
}

/** Times of a compilation from those of a pipeline and of two pictures. */
const compileTime = (made, first, second) => ({
  wall: made.wall + first.wall - second.wall,
  cpu: made.cpu + first.cpu - second.cpu,
});

/** The WGSL module with a factor of its own on the picture's color. */
function variedWgsl(text, number) {
  const at = text.lastIndexOf('return ');
  const end = text.indexOf(';', at);
  const factor = `(1.0 + ${number}e-6) * (${text.slice(at + 'return '.length, end)})`;
  return `${text.slice(0, at)}return ${factor}${text.slice(end)}`;
}

/** The GLSL fragment stage with a factor of its own on the picture's color. */
const variedGlsl = (text, number) =>
  text.replace(/(out_color = )([^;]*);/, `$1(1.0 + ${number}e-6) * ($2);`);

/** Measures modules on WebGPU. */
class WebGpu {
  constructor(device) {
    this.device = device;
    const target = (format) =>
      device
        .createTexture({ size: [SIZE, SIZE], format, usage: GPUTextureUsage.RENDER_ATTACHMENT })
        .createView();
    this.color = target('rgba8unorm');
    this.depth = target('depth32float');
    this.corners = this.buffer(CORNERS, GPUBufferUsage.VERTEX);
    this.units = this.buffer(UNITS, GPUBufferUsage.UNIFORM);
    this.sampler = device.createSampler();
  }

  static async open() {
    const adapter = await navigator.gpu?.requestAdapter();
    if (!adapter) throw new Error('WebGPU: no adapter');
    const { vendor, architecture, description } = adapter.info;
    const device = await adapter.requestDevice();
    device.addEventListener('uncapturederror', (event) => problems.push(event.error.message));
    return { measure: new WebGpu(device), name: `${vendor} ${architecture} ${description}`.trim() };
  }

  buffer(numbers, usage) {
    const size = numbers.byteLength;
    const buffer = this.device.createBuffer({ size, usage: usage | GPUBufferUsage.COPY_DST });
    this.device.queue.writeBuffer(buffer, 0, numbers);
    return buffer;
  }

  async pipeline(code) {
    const module = this.device.createShaderModule({ code });
    const [vertex] = /struct Vertex \{[^}]*\}|fn vs_main\(.*\)/.exec(code);
    const locations = [...vertex.matchAll(/@location\((\d+)\)/g)].map((match) => Number(match[1]));
    this.slots = locations.length;
    return this.device.createRenderPipelineAsync({
      layout: 'auto',
      vertex: {
        module,
        buffers: locations.map((shaderLocation) => ({
          arrayStride: 16,
          attributes: [{ format: 'float32x4', offset: 0, shaderLocation }],
        })),
      },
      fragment: {
        module,
        targets: [
          {
            format: 'rgba8unorm',
            blend: {
              color: { srcFactor: 'src-alpha', dstFactor: 'one-minus-src-alpha' },
              alpha: { srcFactor: 'one', dstFactor: 'one-minus-src-alpha' },
            },
          },
        ],
      },
      depthStencil: { format: 'depth32float', depthWriteEnabled: true, depthCompare: 'less' },
    });
  }

  /** Resources that a module reads: matrices of 1 and empty textures. */
  bindGroup(code, pipeline) {
    const bindings = code.matchAll(/@binding\((\d+)\) var(<uniform>)? \w+: (\w+)/g);
    const resource = (isUniform, type) => {
      if (isUniform) return { buffer: this.units };
      if (type === 'sampler') return this.sampler;
      const usage = GPUTextureUsage.TEXTURE_BINDING;
      const texture = this.device.createTexture({ size: [1, 1], format: 'rgba8unorm', usage });
      return texture.createView({ dimension: type.endsWith('array') ? '2d-array' : '2d' });
    };
    const entries = [...bindings].map(([, binding, isUniform, type]) => ({
      binding: Number(binding),
      resource: resource(isUniform, type),
    }));
    return this.device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries });
  }

  async draw(pipeline, group) {
    const encoder = this.device.createCommandEncoder();
    const pass = encoder.beginRenderPass({
      colorAttachments: [{ view: this.color, loadOp: 'clear', storeOp: 'store' }],
      depthStencilAttachment: {
        view: this.depth,
        depthClearValue: 1,
        depthLoadOp: 'clear',
        depthStoreOp: 'discard',
      },
    });
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, group);
    for (let slot = 0; slot < this.slots; slot++) pass.setVertexBuffer(slot, this.corners);
    pass.draw(3);
    pass.end();
    this.device.queue.submit([encoder.finish()]);
    await this.device.queue.onSubmittedWorkDone();
  }

  async compile({ wgsl }, number) {
    const code = variedWgsl(wgsl, number);
    const made = await timed(() => this.pipeline(code));
    const group = this.bindGroup(code, made.result);
    const first = await timed(() => this.draw(made.result, group));
    const second = await timed(() => this.draw(made.result, group));
    return compileTime(made, first, second);
  }
}

/** Measures modules on WebGL2. */
class WebGl {
  constructor(gl) {
    this.gl = gl;
    gl.viewport(0, 0, SIZE, SIZE);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(
      gl.SRC_ALPHA,
      gl.ONE_MINUS_SRC_ALPHA,
      gl.ONE,
      gl.ONE_MINUS_SRC_ALPHA,
    );
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, CORNERS, gl.STATIC_DRAW);
    this.units = gl.createBuffer();
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.units);
    gl.bufferData(gl.UNIFORM_BUFFER, UNITS, gl.STATIC_DRAW);
  }

  static open() {
    const canvas = new OffscreenCanvas(SIZE, SIZE);
    const gl = canvas.getContext('webgl2', { antialias: false });
    if (!gl) throw new Error('WebGL2: no context');
    const info = gl.getExtension('WEBGL_debug_renderer_info');
    return { measure: new WebGl(gl), name: gl.getParameter(info.UNMASKED_RENDERER_WEBGL) };
  }

  program(vertex, fragment) {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [type, text] of [
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    // Asking for the result waits for it.
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      const logs = gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader));
      problems.push([gl.getProgramInfoLog(program), ...logs].join('\n'));
    }
    return program;
  }

  /** Binds resources that a program reads: matrices of 1 and empty textures. */
  bind(program) {
    const { gl } = this;
    gl.useProgram(program);
    const count = (what) => gl.getProgramParameter(program, what);
    for (let block = 0; block < count(gl.ACTIVE_UNIFORM_BLOCKS); block++) {
      gl.uniformBlockBinding(program, block, block);
      gl.bindBufferBase(gl.UNIFORM_BUFFER, block, this.units);
    }
    for (let at = 0; at < count(gl.ACTIVE_UNIFORMS); at++) {
      const { name, type } = gl.getActiveUniform(program, at);
      const location = gl.getUniformLocation(program, name);
      if (location === null) continue; // It lies in a block.
      const isArray = type === gl.SAMPLER_2D_ARRAY;
      if (!isArray && type !== gl.SAMPLER_2D) continue;
      const target = isArray ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
      gl.activeTexture(gl.TEXTURE0 + at);
      gl.bindTexture(target, gl.createTexture());
      if (isArray) gl.texStorage3D(target, 1, gl.RGBA8, 1, 1, 1);
      else gl.texStorage2D(target, 1, gl.RGBA8, 1, 1);
      gl.uniform1i(location, at);
    }
    gl.bindVertexArray(gl.createVertexArray());
    for (let at = 0; at < count(gl.ACTIVE_ATTRIBUTES); at++) {
      const location = gl.getAttribLocation(program, gl.getActiveAttrib(program, at).name);
      if (location < 0) continue; // A built-in value, such as gl_VertexID.
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 4, gl.FLOAT, false, 16, 0);
    }
  }

  draw() {
    const { gl } = this;
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    // Reading a pixel waits for the picture.
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  async compile({ vertex, fragment }, number) {
    const varied = variedGlsl(fragment, number);
    const made = await timed(() => this.program(vertex, varied));
    this.bind(made.result);
    const first = await timed(() => this.draw());
    const second = await timed(() => this.draw());
    const error = this.gl.getError();
    if (error !== 0) problems.push(`WebGL2: error ${error}`);
    this.gl.deleteProgram(made.result);
    return compileTime(made, first, second);
  }
}

/** Compiles all variants of all looks in turns; a first round fills what is made once. */
async function measured(api, looks, rounds) {
  const times = [];
  for (let round = 0; round <= rounds; round++) {
    for (const { look, variants } of looks) {
      for (const variant of variants) {
        if (variant.vertex === null && api instanceof WebGl) continue;
        const time = await api.compile(variant, round + 1);
        if (round > 0) times.push({ look, folder: variant.folder, ...time });
      }
    }
  }
  return times;
}

/** Opens an API and measures with it; what fails is a problem to report. */
async function run(open, looks, rounds) {
  try {
    const { measure, name } = await open();
    return { name, times: await measured(measure, looks, rounds) };
  } catch (error) {
    problems.push(String(error));
    return { name: '-', times: [] };
  }
}

const { looks, rounds } = await (await fetch('/looks')).json();
const webgpu = await run(WebGpu.open, looks, rounds);
const webgl = await run(WebGl.open, looks, rounds);
await fetch('/measured', {
  method: 'POST',
  body: JSON.stringify({
    agent: navigator.userAgent,
    adapter: `WebGPU: ${webgpu.name}; WebGL2: ${webgl.name}`,
    webgpu: webgpu.times,
    webgl: webgl.times,
    problems,
  }),
});
