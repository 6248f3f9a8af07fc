#!/usr/bin/env python3
"""Writes examples/meshes/sprout.glb, whose path it takes.

A creature without limbs that sways on five joints and breathes by a morph.

One animation, `sway`, of four seconds, that ends as it begins; a camera, `shot`, that goes around
by a little. Tangents are left to whoever reads the file.
"""
import json
import math
import struct
import sys

RINGS, SIDES, JOINTS, HEIGHT = 64, 48, 5, 2.6


def radius(t):
    """Radius at a share of the height: a foot, a waist, a head with a rounded top."""
    foot = 0.34 * math.exp(-((t / 0.16) ** 2))
    head = 0.30 * math.exp(-(((t - 0.80) / 0.15) ** 2))
    body = 0.22 + 0.05 * math.cos(9.0 * t)
    top = math.sqrt(max(0.0, 1.0 - max(0.0, (t - 0.86) / 0.14) ** 2))
    return max((body + foot + head) * top, 1e-4)


def bump(t, angle):
    """Two brows and a ridge along the back, as a factor of the radius."""
    brow = math.exp(-(((t - 0.84) / 0.05) ** 2)) * math.exp(-(((abs(angle) - 0.6) / 0.3) ** 2))
    back = math.exp(-(((abs(angle) - math.pi) / 0.25) ** 2)) * math.sin(math.pi * t) ** 2
    return 1.0 + 0.16 * brow + 0.16 * back


positions, uvs, joints, weights, breath = [], [], [], [], []
for ring in range(RINGS + 1):
    t = ring / RINGS
    for side in range(SIDES + 1):
        angle = 2.0 * math.pi * side / SIDES - math.pi
        r = radius(t) * bump(t, angle if side < SIDES else -math.pi)
        x, z = r * math.sin(angle), r * math.cos(angle)
        if side in (0, SIDES):
            x, z = 0.0, -r
        positions.append((x, HEIGHT * t, z))
        uvs.append((side / SIDES, 1.0 - t))
        swell = 0.28 * math.exp(-(((t - 0.45) / 0.16) ** 2))
        breath.append((swell * x, 0.0, swell * z))
        # Each joint has the point between its own foot and the next one's.
        place = t * JOINTS - 0.5
        low = min(max(math.floor(place), 0), JOINTS - 1)
        high = min(low + 1, JOINTS - 1)
        share = min(max(place - low, 0.0), 1.0) if high > low else 0.0
        share = share * share * (3.0 - 2.0 * share)
        upper = round(255 * share)
        joints.append((low, high, 0, 0))
        weights.append((255 - upper, upper, 0, 0))
triangles = []
for ring in range(RINGS):
    for side in range(SIDES):
        a = ring * (SIDES + 1) + side
        b, c, d = a + 1, a + SIDES + 2, a + SIDES + 1
        triangles += [(a, b, c), (a, c, d)]



def smooth_normals(points):
    """Unit normals, by the areas around each place: the seam's two columns lie in one."""
    sums = {}
    for a, b, c in triangles:
        u = [points[b][axis] - points[a][axis] for axis in range(3)]
        v = [points[c][axis] - points[a][axis] for axis in range(3)]
        area = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        for corner in (a, b, c):
            total = sums.setdefault(points[corner], [0.0, 0.0, 0.0])
            for axis in range(3):
                total[axis] += area[axis]
    normals = []
    for point in points:
        length = math.sqrt(sum(x * x for x in sums[point]))
        normals.append(tuple(x / length for x in sums[point]))
    return normals


normals = smooth_normals(positions)
breathed = smooth_normals([tuple(map(sum, zip(*rows))) for rows in zip(positions, breath)])
turned = [tuple(b - a for a, b in zip(*rows)) for rows in zip(normals, breathed)]

data, views, accessors = bytearray(), [], []


def add(code, kind, component, rows, **more):
    start = len(data)
    for row in rows:
        data.extend(struct.pack("<" + code * len(row), *row))
    views.append({"buffer": 0, "byteOffset": start, "byteLength": len(data) - start})
    data.extend(bytes(-len(data) % 4))
    accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind,
                      "count": len(rows), **more})
    return len(accessors) - 1


def bounds(rows):
    columns = list(zip(*rows))
    return {"min": [min(column) for column in columns], "max": [max(column) for column in columns]}


def quaternion(axis, angle):
    s = math.sin(angle / 2.0)
    return (axis[0] * s, axis[1] * s, axis[2] * s, math.cos(angle / 2.0))


attributes = {
    "POSITION": add("f", "VEC3", 5126, positions, **bounds(positions)),
    "NORMAL": add("f", "VEC3", 5126, normals),
    "TEXCOORD_0": add("f", "VEC2", 5126, uvs),
    "JOINTS_0": add("B", "VEC4", 5121, joints),
    "WEIGHTS_0": add("B", "VEC4", 5121, weights, normalized=True),
}
indices = add("H", "SCALAR", 5123, [(index,) for triangle in triangles for index in triangle])
target = {
    "POSITION": add("f", "VEC3", 5126, breath, **bounds(breath)),
    "NORMAL": add("f", "VEC3", 5126, turned),
}
step = HEIGHT / JOINTS
binds = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -step * joint, 0, 1) for joint in range(JOINTS)]
binds = add("f", "MAT4", 5126, binds)
times = [(0.25 * key,) for key in range(17)]
times = add("f", "SCALAR", 5126, times, min=[0.0], max=[4.0])
samplers, channels = [], []


def move(node, path, kind, rows):
    samplers.append({"input": times, "output": add("f", kind, 5126, rows)})
    channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})


for joint in range(1, JOINTS):
    turns = []
    for key in range(17):
        phase = 2.0 * math.pi * key / 16.0 - 0.55 * joint
        swing = 0.16 + 0.05 * joint
        turns.append(quaternion((0.35, 0.2, 0.915), swing * math.sin(phase)))
    move(1 + joint, "rotation", "VEC4", turns)
breaths = [(0.5 - 0.5 * math.cos(4.0 * math.pi * key / 16.0),) for key in range(17)]
move(0, "weights", "SCALAR", breaths)
orbit = [quaternion((0, 1, 0), 0.35 * math.sin(2.0 * math.pi * key / 16.0)) for key in range(17)]
move(1 + JOINTS, "rotation", "VEC4", orbit)

nodes = [{"name": "sprout", "mesh": 0, "skin": 0}]
for joint in range(JOINTS):
    node = {"name": f"joint {joint}"}
    if joint:
        node["translation"] = [0, step, 0]
    if joint + 1 < JOINTS:
        node["children"] = [joint + 2]
    nodes.append(node)
nodes.append({"name": "turntable", "children": [2 + JOINTS]})
tilt = -0.12
nodes.append({"name": "shot", "camera": 0, "translation": [0.0, 2.15, 7.0],
              "rotation": list(quaternion((1, 0, 0), tilt))})
document = {
    "asset": {"version": "2.0", "generator": "sprout.py of Chiaro"},
    "scene": 0,
    "scenes": [{"nodes": [0, 1, 1 + JOINTS]}],
    "nodes": nodes,
    "meshes": [{"name": "sprout", "weights": [0.0], "primitives": [
        {"attributes": attributes, "indices": indices, "targets": [target]}]}],
    "skins": [{"joints": list(range(1, 1 + JOINTS)), "inverseBindMatrices": binds}],
    "animations": [{"name": "sway", "channels": channels, "samplers": samplers}],
    "cameras": [{"name": "shot", "type": "perspective",
                 "perspective": {"yfov": 0.46, "aspectRatio": 1.5, "znear": 0.1}}],
    "accessors": accessors,
    "bufferViews": views,
    "buffers": [{"byteLength": len(data)}],
}
text = json.dumps(document, separators=(",", ":")).encode()
text += b" " * (-len(text) % 4)
length = 28 + len(text) + len(data)
with open(sys.argv[1], "wb") as file:
    file.write(struct.pack("<4sIIII", b"glTF", 2, length, len(text), 0x4E4F534A))
    file.write(text + struct.pack("<II", len(data), 0x004E4942) + data)
