// Painted textures: arrays of layers in KTX2 files.

const RGBA8 = 37;
const BC7 = 145;

/** The layers of a KTX2 file with one level of RGBA8 or BC7, as Chiaro writes it. */
export function readLayers(buffer, name) {
  const words = new DataView(buffer);
  const word = (at) => words.getUint32(at, true);
  const format = buffer.byteLength > 104 && word(0) === 0x58544bab ? word(12) : 0;
  if (format !== RGBA8 && format !== BC7) {
    throw new Error(`${name} is no texture of Chiaro: export the look again`);
  }
  const [width, height, layers] = [word(20), word(24), Math.max(word(32), 1)];
  const [start, size] = [80, 88].map((at) => Number(words.getBigUint64(at, true)));
  const bytes = new Uint8Array(buffer, start, size);
  return { width, height, layers, isBlocks: format === BC7, bytes };
}
