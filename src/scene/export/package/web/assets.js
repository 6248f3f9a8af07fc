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
 * The images of a look: `{ bitmap }` for a flat one, and for an array of layers what `readLayers`
 * gives. An image whose file is missing is one white texel.
 */
async function readImages(look, textures) {
  const known = new Map();
  const read = async ({ file, kind }) => {
    const text = file && textures[file];
    if (!text) return missingImage(kind);
    if (kind === "hcbtf") return readLayers(bytesFromBase64(text).buffer, file);
    return readImage(text, file);
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
  return { width: 1, height: 1, layers: 1, isBlocks: false, bytes, isFlat: kind !== "hcbtf" };
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
