// What both materials of a look have: its parameters, lights, images and sides.

import { followLights, hasPlace, sideOf } from "./scene.js";
import { loadImages } from "./textures.js";
import { LookValues } from "./values.js";

/** The images of looks, loaded once for each build of three.js. */
const imagesOf = new WeakMap();

function imagesFor(THREE, look, files) {
  if (!imagesOf.has(THREE)) imagesOf.set(THREE, new Map());
  const known = imagesOf.get(THREE);
  if (!known.has(look)) known.set(look, loadImages(THREE, look, files));
  return known.get(look);
}

/** Properties of the picture's material, from its pass and the program's own wishes. */
export function optionsOf(THREE, look, pass, options) {
  return {
    name: look.name,
    side: pass.sides === "both" ? THREE.DoubleSide : THREE.FrontSide,
    transparent: look.opaque !== true,
    // Drawn twice, a material would have its sides exchanged.
    forceSinglePass: true,
    toneMapped: false,
    ...options,
  };
}

/** Materials that use something, which is freed with the last one that is disposed of. */
export class Users {
  constructor(free) {
    this.free = free;
    this.known = new WeakSet();
    this.count = 0;
  }

  add(material) {
    if (this.known.has(material)) return;
    this.known.add(material);
    this.count++;
    const end = () => {
      material.removeEventListener("dispose", end);
      this.known.delete(material);
      this.count--;
      if (this.count === 0) this.free();
    };
    material.addEventListener("dispose", end);
  }
}

/** A class of materials with the values of a look. */
export const withLook = (Base, THREE) =>
  class extends Base {
    /** Takes the look; `files` has the addresses of its images by their names. */
    begin(look, files, parameters) {
      this.look = look;
      this.ownSide = this.side;
      this.values = new LookValues(look);
      this.parameters = this.values.parameters;
      this.lights = this.values.lights;
      /** What is written: `auto` fits the renderer, `none` leaves the look's own numbers. */
      this.encoding = "auto";
      this.images = imagesFor(THREE, look, files);
      this.followed = new Map();
      this.size = new THREE.Vector2();
      Object.assign(this.parameters, parameters);
    }

    /** A promise of the look's images; until then they are white. */
    get ready() {
      return Promise.all(this.images.map(({ ready }) => ready)).then(() => this);
    }

    /** Seconds, for looks that change with time. */
    get time() {
      return this.values.time;
    }

    set time(seconds) {
      this.values.time = seconds;
    }

    /** Rotation that turns the look's lights together: a Matrix3. */
    set illumination(matrix) {
      if (matrix?.elements?.length !== 9) throw new TypeError("illumination is a Matrix3");
      this.values.illumination = Array.from(matrix.elements);
    }

    /**
     * Lets a light of three.js drive where a light of the look shines from, and its color and
     * intensity where that is asked for; `null` brings the look's own back.
     */
    follow(id, light, { color = false, intensity = false } = {}) {
      const own = this.lights[id];
      if (!own) {
        const known = Object.keys(this.lights).join(", ");
        throw new TypeError(`${this.look.name} has no light "${id}", but ${known || "none"}`);
      }
      if (light && !hasPlace(light)) {
        throw new TypeError(`a light that "${id}" can follow has a place, such as a ` +
          "DirectionalLight, PointLight or SpotLight");
      }
      if (light) this.followed.set(id, { light, color, intensity });
      else if (this.followed.delete(id)) for (const field in own) own[field] = undefined;
      return this;
    }

    /** The state of the look for `prepare`. */
    stateOf(place) {
      if (this.followed.size) {
        followLights(this.followed, this.values, this.values.state(place), this.look);
      }
      return this.values.state(place);
    }

    /** Size of the picture that is drawn, in pixels. */
    pictureSize(renderer) {
      const target = renderer.getRenderTarget();
      if (target) this.size.set(target.width, target.height);
      else renderer.getDrawingBufferSize(this.size);
      return this.size.toArray();
    }

    updateSide() {
      this.side = sideOf(THREE, this);
    }

    copy(source) {
      // Shaders and uniforms are this material's own.
      THREE.Material.prototype.copy.call(this, source);
      this.values.copy(source.values);
      for (const [id, light] of source.followed) this.followed.set(id, light);
      return Object.assign(this, { ownSide: source.ownSide, encoding: source.encoding });
    }
  };
