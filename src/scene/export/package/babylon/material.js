// {{name}}: a look made with Chiaro {{version}}, for Babylon.js.

import { LookMaterial as Base } from "./runtime.js";
import { look } from "./{{stem}}.js";

export { look };

{{files}}
/** The look as a material: `new {{class}}Material("name", scene, { parameters: { ... } })`. */
export class {{class}}Material extends Base {
  constructor(name, scene, options) {
    super(name, scene, look, files, options);
  }
}
