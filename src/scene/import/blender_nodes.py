# Writes the nodes of a material as JSON, for `chiaro import`.
#
# In Blender: open this file in the text editor, select an object with the material, press Run
# Script. The file lies beside the .blend, named after the material. Or, without a window:
#
#     blender scene.blend --background --python blender_nodes.py -- Material nodes.json

import json
import os
import sys

import bpy

# Properties of every node, which say nothing about the picture.
COMMON = {item.identifier for item in bpy.types.Node.bl_rna.properties}


def plain(value):
    """A property as JSON; None for what has no place in it."""
    if isinstance(value, (bool, int, float, str)):
        return value
    try:
        return [float(number) for number in value]
    except (TypeError, ValueError):
        return None


def ramp(value):
    stops = [{"at": stop.position, "color": list(stop.color)} for stop in value.elements]
    return {"interpolation": value.interpolation, "mode": value.color_mode, "stops": stops}


def curves(value):
    return [[list(point.location) for point in curve.points] for curve in value.curves]


def socket(item):
    found = {"name": item.name, "id": item.identifier, "type": item.type}
    value = plain(getattr(item, "default_value", None))
    # A hidden vector is none: the node has the surface's own place or normal there.
    is_own = item.hide_value and item.type == "VECTOR"
    if value is not None and not is_own:
        found["value"] = value
    return found


def node(item):
    found = {
        "name": item.name, "label": item.label, "kind": item.bl_idname,
        "at": list(getattr(item, "location_absolute", item.location)), "muted": item.mute,
        "inputs": [socket(it) for it in item.inputs if it.enabled or it.is_linked],
        "outputs": [socket(it) for it in item.outputs], "settings": {},
    }
    for prop in item.bl_rna.properties:
        if prop.identifier in COMMON:
            continue
        value = getattr(item, prop.identifier)
        if prop.identifier == "color_ramp":
            found["ramp"] = ramp(value)
        elif prop.identifier == "mapping" and hasattr(value, "curves"):
            found["curves"] = curves(value)
        elif prop.identifier == "image" and value is not None:
            path = bpy.path.abspath(value.filepath)
            found["image"] = {"path": path, "space": value.colorspace_settings.name}
        elif prop.identifier == "node_tree" and value is not None:
            found["group"] = value.name
        elif plain(value) is not None:
            found["settings"][prop.identifier] = plain(value)
    return found


def tree(item, groups):
    for inner in item.nodes:
        group = getattr(inner, "node_tree", None)
        if group is not None and group.name not in groups:
            groups[group.name] = None
            groups[group.name] = tree(group, groups)
    links = [
        [it.from_node.name, it.from_socket.identifier, it.to_node.name, it.to_socket.identifier]
        for it in item.links if it.is_valid
    ]
    return {"nodes": [node(it) for it in item.nodes], "links": links}


def document(material):
    groups = {}
    found = tree(material.node_tree, groups)
    return {"blender": bpy.app.version_string, "material": material.name, **found,
            "groups": groups}


def write(material, path):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document(material), file, indent=1)
    print("written:", path)


if __name__ == "__main__":
    given = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    chosen = bpy.data.materials[given[0]] if given else bpy.context.object.active_material
    beside = os.path.dirname(bpy.data.filepath) or os.getcwd()
    write(chosen, given[1] if len(given) > 1 else os.path.join(beside, chosen.name + ".json"))
