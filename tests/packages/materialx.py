"""Reads a package for MaterialX as its users do, and writes the shaders that are generated of it.

    materialx.py FOLDER OUT

Prints what the document has as JSON; ends with an error where the document is not valid.
"""

import json
import os
import sys

import MaterialX as mx
from MaterialX import PyMaterialXGenGlsl as glsl
from MaterialX import PyMaterialXGenShader as gen

GENERATORS = {
    "genglsl": glsl.GlslShaderGenerator,
    "genessl": glsl.EsslShaderGenerator,
    "genvk": glsl.VkShaderGenerator,
}

folder, out = sys.argv[1:]
name = next(name for name in os.listdir(folder) if name.endswith(".mtlx"))

search_path = mx.getDefaultDataSearchPath()
library = mx.createDocument()
mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search_path, library)
document = mx.createDocument()
mx.readFromXmlFile(document, os.path.join(folder, name))
document.setDataLibrary(library)
is_valid, problems = document.validate()
if not is_valid:
    sys.exit(problems)
material = document.getMaterialNodes()[0]
surface = mx.getShaderNodes(material)[0]
search_path.append(mx.FilePath(folder))
for target, generator in GENERATORS.items():
    generator = generator.create()
    context = gen.GenContext(generator)
    context.registerSourceCodeSearchPath(search_path)
    shader = generator.generate("look", surface, context)
    for stage, ending in (("vertex", "vert"), ("pixel", "frag")):
        with open(os.path.join(out, f"{target}.{ending}"), "w") as file:
            file.write(shader.getSourceCode(stage))

node = surface.getConnectedNode("emission_color").getNodeDef()
attributes = ("uiname", "uifolder", "uimin", "uimax", "doc")
inputs = {
    it.getName(): {
        "type": it.getType(),
        "value": it.getValueString(),
        **{name: it.getAttribute(name) for name in attributes if it.hasAttribute(name)},
    }
    for it in node.getInputs()
}
assigns = [it.getMaterial() for look in document.getLooks() for it in look.getMaterialAssigns()]
print(json.dumps({
    "version": mx.getVersionString(),
    "material": material.getName(),
    "assigned": assigns,
    "inputs": inputs,
}))
