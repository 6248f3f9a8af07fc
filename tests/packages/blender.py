# Draws an add-on's look in Blender, without a window: `blender.py CASE.json`.
#
# The case has the add-on's file, a mesh with y up, a camera, and for each picture the parameters,
# lights and the file for its pixels: straight RGBA of 8 bits, the top row first.
import importlib.util
import json
import os
import sys

import blender_oslquery
import bpy
import gpu
import numpy as np
from mathutils import Matrix, Vector

Z_UP = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def start():
    """An empty scene with a camera. The add-on opens the graphics card by itself."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    return camera


def mesh_of(case):
    mesh = bpy.data.meshes.new("mesh")
    vertices = [Z_UP @ Vector(place) for place in case["positions"]]
    mesh.from_pydata(vertices, [], case["triangles"])
    corners = [corner for triangle in case["triangles"] for corner in triangle]
    normals = mesh.attributes.new("custom_normal", "FLOAT_VECTOR", "CORNER")
    turned = [Z_UP @ Vector(case["normals"][corner]) for corner in corners]
    normals.data.foreach_set("vector", np.array(turned, np.float32).reshape(-1))
    uv = mesh.uv_layers.new(name="uv")
    given = np.array([case["uvs"][corner] for corner in corners], np.float32)
    uv.uv.foreach_set("vector", given.reshape(-1))
    mesh.update()
    thing = bpy.data.objects.new("mesh", mesh)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def place(camera, case):
    """Puts the camera, which is that of the mesh at unit size, before the mesh as it is."""
    places = np.array(case["positions"])
    middle = (places.min(axis=0) + places.max(axis=0)) / 2
    radius = float(np.sqrt(((places - middle) ** 2).sum(axis=1)).max())
    eye, target = (Vector(case["camera"][name]) for name in ("eye", "target"))
    back = (eye - target).normalized()
    right = Vector((0, 1, 0)).cross(back).normalized()
    turn = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    turn.translation = Vector(middle) + radius * eye
    camera.matrix_world = Z_UP @ turn
    camera.data.sensor_fit = "VERTICAL"
    camera.data.angle = case["camera"]["fov"]
    camera.data.clip_start, camera.data.clip_end = 0.01 * radius, 20 * radius


def shown(look, width, height):
    """The picture as it is shown over a viewport: here a transparent one, with far depths."""
    color = gpu.types.GPUTexture((width, height), format="RGBA8")
    depth = gpu.types.GPUTexture((width, height), format="DEPTH_COMPONENT32F")
    buffer = gpu.types.GPUFrameBuffer(depth_slot=depth, color_slots=[color])
    with buffer.bind():
        buffer.clear(color=(0.0, 0.0, 0.0, 0.0), depth=1.0)
        look.show(False)
        read = buffer.read_color(0, 0, width, height, 4, 0, "UBYTE")
    read.dimensions = width * height * 4
    # Rows of a viewport run up.
    return np.array(read, np.uint8).reshape(height, width, 4)[::-1]


def cycles(look, thing, size, parameters, lights, samples):
    """The picture by Cycles on the CPU: a sample in the middle of each pixel, or some all over."""
    blender_oslquery.install()
    scene = bpy.context.scene
    settings = getattr(scene, look.STORED)
    given = {look.member_of(name): value for name, value in (parameters or {}).items()}
    given |= {look.LIGHT_MEMBERS[name]: light for name, light in lights.items()}
    for member, value in given.items():
        setattr(settings, member, value)
    look.wear_in_cycles(thing)
    render, engine = scene.render, scene.cycles
    render.resolution_x, render.resolution_y = size
    render.resolution_percentage = 100
    render.film_transparent = True
    render.dither_intensity = 0.0
    engine.device = "CPU"
    engine.samples = samples
    engine.use_adaptive_sampling = engine.use_denoising = False
    engine.pixel_filter_type, engine.filter_width = "BOX", 0.01 if samples == 1 else 1.0
    saved = render.image_settings
    saved.file_format, saved.color_mode, saved.color_depth = "PNG", "RGBA", "8"
    bpy.ops.render.render()
    path = os.path.join(bpy.app.tempdir, "cycles.png")
    bpy.data.images["Render Result"].save_render(path)
    image = bpy.data.images.load(path)
    image.colorspace_settings.name, image.alpha_mode = "Non-Color", "CHANNEL_PACKED"
    numbers = np.empty(4 * size[0] * size[1], np.float32)
    image.pixels.foreach_get(numbers)
    bpy.data.images.remove(image)
    for member in given:
        settings.property_unset(member)
    pixels = np.rint(255 * numbers).astype(np.uint8)
    return pixels.reshape(size[1], size[0], 4)[::-1]


def main():
    with open(sys.argv[1]) as file:
        case = json.load(file)
    camera = start()
    thing = mesh_of(case)
    place(camera, case)
    spec = importlib.util.spec_from_file_location("look", case["addon"])
    look = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(look)
    look.register()
    width, height = case["size"]
    for picture in case["pictures"]:
        lights = {}
        for name, toward in picture.get("suns", {}).items():
            sun = bpy.data.objects.new(name, bpy.data.lights.new(name, "SUN"))
            bpy.context.scene.collection.objects.link(sun)
            sun.rotation_euler = (Z_UP.to_3x3() @ Vector(toward)).to_track_quat("Z", "Y").to_euler()
            lights[name] = sun
        bpy.context.view_layer.update()
        settings = getattr(bpy.context.scene, look.STORED)
        if picture.get("cycles"):
            size, samples = (width, height), picture.get("samples", 1)
            pixels = cycles(look, thing, size, picture.get("parameters"), lights, samples)
            with open(picture["file"], "wb") as file:
                file.write(pixels.tobytes())
            continue
        if picture.get("by_properties"):
            for name, value in picture["parameters"].items():
                setattr(settings, look.member_of(name), value)
            drawn = look.render(width, height, samples=1)
            for name in picture["parameters"]:
                settings.property_unset(look.member_of(name))
        else:
            parameters = picture.get("parameters", {})
            drawn = look.render(width, height, [thing], camera, parameters, lights, samples=1)
        pixels = look.pixels_of(drawn)
        if picture.get("shown"):
            pixels = shown(look, width, height)
        with open(picture["file"], "wb") as file:
            file.write(pixels.tobytes())
    look.unregister()


main()
