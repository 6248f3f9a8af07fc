// A module's shaders as Babylon.js takes them.

const RECODE = {
  wgsl: `
fn chiaro_encoded(x: vec3f) -> vec3f {
  return select(1.055 * pow(x, vec3f(1.0 / 2.4)) - 0.055, 12.92 * x, x <= vec3f(0.0031308));
}
fn chiaro_decoded(x: vec3f) -> vec3f {
  return select(pow((x + 0.055) / 1.055, vec3f(2.4)), x / 12.92, x <= vec3f(0.04045));
}
`,
  glsl: `
vec3 chiaro_encoded(vec3 x) {
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}
vec3 chiaro_decoded(vec3 x) {
  return mix(pow((x + 0.055) / 1.055, vec3(2.4)), x / 12.92, lessThanEqual(x, vec3(0.04045)));
}
`,
};

/** The function that brings a look's colors to what is drawn on; none where they fit. */
export function recodingOf(look, target) {
  if (target === look.colorSpace) return null;
  return target === "display" ? "chiaro_encoded" : "chiaro_decoded";
}

/** A fragment shader whose color goes through a function. */
function recoded(text, recoding) {
  const color = /layout\(location = 0\) out vec4 (\w+);/.exec(text)[1];
  return `${text.replace("void main()", "void chiaro_main()")}${RECODE.glsl}
void main() {
  chiaro_main();
  ${color}.rgb = ${recoding}(clamp(${color}.rgb, 0.0, 1.0));
}
`;
}

/**
 * A module's text whose rows run downward, as those of Chiaro's pictures: in the pictures of
 * Babylon.js they run upward. Layers of shadow maps are drawn upside down.
 */
const downward = (text, { draws }) =>
  (draws === "lights" ? text : text.replace(/\b(dFdy|dpdy)\(/g, "-$1("));

/** The shaders in GLSL; attributes have the names that Babylon.js gives them. */
export function glslOf({ glsl, attributes }, pass, recoding) {
  const vertex = attributes.reduce(
    (text, { name }) => text.replace(new RegExp(`\\ba_${name}\\b`, "g"), name), glsl.vertex);
  const drawn = downward(glsl.fragment, pass);
  const fragment = recoding ? recoded(drawn, recoding) : drawn;
  return { vertexSource: vertex, fragmentSource: fragment };
}

/** Names and types after the attributes in a list of members or arguments. */
function entriesOf(list) {
  const entry = /((?:@\w+(?:\([^)]*\))?\s*)*)(\w+)\s*:\s*([\w<>]+)/g;
  return Array.from(list.replace(/\/\/.*/g, "").matchAll(entry),
    ([, attributes, name, type]) => ({ attributes, name, type }));
}

const structOf = (text, name) =>
  entriesOf(new RegExp(`struct ${name} \\{([^}]*)\\}`).exec(text)[1]);

/** The shaders in the WGSL of Babylon.js, which binds and declares what is between them. */
export function wgslOf(module, pass, recoding) {
  const entries = {};
  let text = downward(module.wgsl, pass).replace(/@group\(\d+\)\s*@binding\(\d+\)\s*/g, "").replace(
    /@(vertex|fragment)\s+fn (\w+)\(([^{]*?)\)(\s*->[^{]*)?\{/g,
    (_, stage, name, list, result = "") => {
      const type = result.replace(/->|@\w+(\([^)]*\))?/g, "").trim();
      entries[stage] = { name, list: entriesOf(list), type };
      return `fn ${name}(${list.replace(/@\w+(\([^)]*\))?\s*/g, "")}) -> ${type} {`;
    },
  );
  // Babylon.js looks for the types of textures in the text.
  for (const [, alias, type] of text.matchAll(/alias (\w+) = (texture_[^;]+);/g)) {
    text = text.replace(new RegExp(`(var \\w+\\s*:\\s*)${alias};`, "g"), `$1${type};`);
  }
  const textures = module.bindings.filter(({ kind }) => kind === "texture");
  for (const { name, feed } of module.bindings.filter(({ kind }) => kind === "sampler")) {
    const own = textures.find((texture) => texture.feed.image === feed.image);
    text = text.replace(new RegExp(`(?<!\\.)\\b${name}\\b`, "g"), `${own.name}Sampler`);
  }
  const hasMembers = !entries.vertex.type.startsWith("vec4");
  const between = hasMembers ? structOf(text, entries.vertex.type) : [];
  const isClip = ({ attributes }) => attributes.includes("position");
  const carried = between.filter((member) => !isClip(member));
  const declared = (word, { name, type, attributes }) => {
    const flat = attributes?.includes("flat") ? "flat " : "";
    return `${flat}${word} ${name} : ${type};\n`;
  };
  const varyings = carried.map((member) =>
    declared("varying", { ...member, name: `v_${member.name}` })).join("");
  const vertex = entries.vertex.list.map(({ attributes, name, type }) => {
    if (attributes.includes("vertex_index")) return "vertexInputs.vertexIndex";
    if (attributes.includes("location")) return `vertexInputs.${name}`;
    return `${type}(${structOf(text, type).map((one) => `vertexInputs.${one.name}`).join(", ")})`;
  });
  const fragment = entries.fragment.list.map(({ attributes, type }) => {
    if (attributes.includes("front_facing")) return "fragmentInputs.frontFacing";
    if (attributes.includes("position")) return "fragmentInputs.position";
    const members = between.map((member) =>
      (isClip(member) ? "fragmentInputs.position" : `fragmentInputs.v_${member.name}`));
    return `${type}(${members.join(", ")})`;
  });
  const called = `${entries.fragment.name}(${fragment.join(", ")})`;
  const shaded = entries.fragment.type === "f32" ? `vec4f(${called}, 0.0, 0.0, 1.0)` : called;
  const inside = "clamp(color.rgb, vec3f(0.0), vec3f(1.0))";
  const recoded = recoding ? `color = vec4f(${recoding}(${inside}), color.a);` : "";
  const results = between.map((member) => isClip(member)
    ? `  vertexOutputs.position = result.${member.name};\n`
    : `  vertexOutputs.v_${member.name} = result.${member.name};\n`);
  if (!hasMembers) results.push("  vertexOutputs.position = result;\n");
  return {
    vertexSource: `${module.attributes.map((one) => declared("attribute", one)).join("")}${varyings}
${text}
@vertex
fn main(input : VertexInputs) -> FragmentInputs {
  let result = ${entries.vertex.name}(${vertex.join(", ")});
${results.join("")}}
`,
    fragmentSource: `#define DISABLE_UNIFORMITY_ANALYSIS
${varyings}
${text}${recoding ? RECODE.wgsl : ""}
@fragment
fn main(input : FragmentInputs) -> FragmentOutputs {
  var color = ${shaded};
  ${recoded}
  fragmentOutputs.color = color;
}
`,
  };
}
