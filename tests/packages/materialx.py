"""Reads a package for MaterialX as its users do, writes the shaders that are generated of it, and
draws them with MaterialX's own renderer where a mesh is given.

    materialx.py FOLDER OUT [MESH.obj WIDTH HEIGHT]

Prints what the document has as JSON; ends with an error where the document is not valid. Pictures
are the bytes of RGBA, rows from the top, of the look's GLSL (`code.rgba`) and of its graph of
MaterialX's own nodes (`graph.rgba`), where it has one. Drawing needs a display.
"""

import json
import math
import os
import sys

import MaterialX as mx
from MaterialX import PyMaterialXGenGlsl as glsl
from MaterialX import PyMaterialXGenMdl as mdl
from MaterialX import PyMaterialXGenMsl as msl
from MaterialX import PyMaterialXGenOsl as osl
from MaterialX import PyMaterialXGenShader as gen

GENERATORS = {
    "genglsl": glsl.GlslShaderGenerator,
    "genessl": glsl.EsslShaderGenerator,
    "genvk": glsl.VkShaderGenerator,
}

# Generators that take no GLSL, so the graph alone.
OTHERS = {
    "genosl": osl.OslShaderGenerator,
    "genmdl": mdl.MdlShaderGenerator,
    "genmsl": msl.MslShaderGenerator,
}

# The tests' camera.
EYE, FIELD_OF_VIEW = (0.8, 0.9, 3.0), 30.0


def read(folder):
    """The package's document and the surface of its material."""
    name = next(name for name in os.listdir(folder) if name.endswith(".mtlx"))
    library = mx.createDocument()
    mx.loadLibraries(
        mx.getDefaultDataLibraryFolders(), mx.getDefaultDataSearchPath(), library
    )
    document = mx.createDocument()
    mx.readFromXmlFile(document, os.path.join(folder, name))
    document.setDataLibrary(library)
    is_valid, problems = document.validate()
    if not is_valid:
        sys.exit(problems)
    return document, mx.getShaderNodes(document.getMaterialNodes()[0])[0]


def generated(generator, surface, folder, is_transparent=False):
    """The shader that a generator makes of a surface."""
    generator = generator.create()
    context = gen.GenContext(generator)
    search_path = mx.getDefaultDataSearchPath()
    search_path.append(mx.FilePath(folder))
    context.registerSourceCodeSearchPath(search_path)
    context.getOptions().hwTransparency = is_transparent
    return generator.generate("look", surface, context)


def draw(shader, mesh, width, height):
    """The picture of a mesh that wears the shader, as bytes."""
    from MaterialX import PyMaterialXRender as render
    from MaterialX import PyMaterialXRenderGlsl as render_glsl

    renderer = render_glsl.GlslRenderer.create(width, height, render.BaseType.UINT8)
    renderer.initialize()
    geometry = renderer.getGeometryHandler()
    geometry.addLoader(render.TinyObjLoader.create())
    if not geometry.loadGeometry(mx.FilePath(mesh), False):
        sys.exit("the mesh is not read")
    near, far = 0.05, 100.0
    top = math.tan(math.radians(FIELD_OF_VIEW) / 2) * near
    right = top * width / height
    camera = render.Camera.create()
    camera.setViewMatrix(
        render.Camera.createViewMatrix(
            mx.Vector3(*EYE), mx.Vector3(0.0, 0.0, 0.0), mx.Vector3(0.0, 1.0, 0.0)
        )
    )
    camera.setProjectionMatrix(
        render.Camera.createPerspectiveMatrix(-right, right, -top, top, near, far)
    )
    camera.setWorldMatrix(mx.Matrix44.IDENTITY)
    camera.setViewportSize(mx.Vector2(width, height))
    renderer.setCamera(camera)
    renderer.setLightHandler(render.LightHandler.create())
    images = render_glsl.GLTextureHandler.create(render.StbImageLoader.create())
    renderer.setImageHandler(images)
    renderer.createProgram(shader)
    renderer.validateInputs()
    renderer.render()
    picture = renderer.captureImage(None)
    pixels = bytearray()
    for y in reversed(range(height)):
        for x in range(width):
            color = picture.getTexelColor(x, y)
            pixels += bytes(round(255 * color[channel]) for channel in range(4))
    return bytes(pixels)


folder, out, *drawing = sys.argv[1:]
document, surface = read(folder)
for target, generator in GENERATORS.items():
    shader = generated(generator, surface, folder)
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
graph = next((it for it in document.getNodeGraphs() if it.getName().endswith("_standard")), None)
others = []
if graph:
    for target, generator in OTHERS.items():
        # Of MSL, the pixel stage; the others have one.
        text = generated(generator, surface, folder).getSourceCode("pixel")
        if text:
            others.append(target)
print(json.dumps({
    "version": mx.getVersionString(),
    "material": document.getMaterialNodes()[0].getName(),
    "assigned": assigns,
    "inputs": inputs,
    "graph": len(graph.getNodes()) if graph else 0,
    "others": others,
}))

if drawing or graph:
    shaders = {"code": generated(GENERATORS["genglsl"], surface, folder, True)}
    if graph:
        for other in document.getNodeGraphs():
            if other.getTarget() == "genglsl":
                document.removeNodeGraph(other.getName())
        shaders["graph"] = generated(GENERATORS["genglsl"], surface, folder, True)
        with open(os.path.join(out, "graph.frag"), "w") as file:
            file.write(shaders["graph"].getSourceCode("pixel"))
    for name, shader in shaders.items() if drawing else ():
        mesh, width, height = drawing
        with open(os.path.join(out, f"{name}.rgba"), "wb") as file:
            file.write(draw(shader, mesh, int(width), int(height)))
