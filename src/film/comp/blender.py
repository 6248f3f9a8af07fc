# Blender 4.2 or later: makes a scene whose compositor puts the picture together from its layers.
#
#     blender --python THIS                                     opens Blender with it
#     blender -b --python THIS -- --save comp.blend             keeps it
#     blender -b --python THIS -- --gain key=2,1,0.5 --render   writes the pictures
#
# Each light has a Mix node that multiplies it by a color, which is its gain. The Text editor's "Run
# Script" makes the scene in the file that is open; other scenes stay as they are.
import json
import os
import sys

import bpy

COMP = json.loads(r"""{}""")

IS_NEW = bpy.app.version >= (5, 0, 0)


class Graph:
    """Nodes of a compositor, in columns of which each has its next free row."""

    def __init__(self, tree):
        self.tree = tree

    def node(self, kind, place, label=""):
        node = self.tree.nodes.new(kind)
        node.location = (place[0] * 220, place[1] * -190)
        node.label = label
        return node

    def link(self, output, socket):
        self.tree.links.new(output, socket)

    def mix(self, mode, a, b, place, label=""):
        """A and B as a mode has it; alpha is that of A. B is a socket, or a color."""
        if IS_NEW:
            node = self.node("ShaderNodeMix", place, label)
            node.data_type = "RGBA"
            by_name = {socket.identifier: socket for socket in node.inputs}
            factor, first, second = (by_name[n] for n in ("Factor_Float", "A_Color", "B_Color"))
            result = next(s for s in node.outputs if s.identifier == "Result_Color")
            node.clamp_result = False
        else:
            node = self.node("CompositorNodeMixRGB", place, label)
            factor, first, second = node.inputs[:3]
            result = node.outputs[0]
            node.use_clamp = False
        node.blend_type = mode
        factor.default_value = 1.0
        self.link(a, first)
        if isinstance(b, (list, tuple)):
            second.default_value = b
        else:
            self.link(b, second)
        return result

    def curve(self, image, spaces, place, label):
        """Another space of colors that are not premultiplied, with the way there and back."""
        straight = self.node("CompositorNodePremulKey", place)
        set_type(straight, "To Straight", "mapping", "PREMUL_TO_STRAIGHT")
        convert = self.node("CompositorNodeConvertColorSpace", (place[0] + 1, place[1]), label)
        convert.from_color_space, convert.to_color_space = spaces
        premul = self.node("CompositorNodePremulKey", (place[0] + 2, place[1]))
        set_type(premul, "To Premultiplied", "mapping", "STRAIGHT_TO_PREMUL")
        self.link(image, straight.inputs[0])
        self.link(straight.outputs[0], convert.inputs[0])
        self.link(convert.outputs[0], premul.inputs[0])
        return premul.outputs[0]

    def frame(self, label, nodes):
        frame = self.tree.nodes.new("NodeFrame")
        frame.label = label
        for node in nodes:
            node.parent = frame


def set_type(node, word, name, value):
    """A choice of a node: a socket since Blender 5.0, a property before."""
    socket = node.inputs.get("Type")
    if socket is not None:
        socket.default_value = word
    else:
        setattr(node, name, value)


def tree_of(scene):
    """The compositor of a scene, and the socket of its result."""
    if IS_NEW:
        tree = bpy.data.node_groups.new(scene.name, "CompositorNodeTree")
        tree.interface.new_socket("Image", in_out="OUTPUT", socket_type="NodeSocketColor")
        scene.compositing_node_group = tree
        return tree, "NodeGroupOutput"
    scene.use_nodes = True
    scene.node_tree.nodes.clear()
    return scene.node_tree, "CompositorNodeComposite"


def set_frames(node):
    if COMP["frames"] is not None:
        first, last = COMP["frames"]
        node.frame_start = first
        node.frame_offset = first - 1
        node.frame_duration = last - first + 1


def build(folder, gains):
    """Makes the scene."""
    scene = bpy.data.scenes.new(COMP["name"])
    set_up(scene, folder)
    image = bpy.data.images.load(os.path.join(folder, COMP["first_file"]), check_existing=True)
    if COMP["frames"] is not None:
        image.source = "SEQUENCE"
    tree, result_kind = tree_of(scene)
    graph = Graph(tree)
    read = graph.node("CompositorNodeImage", (0, 0), COMP["name"])
    read.image = image
    set_frames(read)
    outputs = {output.name: output for output in read.outputs}
    wanted = [part["layer"] for part in COMP["parts"]] + [COMP["whole"]]
    missing = [name for name in wanted if name not in outputs]
    if missing:
        raise SystemExit(f"{image.filepath} has no layer {', '.join(missing)}")
    known = {"rest"} | {part["label"] for part in COMP["parts"]}
    if not known.issuperset(gains):
        raise SystemExit(f"no part has the name of a gain; there are {', '.join(sorted(known))}")

    def gain_of(name):
        return [*gains.get(name, [1.0, 1.0, 1.0]), 1.0]

    picture = outputs.get("Combined") or outputs["Image"]
    shown = picture
    spaces = ("Linear Rec.709", "sRGB")
    if COMP["is_display"]:
        shown = graph.curve(picture, spaces, (2, -1), "light to as shown")
    into = set(tree.nodes) - {read}
    rest = graph.mix("SUBTRACT", shown, outputs[COMP["whole"]], (5, 0), "what is in no layer")
    total = graph.mix("MULTIPLY", rest, gain_of("rest"), (6, 0), "gain of backdrop and outlines")
    for row, part in enumerate(COMP["parts"], start=1):
        name = part["label"]
        lit = graph.mix(
            "MULTIPLY", outputs[part["layer"]], gain_of(name), (6, row), f"gain of {name}"
        )
        total = graph.mix("ADD", total, lit, (6 + row, row), f"plus {name}")
    gains_of = set(tree.nodes) - {read} - into
    before = set(tree.nodes)
    column, row = 8 + len(COMP["parts"]), len(COMP["parts"])
    if COMP["is_display"]:
        total = graph.curve(total, spaces[::-1], (column, row), "as shown to light")
    result = graph.node(result_kind, (column + 3, row))
    graph.link(total, result.inputs[0])
    viewer = graph.node("CompositorNodeViewer", (column + 3, row + 1))
    graph.link(total, viewer.inputs[0])
    if into:
        graph.frame("As shown, in which the looks blend", into)
    graph.frame("Gains: change the colors of these nodes", gains_of)
    graph.frame("The sum, as premultiplied light", set(tree.nodes) - before - set_of_frames(tree))
    for row, name in enumerate(COMP["mattes"]):
        matte = graph.node("CompositorNodeCryptomatteV2", (0, 4 + 2 * row), name)
        matte.source = "IMAGE"
        matte.image = image
        set_frames(matte)
        matte.layer_name = name
    return scene


def set_of_frames(tree):
    return {node for node in tree.nodes if node.bl_idname == "NodeFrame"}


def set_up(scene, folder):
    """Size, frames and files; the view is the curve of sRGB alone."""
    render = scene.render
    render.resolution_x, render.resolution_y = COMP["size"]
    render.resolution_percentage = 100
    frames, seconds = COMP["rate"]
    render.fps = max(1, round(frames / seconds))
    render.fps_base = render.fps * seconds / frames
    if COMP["frames"] is not None:
        scene.frame_start, scene.frame_end = COMP["frames"]
        scene.frame_set(COMP["frames"][0])
    render.use_compositing = True
    render.use_sequencer = False
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGBA"
    render.image_settings.color_depth = COMP["depth"]
    render.filepath = os.path.join(folder, COMP["output"])
    scene.display_settings.display_device = "sRGB"
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.look = "None"
    scene.view_settings.exposure = 0.0
    scene.view_settings.gamma = 1.0


def folder_of_script():
    """The folder that paths begin at."""
    if os.path.isfile(__file__):
        return os.path.dirname(os.path.abspath(__file__))
    text = bpy.data.texts.get(os.path.basename(__file__))
    if text is not None and text.filepath:
        return os.path.dirname(bpy.path.abspath(text.filepath))
    raise SystemExit("save this script to its file: paths of pictures begin at its folder")


def read_gain(word):
    name, _, numbers = word.partition("=")
    gain = [float(number) for number in numbers.split(",")]
    return name, gain * 3 if len(gain) == 1 else gain


def main(words):
    gains, target, is_rendered = {}, None, False
    words = list(words)
    while words:
        word = words.pop(0)
        if word == "--gain" and words:
            name, gain = read_gain(words.pop(0))
            gains[name] = gain
        elif word == "--save" and words:
            target = os.path.abspath(words.pop(0))
        elif word == "--render":
            is_rendered = True
        else:
            raise SystemExit(f"unknown argument {word}; see the head of this script")
    scene = build(folder_of_script(), gains)
    if bpy.context.window is not None:
        bpy.context.window.scene = scene
    if target is not None:
        bpy.ops.wm.save_as_mainfile(filepath=target)
        bpy.ops.file.make_paths_relative()
        scene.render.filepath = bpy.path.relpath(scene.render.filepath)
        bpy.ops.wm.save_mainfile()
    if is_rendered and COMP["frames"] is not None:
        bpy.ops.render.render(animation=True, scene=scene.name)
    elif is_rendered:
        bpy.ops.render.render(write_still=True, scene=scene.name)


if __name__ == "__main__":
    main(sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else [])
