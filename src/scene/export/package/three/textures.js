// The images of a look as textures of three.js. `THREE` is the build that the renderer comes from.

import { readLayers } from "./ktx2.js";

/** Wrapping and filter of a texture; rows as they lie in the file, one level. */
function configure(THREE, texture, image, look) {
  const wrapping = {
    repeat: THREE.RepeatWrapping,
    mirror: THREE.MirroredRepeatWrapping,
    clamp: THREE.ClampToEdgeWrapping,
  };
  texture.wrapS = texture.wrapT = wrapping[image.wrap] ?? THREE.ClampToEdgeWrapping;
  const isNearest = image.filter === "nearest";
  texture.magFilter = isNearest ? THREE.NearestFilter : THREE.LinearFilter;
  // WebGPURenderer makes no sampler where both filters are plainly the nearest. There is one level.
  texture.minFilter = isNearest ? THREE.NearestMipmapNearestFilter : THREE.LinearFilter;
  texture.flipY = false;
  texture.generateMipmaps = false;
  texture.anisotropy = 1;
  texture.premultiplyAlpha = false;
  const isDecoded = image.encoding === "color" && look.colorSpace === "linear";
  texture.colorSpace = isDecoded ? THREE.SRGBColorSpace : THREE.NoColorSpace;
  return texture;
}

/** One white texel, until an image is there, with a filter for which there is a sampler. */
export function blank(THREE, isArray) {
  const white = new Uint8Array([255, 255, 255, 255]);
  const texture = isArray
    ? new THREE.DataArrayTexture(white, 1, 1, 1) : new THREE.DataTexture(white, 1, 1);
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The answer of a server that has the file. */
async function fetched(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return response;
}

async function readArray(THREE, url) {
  const response = await fetched(url);
  const found = readLayers(await response.arrayBuffer(), url.href);
  const { width, height, layers, isBlocks, bytes } = found;
  if (!isBlocks) return new THREE.DataArrayTexture(bytes, width, height, layers);
  const level = { data: bytes, width, height };
  return new THREE.CompressedArrayTexture([level], width, height, layers, THREE.RGBA_BPTC_Format);
}

async function readFlat(THREE, url) {
  const response = await fetched(url);
  const settings = {
    imageOrientation: "none", premultiplyAlpha: "none", colorSpaceConversion: "none",
  };
  const bitmap = createImageBitmap(await response.blob(), settings);
  return new THREE.Texture(await bitmap.catch(() => {
    throw new Error(`${url} is no image that the browser can read`);
  }));
}

/**
 * The textures of a look, an entry for each of its images: `texture` is white until `ready`.
 * `files` has the addresses of the files by their names.
 */
export function loadImages(THREE, look, files) {
  return look.images.map((image) => {
    const entry = { texture: blank(THREE, image.kind === "hcbtf"), ready: Promise.resolve() };
    if (!image.file) return entry;
    const url = files[image.file];
    const read = image.kind === "hcbtf" ? readArray : readFlat;
    entry.ready = read(THREE, url).then((texture) => {
      entry.texture = configure(THREE, texture, image, look);
      texture.needsUpdate = true;
    });
    // Whoever waits for `ready` has the error; whoever does not sees it in the console.
    entry.ready.catch((error) => console.error(`Chiaro: ${look.name}: ${error.message}`));
    return entry;
  });
}
