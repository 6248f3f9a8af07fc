// {{name}}: a look made with Chiaro {{version}}, for WebGLRenderer of three.js.

import { LookMaterial as Base } from "./webgl.js";
import { look } from "./{{stem}}.js";

export { fit } from "./scene.js";
export { look };

/** The look as a material: `new {{class}}Material({ parameters: { ... } })`. */
export class {{class}}Material extends Base {
  constructor(options) {
    super(look, new URL("./", import.meta.url), options);
  }
}
