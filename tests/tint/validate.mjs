// Validates WGSL files with Tint, the compiler in Chromium: a second opinion, independent of naga. It checks what naga
// does not, such as derivatives in non-uniform control flow.
//
//     node tests/tint/validate.mjs FILE.wgsl...     or, with no arguments, one path a line on standard input
//
// Prints a JSON array, one entry a file in the order given: {"file", "ok", "messages": [{"severity", "line", "column",
// "message"}]}. Lines and columns count from 1; severity is "error", "warning" or "info".
// Exit code: 0 no errors; 1 a file has errors or cannot be read; 2 Tint itself is missing or does not work.
//
// Tint comes from the npm package `webgpu` (Dawn for Node) in `.tools/tint`, where `scripts/setup` puts it; the
// environment variable CHIARO_TINT names another folder. Dawn's null backend needs neither a GPU nor a driver.

import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

// Kept for as long as the program runs: Dawn falls over when these are collected while a device lives.
const alive = [];

/** A device that compiles shaders and draws nothing. Optional features are on, since a module has to enable them. */
async function openDevice() {
  const folder = process.env.CHIARO_TINT ?? join(root, '.tools', 'tint');
  if (!existsSync(folder)) {
    throw new Error(`${folder} is missing: run scripts/setup`);
  }
  const entry = createRequire(join(folder, 'package.json')).resolve('webgpu');
  const { create } = await import(pathToFileURL(entry).href);
  const gpu = create(['backend=null']);
  const adapter = await gpu.requestAdapter();
  const wanted = ['shader-f16', 'subgroups', 'dual-source-blending', 'clip-distances'];
  const device = await adapter.requestDevice({ requiredFeatures: wanted.filter((name) => adapter.features.has(name)) });
  alive.push(gpu, adapter, device);
  // The messages are read from each module; without a listener Dawn would print them a second time.
  device.addEventListener('uncapturederror', (event) => event.preventDefault());
  return device;
}

/** What Tint says of one file. A file that cannot be read is an error at 0:0. */
async function validate(device, file) {
  let code;
  try {
    code = readFileSync(file, 'utf8');
  } catch (error) {
    return { file, ok: false, messages: [{ severity: 'error', line: 0, column: 0, message: error.message }] };
  }
  device.pushErrorScope('validation');
  const info = await device.createShaderModule({ code }).getCompilationInfo();
  const failure = await device.popErrorScope();
  const messages = Array.from(info.messages, ({ type, lineNum, linePos, message }) => ({
    severity: type,
    line: lineNum,
    column: linePos,
    message,
  }));
  if (failure !== null && !messages.some(({ severity }) => severity === 'error')) {
    messages.push({ severity: 'error', line: 0, column: 0, message: failure.message });
  }
  return { file, ok: !messages.some(({ severity }) => severity === 'error'), messages };
}

/** The paths to look at. */
function paths() {
  const named = process.argv.slice(2);
  return named.length > 0 ? named : readFileSync(0, 'utf8').split('\n').filter((line) => line !== '');
}

let device;
try {
  device = await openDevice();
} catch (error) {
  console.error(`Tint does not start: ${error.message}`);
  process.exit(2);
}
const reports = [];
for (const file of paths()) {
  reports.push(await validate(device, file));
}
// Written before leaving by hand: Dawn keeps the event loop alive.
process.stdout.write(`${JSON.stringify(reports, null, 2)}\n`, () => {
  process.exit(reports.every(({ ok }) => ok) ? 0 : 1);
});
