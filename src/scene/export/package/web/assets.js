// What lies in the package's scripts as base64: the mesh, images, and arrays of painted textures.

/** The bytes of a text in base64. */
function bytesFromBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

/** The mesh with its attributes as arrays of numbers, ready for vertex buffers. */
function readMesh(mesh) {
  const attributes = {};
  for (const [name, text] of Object.entries(mesh.attributes)) {
    attributes[name] = new Float32Array(bytesFromBase64(text).buffer);
  }
  const indices = new Uint32Array(bytesFromBase64(mesh.indices).buffer);
  return { ...mesh, attributes, indices };
}

/**
 * The images of a look: `{ bitmap }` for a flat one, and `{ width, height, layers, blocks, bytes }`
 * for an array of layers. An image whose file is missing is one white texel.
 */
async function readImages(look, textures) {
  const known = new Map();
  const read = async ({ file, kind }) => {
    const text = file && textures[file];
    if (!text) return missingImage(kind);
    return kind === "hcbtf" ? readKtx2(bytesFromBase64(text), file) : readImage(text, file);
  };
  return Promise.all(
    look.images.map((image) => {
      if (!known.has(image.file)) known.set(image.file, read(image));
      return known.get(image.file);
    }),
  );
}

function missingImage(kind) {
  const bytes = new Uint8Array([255, 255, 255, 255]);
  return { width: 1, height: 1, layers: 1, blocks: false, bytes, isFlat: kind !== "hcbtf" };
}

async function readImage(text, file) {
  const blob = new Blob([bytesFromBase64(text)]);
  // Numbers as they are in the file: no alpha multiplied in, no profile of the screen.
  const plainly = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
  try {
    const bitmap = await createImageBitmap(blob, plainly);
    return { bitmap, width: bitmap.width, height: bitmap.height, isFlat: true };
  } catch {
    throw new Error(`the image ${file} cannot be read: export the look again`);
  }
}

const KTX2_RGBA8 = 37;
const KTX2_BC7 = 145;

/** The layers of a KTX2 file with one level of RGBA8 or BC7, as Chiaro writes it. */
function readKtx2(bytes, file) {
  const words = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const word = (at) => words.getUint32(at, true);
  const format = bytes.length > 104 && word(0) === 0x58544bab ? word(12) : 0;
  if (format !== KTX2_RGBA8 && format !== KTX2_BC7) {
    throw new Error(`the texture ${file} cannot be read: export the look again`);
  }
  const [width, height, layers] = [word(20), word(24), Math.max(word(32), 1)];
  const long = (at) => Number(words.getBigUint64(at, true));
  const [start, size] = [long(80), long(88)];
  const content = bytes.subarray(start, start + size);
  return { width, height, layers, blocks: format === KTX2_BC7, bytes: content, isFlat: false };
}
