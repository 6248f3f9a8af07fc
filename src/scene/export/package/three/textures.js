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
  texture.magFilter = texture.minFilter =
    image.filter === "nearest" ? THREE.NearestFilter : THREE.LinearFilter;
  texture.flipY = false;
  texture.generateMipmaps = false;
  texture.anisotropy = 1;
  texture.premultiplyAlpha = false;
  const isDecoded = image.encoding === "color" && look.colorSpace === "linear";
  texture.colorSpace = isDecoded ? THREE.SRGBColorSpace : THREE.NoColorSpace;
  return texture;
}

/** One white texel, until an image is there. */
function blank(THREE, isArray) {
  const white = new Uint8Array([255, 255, 255, 255]);
  const texture = isArray
    ? new THREE.DataArrayTexture(white, 1, 1, 1) : new THREE.DataTexture(white, 1, 1);
  texture.needsUpdate = true;
  return texture;
}

async function readArray(THREE, url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  const found = readLayers(await response.arrayBuffer(), url.href);
  const { width, height, layers, isBlocks, bytes } = found;
  if (!isBlocks) return new THREE.DataArrayTexture(bytes, width, height, layers);
  const level = { data: bytes, width, height };
  return new THREE.CompressedArrayTexture([level], width, height, layers, THREE.RGBA_BPTC_Format);
}

async function readFlat(THREE, url) {
  const loader = new THREE.ImageBitmapLoader();
  const imageOrientation = "none";
  loader.setOptions({ imageOrientation, premultiplyAlpha: "none", colorSpaceConversion: "none" });
  return new THREE.Texture(await loader.loadAsync(url.href));
}

/**
 * The textures of a look, an entry for each of its images: `texture` is white until `ready`.
 * `base` is the address of the folder with the files.
 */
export function loadImages(THREE, look, base) {
  return look.images.map((image) => {
    const entry = { texture: blank(THREE, image.kind === "hcbtf"), ready: Promise.resolve() };
    if (!image.file) return entry;
    const url = new URL(encodeURIComponent(image.file), base);
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
