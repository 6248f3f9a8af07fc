// Measures how soon pages of `chiaro export --to web` show their first frame in Chromium: from the
// beginning of loading until the graphics driver has drawn.
//
//     node benches/browser/first_frame.mjs NAME=FOLDER... [--api webgl2] [--rounds N]
//         [--chromium PROGRAM]
//
// Folders are exported pages, measured in turns, each time in a browser that has just started. The
// page is 1280 by 720 pixels. Prints a Markdown table: the median and the range in milliseconds of
// the first frame, and of the first fine one, which follows where software draws.
//
// Needs Node 20 and Chromium. Everything is drawn by SwiftShader, Chromium's driver in software.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { loadavg, tmpdir } from 'node:os';
import { basename, extname, join } from 'node:path';
import { parseArgs } from 'node:util';

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    api: { type: 'string', default: 'webgl2' },
    rounds: { type: 'string', default: '9' },
    chromium: { type: 'string', default: 'chromium' },
  },
});
const pages = positionals.map((argument) => {
  const [name, folder] = argument.split('=');
  return { name, folder, rounds: [] };
});
if (pages.length === 0 || pages.some(({ folder }) => !folder)) {
  console.error('nothing to measure: name folders of pages, as before=FOLDER now=FOLDER');
  process.exit(2);
}

// Longest time of a page, in milliseconds.
const PATIENCE = 60000;

/** Runs in the page: tells when the first frame is drawn, and when one of full size is. */
async function tell() {
  const player = await chiaro.ready;
  const nextDrawn = () => new Promise((then) => player.addEventListener('drawn', then));
  const isFine = () => player.canvas.width === player.pageSize[0];
  if (!player.drawn) await nextDrawn();
  await player.executor.finished();
  const first = performance.now();
  while (!isFine()) await nextDrawn();
  await player.executor.finished();
  const times = { first, fine: performance.now(), api: player.api };
  await fetch('/measured', { method: 'POST', body: JSON.stringify(times) });
}

const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css' };

let folder;
let measured;

/** Answers the page's requests: its own files, with the script above, and what it measured. */
async function answer(request, response) {
  const name = basename(new URL(request.url, 'http://page').pathname) || 'index.html';
  if (name === 'measured') {
    let text = '';
    for await (const part of request) text += part;
    response.end();
    measured(JSON.parse(text));
    return;
  }
  const type = TYPES[extname(name)];
  if (!type) {
    response.writeHead(404).end();
    return;
  }
  const text = readFileSync(join(folder, name), 'utf8');
  const told = name === 'index.html' ? `<script>(${tell})()</script>` : '';
  response.writeHead(200, { 'Content-Type': `${type}; charset=utf-8` }).end(text + told);
}

/** What the page in `folder` measures in a browser of its own. */
async function measure(address) {
  const profile = mkdtempSync(join(tmpdir(), 'chiaro-browser-'));
  const found = new Promise((then) => (measured = then));
  const flags = [
    '--headless=new',
    '--no-sandbox',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--disable-quic',
    '--disable-gpu-shader-disk-cache',
    '--enable-unsafe-webgpu',
    '--use-webgpu-adapter=swiftshader',
    '--use-angle=swiftshader',
    '--use-vulkan=swiftshader',
    '--enable-features=Vulkan',
    '--enable-unsafe-swiftshader',
    '--window-size=1280,720',
    `--user-data-dir=${profile}`,
  ];
  const browser = spawn(options.chromium, [...flags, address], { stdio: 'ignore' });
  const ended = once(browser, 'exit');
  let clock;
  const late = new Promise((_, fail) => {
    clock = setTimeout(() => fail(new Error(`${folder}: nothing is drawn`)), PATIENCE);
  });
  try {
    return await Promise.race([found, late]);
  } finally {
    clearTimeout(clock);
    browser.kill();
    await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}

/** Median and range of numbers, in whole milliseconds. */
function spread(numbers) {
  const sorted = numbers.toSorted((a, b) => a - b).map(Math.round);
  return `${sorted[sorted.length >> 1]} (${sorted[0]} to ${sorted.at(-1)})`;
}

const server = createServer((request, response) => void answer(request, response));
await new Promise((then) => server.listen(0, '127.0.0.1', then));
const address = `http://127.0.0.1:${server.address().port}/?api=${options.api}`;
for (let round = 0; round < Number(options.rounds); round++) {
  for (const page of pages) {
    folder = page.folder;
    page.rounds.push(await measure(address));
  }
}
server.close();
console.log('| page | API | first frame, ms | first fine frame, ms |');
console.log('| --- | --- | ---: | ---: |');
for (const { name, rounds } of pages) {
  const [first, fine] = ['first', 'fine'].map((what) => spread(rounds.map((one) => one[what])));
  console.log(`| ${name} | ${rounds[0].api} | ${first} | ${fine} |`);
}
const load = loadavg()[0].toFixed(1);
console.log(`\n${options.rounds} rounds; load of the machine at the end: ${load}`);
