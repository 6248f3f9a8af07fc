// {{name}}: a look made with Chiaro {{version}}, for WebGLRenderer of three.js.

import { LookMaterial as Base } from "./webgl.js";
import { look } from "./{{stem}}.js";

export { fit, fitAll } from "./scene.js";
export { look };

{{files}}
/** The look as a material: `new {{class}}Material({ parameters: { ... } })`. */
export class {{class}}Material extends Base {
  constructor(options) {
    super(look, files, options);
  }
}
