// Measures exported modules in Chromium: their sizes, and how long the browser takes to compile
// them.
//
//     node benches/browser/measure.mjs NAME=FOLDER... [WORD...] [--rounds N] [--chromium PROGRAM]
//
// Folders are those of benches/driver/modules, in turns measured and compared with the first; words
// choose the modules whose names have one of them. Prints Markdown tables: bytes and lines of code
// of WGSL and of the fragment stage in GLSL ES 3.00, raw and by gzip, and compile times of WebGPU
// and WebGL2, as docs/performance.md has them.
//
// Needs Node 20 and Chromium 121 or newer, which are found or named and never installed, and Linux
// for CPU times. Everything is drawn by SwiftShader, Chromium's own driver in software.

import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    rounds: { type: 'string', default: '7' },
    chromium: { type: 'string', default: 'chromium' },
  },
});
const folders = positionals
  .filter((argument) => argument.includes('='))
  .map((argument) => ({
    name: argument.slice(0, argument.indexOf('=')),
    path: argument.slice(argument.indexOf('=') + 1),
  }));
const words = positionals.filter((argument) => !argument.includes('='));
if (folders.length === 0) {
  console.error('nothing to compare: name folders of modules, as before=FOLDER now=FOLDER');
  process.exit(2);
}

/** Text of a file, or null where there is none. */
const textOf = (path) => (existsSync(path) ? readFileSync(path, 'utf8') : null);

/** The modules of a look in each folder that has it: [{ folder, wgsl, vertex, fragment }]. */
function variantsOf(look) {
  return folders
    .map(({ name, path }) => ({
      folder: name,
      wgsl: textOf(join(path, `${look}.wgsl`)),
      vertex: textOf(join(path, `${look}.es300.vert`)),
      fragment: textOf(join(path, `${look}.es300.frag`)),
    }))
    .filter((variant) => variant.wgsl !== null);
}

// Passes before a look have a second word: `NAME.curvature.wgsl`.
const looks = readdirSync(folders[0].path)
  .filter((file) => /^[^.]+\.wgsl$/.test(file))
  .map((file) => file.slice(0, -'.wgsl'.length))
  .filter((look) => words.length === 0 || words.some((word) => look.includes(word)))
  .sort()
  .map((look) => ({ look, variants: variantsOf(look) }));

/** Cells of a table: bytes, bytes by gzip, lines that hold more than a comment. */
function sizeCells(text) {
  if (text === null) return ['-', '-', '-'];
  const isCode = (line) => line.trim() !== '' && !line.trim().startsWith('//');
  const bytes = Buffer.byteLength(text);
  return [bytes, gzipSync(text, { level: 9 }).length, text.split('\n').filter(isCode).length];
}

function printSizes() {
  console.log('| look | modules | WGSL, bytes | gzip | lines | GLSL ES, bytes | gzip | lines |');
  console.log('| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |');
  for (const { look, variants } of looks) {
    for (const { folder, wgsl, fragment } of variants) {
      const cells = [look, folder, ...sizeCells(wgsl), ...sizeCells(fragment)];
      console.log(`| ${cells.join(' | ')} |`);
    }
  }
}

function median(numbers) {
  const sorted = numbers.toSorted((a, b) => a - b);
  const last = sorted.length - 1;
  return 0.5 * (sorted[Math.floor(last / 2)] + sorted[Math.ceil(last / 2)]);
}

/** Rows of a table of one API; `times` are the page's: { look, folder, wall, cpu } in ms. */
function printTimes(api, times) {
  console.log(`\n| ${api} | modules | wall, ms | of the first | CPU, ms | of the first |`);
  console.log('| --- | --- | ---: | ---: | ---: | ---: |');
  for (const { look, variants } of looks) {
    const of = (folder, what) =>
      times
        .filter((time) => time.look === look && time.folder === folder)
        .map((time) => time[what]);
    for (const { folder } of variants) {
      const cells = ['wall', 'cpu'].flatMap((what) => {
        const own = of(folder, what);
        if (own.length === 0) return ['-', '-'];
        // Rounds are compared one by one, since a machine's speed drifts.
        const first = of(variants[0].folder, what);
        const ratio = median(own.map((time, round) => time / first[round]));
        return [median(own).toFixed(1), ratio.toFixed(2)];
      });
      console.log(`| ${[look, folder, ...cells].join(' | ')} |`);
    }
  }
}

/** Id of the browser's process that compiles and draws. */
function gpuProcess() {
  const isIt = (id) => {
    const command = textOf(`/proc/${id}/cmdline`) ?? '';
    return command.includes('--type=gpu-process') && command.includes(profile);
  };
  return readdirSync('/proc').find((id) => /^\d+$/.test(id) && isIt(id));
}

/** CPU time of all threads of that process so far, in ms; NaN where the system does not tell. */
function cpuTime() {
  if (!existsSync('/proc/self/schedstat')) return NaN;
  gpuId ??= gpuProcess();
  const threads = `/proc/${gpuId}/task`;
  const ofThread = (thread) => {
    const text = textOf(join(threads, thread, 'schedstat')) ?? '0';
    return Number(text.split(' ')[0]);
  };
  return readdirSync(threads).reduce((sum, thread) => sum + ofThread(thread), 0) * 1e-6;
}

/** Answers the page's requests: its files, what to measure, CPU times, what was measured. */
async function answer(request, response) {
  const isolated = {
    'Cross-Origin-Opener-Policy': 'same-origin',
    'Cross-Origin-Embedder-Policy': 'require-corp',
  };
  const send = (type, text) => {
    // Pages apart from all others get a clock of 5 microseconds.
    response.writeHead(200, { 'Content-Type': type, ...isolated });
    response.end(text);
  };
  const file = (name) => readFileSync(new URL(name, import.meta.url), 'utf8');
  switch (request.url) {
    case '/':
      return send('text/html', '<!doctype html><script type="module" src="page.js"></script>');
    case '/page.js':
      return send('text/javascript', file('page.js'));
    case '/looks':
      return send('application/json', JSON.stringify({ looks, rounds: Number(options.rounds) }));
    case '/cpu':
      return send('application/json', JSON.stringify(cpuTime()));
    case '/measured': {
      let text = '';
      for await (const part of request) text += part;
      send('text/plain', '');
      return finish(JSON.parse(text));
    }
    default:
      response.writeHead(404);
      return response.end();
  }
}

/** Prints what the page measured, and ends. */
function finish({ agent, adapter, webgpu, webgl, problems }) {
  console.log(`\n${agent}\n${adapter}\n${options.rounds} rounds`);
  printTimes('WebGPU', webgpu);
  printTimes('WebGL2', webgl);
  problems.forEach((problem) => console.error(problem));
  process.exitCode = problems.length === 0 ? 0 : 1;
  server.close();
  server.closeAllConnections();
  browser.kill();
}

printSizes();
let gpuId;
const profile = mkdtempSync(join(tmpdir(), 'chiaro-browser-'));
const server = createServer((request, response) => void answer(request, response));
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const browser = spawn(
  options.chromium,
  [
    '--headless',
    '--no-sandbox',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--disable-quic',
    '--disable-gpu-shader-disk-cache',
    '--disable-gpu-watchdog',
    '--enable-unsafe-webgpu',
    '--use-webgpu-adapter=swiftshader',
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    `--user-data-dir=${profile}`,
    `http://127.0.0.1:${server.address().port}/`,
  ],
  { stdio: 'ignore' },
);
browser.on('error', (error) => {
  console.error(`${options.chromium}: ${error.message}; --chromium names the program`);
  process.exit(2);
});
browser.on('exit', () => {
  server.close();
  server.closeAllConnections();
  rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
});
