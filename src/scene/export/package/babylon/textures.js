// The images of a look as textures of Babylon.js.

import { Constants, RawTexture, RawTexture2DArray, Texture } from "@babylonjs/core";
import { readLayers } from "./ktx2.js";

const WHITE = new Uint8Array([255, 255, 255, 255]);

/**
 * An image of the look: `texture`, and `loaded`, a promise of the texture that stays. `files` has
 * the addresses of files by their names.
 */
export function loadImage(scene, look, image, files) {
  const filter = image.filter === "nearest"
    ? Texture.NEAREST_SAMPLINGMODE : Texture.BILINEAR_SAMPLINGMODE;
  const url = image.file && files[image.file].href;
  if (image.kind === "hcbtf") {
    const texture = arrayOf(scene, { bytes: WHITE, width: 1, height: 1, layers: 1 }, filter);
    return { texture, loaded: url ? readArray(scene, url, filter) : Promise.resolve(texture) };
  }
  if (!url) {
    const texture = RawTexture.CreateRGBATexture(WHITE, 1, 1, scene, false, false, filter);
    return { texture, loaded: Promise.resolve(texture) };
  }
  return readFlat(scene, look, image, url, filter);
}

/** A flat image: rows as they lie in the file, one level, no color management. */
function readFlat(scene, look, image, url, samplingMode) {
  let texture;
  const loaded = new Promise((resolve, reject) => {
    texture = new Texture(url, scene, {
      noMipmap: true,
      invertY: false,
      samplingMode,
      useSRGBBuffer: image.encoding === "color" && look.colorSpace === "linear",
      onLoad: () => resolve(texture),
      onError: (message) => reject(new Error(`${url}: ${message}`)),
    });
  });
  const modes = { repeat: Texture.WRAP_ADDRESSMODE, mirror: Texture.MIRROR_ADDRESSMODE };
  texture.wrapU = texture.wrapV = modes[image.wrap] ?? Texture.CLAMP_ADDRESSMODE;
  texture.anisotropicFilteringLevel = 1;
  return { texture, loaded };
}

/** The layers of a painted surface. */
async function readArray(scene, url, filter) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  const found = readLayers(await response.arrayBuffer(), url);
  if (found.isBlocks) {
    throw new Error(`${url} has blocks of BC7, which Babylon.js does not take in layers: ` +
      "export the look again with --textures compact");
  }
  return arrayOf(scene, found, filter);
}

function arrayOf(scene, { bytes, width, height, layers }, filter) {
  const format = Constants.TEXTUREFORMAT_RGBA;
  return new RawTexture2DArray(bytes, width, height, layers, format, scene, false, false, filter);
}
