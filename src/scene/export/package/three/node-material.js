// {{name}}: a look made with Chiaro {{version}}, for WebGPURenderer of three.js.

import { LookNodeMaterial as Base } from "./webgpu.js";
import { look } from "./{{stem}}.js";

export { fit, fitAll } from "./scene.js";
export { look };

{{files}}
/** The look as a material: `new {{class}}NodeMaterial({ parameters: { ... } })`. */
export class {{class}}NodeMaterial extends Base {
  constructor(options) {
    super(look, files, options);
  }
}
