# Uses an add-on as people do, without a window: `blender_scenes.py ADDON PARAMETER LIGHT FOLDER`.
#
# The panel, faces of many corners, shape keys over frames, values, names that are not there. The
# parameter is a number that changes the picture, and the light one of the look's.
import importlib.util
import math
import os
import sys

import blender_oslquery
import blender_panel
import bpy
import numpy as np
from mathutils import Matrix

SIZE = (64, 48)


def load(path, name="look"):
    spec = importlib.util.spec_from_file_location(name, path)
    look = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(look)
    return look


def fails(what, *words, **options):
    """Holds that a picture is refused with words that help."""
    try:
        what(*SIZE, **options)
    except ValueError as problem:
        missing = [word for word in words if word not in str(problem)]
        assert not missing, (missing, str(problem))
        return
    raise AssertionError(f"{options} is not refused")


def covered(picture):
    return int((picture[..., 3] > 0.5).sum())


def add(operator, **options):
    operator(**options)
    return bpy.context.object


def main():
    addon, parameter, light, folder = sys.argv[1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    camera = add(bpy.ops.object.camera_add, location=(0, -6, 0), rotation=(math.pi / 2, 0, 0))
    scene.camera = camera
    look = load(addon)

    # Without registering: faces of many corners, with texture coordinates.
    cylinder = add(bpy.ops.mesh.primitive_cylinder_add)
    assert max(len(face.vertices) for face in cylinder.data.polygons) > 4
    assert covered(look.render(*SIZE, fit=False)) > 200

    # Edges that are softer with more samples.
    rough, soft = (look.render(*SIZE, fit=False, samples=n)[..., 3] for n in (1, 4))
    between = lambda alpha: int(((alpha > 0.1) & (alpha < 0.9)).sum())
    assert between(rough) == 0 and between(soft) > 10

    # Tangents of faces with many corners are those of their triangles.
    body = look.Body(cylinder, bpy.context.evaluated_depsgraph_get())
    mesh = cylinder.data
    vertices = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", vertices)
    mesh.calc_loop_triangles()
    tangents = body.tangents(mesh, vertices)
    lengths = np.sqrt((tangents[:, :3] ** 2).sum(axis=1))
    assert np.abs(lengths - 1).max() < 1e-4 and set(np.unique(tangents[:, 3])) <= {-1.0, 1.0}
    normals = np.empty(3 * len(vertices), np.float32)
    mesh.corner_normals.foreach_get("vector", normals)
    across = (tangents[:, :3] * look.Body.turned(normals.reshape(-1, 3))).sum(axis=1)
    assert np.abs(across).max() < 1e-3

    blender_oslquery.install()
    look.register()
    blender_panel.check(look)
    settings = getattr(scene, look.STORED)
    settings.fit = False

    # A shape key that is animated deforms the mesh.
    ball = add(bpy.ops.mesh.primitive_uv_sphere_add)
    ball.shape_key_add(name="basis")
    key = ball.shape_key_add(name="wide")
    for point in key.data:
        point.co.x *= 2.0
    for frame, value in ((1, 0.0), (11, 1.0)):
        key.value = value
        key.keyframe_insert("value", frame=frame)
    look.wear(ball)
    counts = []
    for frame in (1, 11):
        scene.frame_set(frame)
        counts.append(covered(look.render(*SIZE)))
    assert counts[1] > 1.5 * counts[0], counts
    # Meshes of the viewport are read again too, which `render` does by itself.
    depsgraph = bpy.context.evaluated_depsgraph_get()
    view = look.player().body(ball, depsgraph)
    scene.frame_set(1)
    assert look.player().body(ball, depsgraph) is not view

    # The wearers are drawn, not the others, and not what is hidden in renders.
    alone = covered(look.render(*SIZE))
    assert alone < covered(look.render(*SIZE, objects=[ball, cylinder]))
    assert covered(look.render(*SIZE, objects=ball)) == alone
    ball.hide_render = True
    cylinder.hide_render = True
    fails(look.render, "no object with faces")
    ball.hide_render = cylinder.hide_render = False

    # Values of the panel, keyframes of them, and values that are given.
    member = look.member_of(parameter)
    own = look.render(*SIZE)
    other = getattr(settings, member) + 0.3
    changed = look.render(*SIZE, parameters={parameter: other})
    assert np.abs(changed - own).max() > 0.1
    settings.keyframe_insert(member, frame=1)
    setattr(settings, member, other)
    settings.keyframe_insert(member, frame=11)
    still = add(bpy.ops.mesh.primitive_uv_sphere_add)
    pictures = []
    for frame in (1, 11):
        scene.frame_set(frame)
        pictures.append(look.render(*SIZE, objects=still))
    scene.frame_set(1)
    assert np.abs(pictures[1] - pictures[0]).max() > 0.1

    # Lights of the panel; what is no light is told.
    sun = add(bpy.ops.object.light_add, type="SUN", rotation=(2.5, 0, 0))
    setattr(settings, look.LIGHT_MEMBERS[light], sun)
    lit = look.render(*SIZE)
    assert np.abs(lit - own).max() > 0.1
    assert np.abs(look.render(*SIZE, lights={light: sun.name}) - lit).max() < 1e-6
    assert np.abs(look.render(*SIZE, lights={light: None}) - own).max() < 1e-6
    setattr(settings, look.LIGHT_MEMBERS[light], None)

    # Names and values that are not there.
    fails(look.render, "no parameter nothing", parameter, parameters={"nothing": 1.0})
    fails(look.render, parameter, "'red'", parameters={parameter: "red"})
    fails(look.render, "no light moon", light, lights={"moon": sun})
    fails(look.render, "Sphere is no light", lights={light: ball})
    fails(look.render, "no object Moon", lights={light: "Moon"})
    fails(look.render, "light and has no faces", objects=sun)
    scene.camera = None
    fails(look.render, "no camera")
    scene.camera = camera

    # One object that cannot be drawn does not keep others from it.
    line = bpy.data.objects.new("Line", bpy.data.meshes.new("line"))
    scene.collection.objects.link(line)
    bpy.context.view_layer.update()
    fails(look.render, "Line has no faces", objects=[ball, line])
    problems = {}
    options = look.options_of(scene)
    depsgraph = bpy.context.evaluated_depsgraph_get()
    view = camera.matrix_world.inverted()
    flat = Matrix.Diagonal((0.3, 0.4, -0.1, 1.0))
    look.player().draw([line, ball], depsgraph, view, flat, SIZE, options, problems)
    assert list(problems) == ["Line"]

    # A PNG that Blender reads as what was drawn.
    path = os.path.join(folder, "picture.png")
    look.save(path, *SIZE)
    image = bpy.data.images.load(path)
    read = np.array(image.pixels[:], np.float32).reshape(SIZE[1], SIZE[0], 4)[::-1]
    assert np.abs(255 * read - look.pixels_of(look.render(*SIZE))).max() < 0.01

    # The file that runs in the text editor while the add-on is installed: the last one counts.
    again = load(addon, "again")
    again.register()
    handlers = bpy.app.handlers.frame_change_post
    assert again.after_change in handlers and look.after_change not in handlers
    look.unregister()
    assert again.after_change in handlers and hasattr(scene, look.STORED)
    again.unregister()
    assert again.after_change not in handlers and not hasattr(scene, look.STORED)


main()
