#!/usr/bin/env python3
"""Writes the meshes of examples/shots/nightfall, whose folder it takes, and prints what the lantern
does as keys of a shot.

    scripts/nightfall.py examples/shots/nightfall

Hob, a mushroom that walks; Glim, a fish with a lantern; and the meadow where they meet. Poses are
keyed on twos and held (`STEP`): frames 1 and 2 of 96 show one pose, 3 and 4 the next.
"""
import json
import math
import os
import struct
import sys

RATE, FRAMES = 24.0, 96
POSES = range(1, FRAMES + 1, 2)


def mix(a, b, share):
    """A number, or a place, between two."""
    if isinstance(a, (int, float)):
        return a + (b - a) * share
    return tuple(mix(x, y, share) for x, y in zip(a, b))


def ease(frame, start, end):
    """A share that goes from 0 to 1 between two frames, at rest at both."""
    t = min(max((frame - start) / (end - start), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def quaternion(axis, angle):
    s = math.sin(angle / 2.0)
    return (axis[0] * s, axis[1] * s, axis[2] * s, math.cos(angle / 2.0))


def times(a, b):
    """The turn b, and then a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)


def turned(q, point):
    x, y, z, _ = times(times(q, (*point, 0.0)), (-q[0], -q[1], -q[2], q[3]))
    return (x, y, z)


X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


class Part:
    """Vertices and triangles of one material, each vertex with two joints."""

    def __init__(self, material):
        self.material = material
        self.points, self.uvs, self.bones, self.triangles = [], [], [], []

    def loft(self, rings, sides, ring_at, bone_at):
        """A closed skin over rings: `ring_at(t, angle)` is a place, `bone_at(t)` two joints and the
        share of the second."""
        first = len(self.points)
        for ring in range(rings + 1):
            t = ring / rings
            low, high, share = bone_at(t)
            for side in range(sides + 1):
                angle = 2.0 * math.pi * (side % sides) / sides
                self.points.append(tuple(round(x, 6) for x in ring_at(t, angle)))
                self.uvs.append((side / sides, 1.0 - t))
                self.bones.append((low, high, share))
        for ring in range(rings):
            for side in range(sides):
                a = first + ring * (sides + 1) + side
                b, c, d = a + 1, a + sides + 2, a + sides + 1
                # The poles have triangles where the rest has pairs of them.
                if ring > 0:
                    self.triangles.append((a, b, c))
                if ring + 1 < rings:
                    self.triangles.append((a, c, d))

    def ball(self, middle, radii, rings, sides, bone, turn=(0, 0, 0, 1), bump=None):
        def ring_at(t, angle):
            polar = math.pi * (1.0 - t)
            flat = math.sin(polar) if 0.0 < t < 1.0 else 0.0
            unit = (flat * math.sin(angle), math.cos(polar), flat * math.cos(angle))
            swell = bump(unit) if bump else 1.0
            place = turned(turn, tuple(swell * r * x for r, x in zip(radii, unit)))
            return tuple(m + p for m, p in zip(middle, place))
        self.loft(rings, sides, ring_at, lambda t: (bone, bone, 0.0))

    def lathe(self, profile, sides, bone_at, lean=lambda y: (0.0, 0.0)):
        """A skin around the y axis: pairs of a radius and a height, from below to above."""
        def ring_at(t, angle):
            place = t * (len(profile) - 1)
            index = min(int(place), len(profile) - 2)
            radius, y = mix(profile[index], profile[index + 1], place - index)
            x, z = lean(y)
            return (x + radius * math.sin(angle), y, z + radius * math.cos(angle))
        self.loft(len(profile) - 1, sides, ring_at, bone_at)

    def normals(self):
        """Unit normals, by the areas around each place: both columns of a seam lie in one."""
        sums = {}
        for a, b, c in self.triangles:
            u = [q - p for p, q in zip(self.points[a], self.points[b])]
            v = [q - p for p, q in zip(self.points[a], self.points[c])]
            area = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            for corner in (a, b, c):
                total = sums.setdefault(self.points[corner], [0.0, 0.0, 0.0])
                for axis in range(3):
                    total[axis] += area[axis]
        normals = []
        for point in self.points:
            total = sums.get(point, (0.0, 1.0, 0.0))
            length = math.sqrt(sum(x * x for x in total)) or 1.0
            normals.append(tuple(x / length for x in total))
        return normals


def smooth_profile(points, steps):
    """More points of a profile, on a curve through them (Catmull-Rom)."""
    out = []
    for index in range(len(points) - 1):
        p = [points[min(max(index + k, 0), len(points) - 1)] for k in (-1, 0, 1, 2)]
        for step in range(steps):
            t = step / steps
            out.append(tuple(
                0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t
                       + (3 * b - a - 3 * c + d) * t ** 3)
                for a, b, c, d in zip(*p)))
    return [(max(r, 0.0), y) for r, y in out] + [points[-1]]


class File:
    """A glTF file in the making."""

    def __init__(self):
        self.data, self.views, self.accessors = bytearray(), [], []

    def add(self, code, kind, component, rows, **more):
        start = len(self.data)
        for row in rows:
            self.data.extend(struct.pack("<" + code * len(row), *row))
        view = {"buffer": 0, "byteOffset": start, "byteLength": len(self.data) - start}
        self.views.append(view)
        self.data.extend(bytes(-len(self.data) % 4))
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component,
                               "type": kind, "count": len(rows), **more})
        return len(self.accessors) - 1

    def write(self, path, name, parts, joints, moves):
        """`joints`: name, parent, place under the parent. `moves`: joint, path, values by pose."""
        primitives = []
        for number, part in enumerate(parts):
            columns = list(zip(*part.points))
            bounds = {"min": [min(c) for c in columns], "max": [max(c) for c in columns]}
            attributes = {"POSITION": self.add("f", "VEC3", 5126, part.points, **bounds),
                          "NORMAL": self.add("f", "VEC3", 5126, part.normals()),
                          "TEXCOORD_0": self.add("f", "VEC2", 5126, part.uvs)}
            if joints:
                rows = [(low, high, 0, 0) for low, high, _ in part.bones]
                shares = [round(255 * share) for *_, share in part.bones]
                weights = [(255 - share, share, 0, 0) for share in shares]
                attributes["JOINTS_0"] = self.add("B", "VEC4", 5121, rows)
                attributes["WEIGHTS_0"] = self.add("B", "VEC4", 5121, weights, normalized=True)
            corners = [(index,) for triangle in part.triangles for index in triangle]
            primitives.append({"attributes": attributes, "material": number,
                               "indices": self.add("H", "SCALAR", 5123, corners)})
        document = {
            "asset": {"version": "2.0", "generator": "nightfall.py of Chiaro"},
            "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"name": name, "mesh": 0}],
            "materials": [{"name": part.material} for part in parts],
            "meshes": [{"name": name, "primitives": primitives}],
        }
        if joints:
            self.animate(document, joints, moves)
        document.update({"accessors": self.accessors, "bufferViews": self.views,
                         "buffers": [{"byteLength": len(self.data)}]})
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        length = 28 + len(text) + len(self.data)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sIIII", b"glTF", 2, length, len(text), 0x4E4F534A))
            file.write(text + struct.pack("<II", len(self.data), 0x004E4942) + self.data)

    def animate(self, document, joints, moves):
        places, binds = [], []
        for joint, parent, place in joints:
            node = {"name": joint, "translation": list(place)}
            document["nodes"].append(node)
            if parent is not None:
                place = tuple(a + b for a, b in zip(places[parent], place))
                document["nodes"][1 + parent].setdefault("children", []).append(len(places) + 1)
            places.append(place)
            binds.append((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, *(-x for x in place), 1))
        document["scenes"][0]["nodes"].append(1)
        document["nodes"][0]["skin"] = 0
        document["skins"] = [{"joints": list(range(1, 1 + len(joints))),
                              "inverseBindMatrices": self.add("f", "MAT4", 5126, binds)}]
        # A pose begins half a frame early, so that rounding of times never shows another.
        keys = [((frame - 0.5) / RATE,) for frame in POSES]
        keys = self.add("f", "SCALAR", 5126, keys, min=[keys[0][0]], max=[keys[-1][0]])
        samplers, channels = [], []
        for joint, path, rows in moves:
            kind = "VEC4" if path == "rotation" else "VEC3"
            samplers.append({"input": keys, "interpolation": "STEP",
                             "output": self.add("f", kind, 5126, rows)})
            channels.append({"sampler": len(samplers) - 1,
                             "target": {"node": 1 + joint, "path": path}})
        document["animations"] = [{"name": "nightfall", "channels": channels,
                                   "samplers": samplers}]


# ---------------------------------------------------------------------------------- Glim, the fish

SIZE = 0.80
BULB = (0.0, 0.30, 0.60)
# Frame and place. It comes from behind the trees, passes before Hob, goes around and stays.
PATH = [(-11, (4.6, 2.5, -5.4)), (1, (3.7, 2.2, -4.2)), (18, (2.6, 1.5, -1.4)),
        (31, (1.45, 0.66, 0.75)), (41, (0.25, 0.46, 1.35)), (50, (-1.15, 0.80, 0.95)),
        (59, (-1.85, 1.40, -0.2)), (68, (-1.0, 1.80, -1.05)), (78, (0.45, 1.50, -0.75)),
        (88, (1.20, 0.92, 0.15)), (100, (1.20, 0.76, 0.42)), (112, (1.18, 0.74, 0.42))]


def swim(frame):
    """Where the fish is, on a curve through the places of its path (Hermite, by frames)."""
    index = max(i for i in range(len(PATH)) if PATH[i][0] <= frame)
    index = min(max(index, 1), len(PATH) - 3)

    def slope(i):
        (f0, p0), (f1, p1) = PATH[i - 1], PATH[i + 1]
        return tuple((b - a) / (f1 - f0) for a, b in zip(p0, p1))

    (f0, p0), (f1, p1) = PATH[index], PATH[index + 1]
    span, t = f1 - f0, (frame - f0) / (f1 - f0)
    h = (2 * t**3 - 3 * t**2 + 1, t**3 - 2 * t**2 + t, 3 * t**2 - 2 * t**3, t**3 - t**2)
    return tuple(h[0] * a + h[1] * span * m + h[2] * b + h[3] * span * n
                 for a, b, m, n in zip(p0, p1, slope(index), slope(index + 1)))


def fish_turn(frame):
    """The way it swims; at the end it looks at Hob. It leans into its curves."""
    ahead, behind = swim(frame + 1.0), swim(frame - 1.0)
    way = tuple(a - b for a, b in zip(ahead, behind))
    yaw = math.atan2(way[0], way[2])
    pitch = -math.atan2(way[1], math.hypot(way[0], way[2]))
    before, after = (tuple(a - b for a, b in zip(swim(f + 1.0), swim(f - 1.0)))
                     for f in (frame - 3.0, frame + 3.0))
    bend = math.atan2(after[0], after[2]) - math.atan2(before[0], before[2])
    bend = (bend + math.pi) % (2.0 * math.pi) - math.pi
    here = swim(frame)
    look = math.atan2(HOB_STANDS[0] - here[0], HOB_STANDS[2] + 0.25 - here[2])
    rest = ease(frame, 78, 90)
    apart = (look - yaw + math.pi) % (2.0 * math.pi) - math.pi
    yaw += rest * apart
    turn = times(quaternion(Y, yaw), quaternion(X, pitch * (1.0 - rest) + 0.08 * rest))
    return times(turn, quaternion(Z, -0.7 * max(min(bend, 0.8), -0.8) * (1.0 - rest)))


def bulb_at(frame):
    return tuple(a + b for a, b in zip(swim(frame), turned(fish_turn(frame), tuple(SIZE * x for x in BULB))))


def fish():
    body, fin, eye, pupil, bulb = (Part(n) for n in ("body", "fin", "eye", "pupil", "bulb"))
    # Joints: 0 all of it, 1 to 4 along the back to the tail, 5 and 6 the fins at its sides.
    joints = [("glim", None, (0, 0, 0)), ("back", 0, (0, 0, -0.02)), ("loin", 1, (0, 0, -0.16)),
              ("stem", 2, (0, 0, -0.15)), ("tail", 3, (0, 0, -0.13)),
              ("left", 0, (0.17, -0.06, 0.12)), ("right", 0, (-0.17, -0.06, 0.12))]
    ends = [-0.02, -0.18, -0.33, -0.46]

    def bone(z):
        if z >= ends[0] + 0.06:
            return (0, 0, 0.0)
        for joint, end in reversed(list(enumerate(ends, 1))):
            if z <= end + 0.06:
                return (joint - 1, joint, min(max((end + 0.06 - z) / 0.12, 0.0), 1.0))
        return (0, 0, 0.0)

    # Half widths and half heights from tail to nose.
    shape = [(-0.50, 0.012, 0.03), (-0.42, 0.03, 0.05), (-0.30, 0.075, 0.10), (-0.14, 0.145, 0.185),
             (0.02, 0.20, 0.25), (0.16, 0.215, 0.26), (0.28, 0.19, 0.22), (0.36, 0.13, 0.15),
             (0.41, 0.06, 0.07), (0.425, 0.0, 0.0)]

    def along(t):
        place = t * (len(shape) - 1)
        i = min(int(place), len(shape) - 2)
        p = [shape[min(max(i + k, 0), len(shape) - 1)] for k in (-1, 0, 1, 2)]
        u = place - i
        return [0.5 * (2 * b + (c - a) * u + (2 * a - 5 * b + 4 * c - d) * u * u
                       + (3 * b - a - 3 * c + d) * u**3) for a, b, c, d in zip(*p)]

    def skin(t, angle):
        z, wide, high = along(t) if 0.0 < t < 1.0 else shape[0 if t == 0.0 else -1]
        if t == 0.0:
            wide = high = 0.0
        belly = -0.03 * math.sin(math.pi * t)
        return (wide * math.cos(angle), belly + high * math.sin(angle), z)

    body.loft(30, 24, skin, lambda t: bone(along(t)[0]))
    # The tail: two lobes that are thin at their rims.
    for up in (1, -1):
        turn = quaternion(X, up * -0.62)
        def lobe(t, angle, turn=turn):
            reach = 0.34 * t
            width = 0.105 * math.sin(math.pi * min(t * 0.92 + 0.08, 1.0)) ** 0.8
            point = (0.012 * math.cos(angle), width * math.sin(angle), -reach)
            x, y, z = turned(turn, point)
            return (x, y, z - 0.46)
        fin.loft(10, 12, lobe, lambda t: (4, 4, 0.0))
    # The fin on its back, swept.
    def crest(t, angle):
        z = 0.16 - 0.40 * t
        high = 0.17 * math.sin(math.pi * t ** 0.75) ** 0.9 if 0.0 < t < 1.0 else 0.0
        base = 0.20 - 0.28 * max(t - 0.45, 0.0)
        rise = 0.5 + 0.5 * math.sin(angle)
        return (0.016 * math.cos(angle) * math.sin(math.pi * t), base + high * rise,
                z - 0.14 * high / 0.17 * rise)
    fin.loft(14, 10, crest, lambda t: bone(0.16 - 0.40 * t))
    for side, joint in ((1, 5), (-1, 6)):
        turn = times(quaternion(Z, side * -0.5), quaternion(Y, side * -0.75))
        def wing(t, angle, side=side, turn=turn):
            wide = 0.085 * math.sin(math.pi * min(0.15 + 0.85 * t, 1.0)) ** 0.7
            point = (side * 0.27 * t, 0.010 * math.sin(angle), -0.05 * t + wide * math.cos(angle))
            x, y, z = turned(turn, point)
            return (side * 0.17 + x, -0.06 + y, 0.12 + z)
        fin.loft(8, 12, (lambda t, angle, w=wing: w(t, side_sign(side) * angle)),
                 lambda t, joint=joint: (joint, joint, 0.0))
        eye.ball((side * 0.155, 0.07, 0.245), (0.068, 0.075, 0.068), 10, 14, 0)
        pupil.ball((side * 0.198, 0.075, 0.27), (0.034, 0.046, 0.04), 8, 10, 0)
    # The rod of the lantern, and the lantern.
    def rod(t, angle):
        bend = math.pi * 0.62 * t
        y = 0.16 + 0.23 * math.sin(bend) * 1.15
        z = 0.24 + 0.36 * t
        thin = 0.017 - 0.006 * t
        return (thin * math.cos(angle), y + thin * math.sin(angle) * 0.4,
                z + thin * math.sin(angle))
    fin.loft(12, 8, lambda t, angle: rod(t, -angle), lambda t: (0, 0, 0.0))
    bulb.ball((BULB[0], BULB[1] + 0.02, BULB[2]), (0.085, 0.105, 0.085), 14, 18, 0)

    moves = {(0, "translation"): [], (0, "rotation"): []}
    for joint in range(1, 7):
        moves[joint, "rotation"] = []
    phase = 0.0
    for frame in POSES:
        here, then = swim(frame), swim(frame + 2)
        speed = math.dist(here, then) / 2.0
        phase += 0.42 + 5.0 * speed
        force = 0.10 + 2.4 * min(speed, 0.12)
        moves[0, "translation"].append(here)
        moves[0, "rotation"].append(fish_turn(frame))
        for joint in range(1, 5):
            swing = force * (0.45 + 0.35 * joint) * math.sin(phase - 0.75 * joint)
            moves[joint, "rotation"].append(quaternion(Y, swing))
        for side, joint in ((1, 5), (-1, 6)):
            flap = 0.35 + 0.5 * math.sin(0.8 * phase)
            moves[joint, "rotation"].append(quaternion(Z, side * flap))
    parts = [body, fin, eye, pupil, bulb]
    for part in parts:
        part.points = [tuple(round(SIZE * x, 6) for x in point) for point in part.points]
    joints = [(name, parent, tuple(SIZE * x for x in place)) for name, parent, place in joints]
    rows = [(joint, path, rows) for (joint, path), rows in moves.items()]
    return parts, joints, rows


def side_sign(side):
    """Lofts of the right side go around the other way, so that they face outward too."""
    return -1.0 if side > 0 else 1.0


# ------------------------------------------------------------------------------ Hob, the mushroom

HOB_STANDS = (-0.42, 0.0, 0.0)


def hob():
    skin, cap, gills, eye, glint = (Part(n) for n in ("skin", "cap", "gills", "eye", "glint"))
    # Joints: 0 all of it, 1 the body, 2 the cap, 3 and 4 the feet, 5 and 6 the arms, 7 the eyes.
    joints = [("hob", None, (0, 0, 0)), ("body", 0, (0, 0.20, 0)), ("cap", 1, (0, 0.62, 0)),
              ("left foot", 0, (0.13, 0.24, 0)), ("right foot", 0, (-0.13, 0.24, 0)),
              ("left arm", 1, (0.25, 0.30, 0.03)), ("right arm", 1, (-0.25, 0.30, 0.03)),
              ("eyes", 1, (0, 0.42, 0.2))]
    stem = smooth_profile([(0.0, 0.145), (0.17, 0.16), (0.265, 0.26), (0.285, 0.38), (0.255, 0.52),
                           (0.222, 0.66), (0.215, 0.80), (0.20, 0.92), (0.0, 0.97)], 4)

    def stem_bone(t):
        y = stem[round(t * (len(stem) - 1))][1]
        share = ease(y, 0.66, 0.92)
        return (1, 2, share)

    skin.lathe(stem, 28, stem_bone)
    # A wide hat with a rolled brim, a little crooked.
    lean = lambda y: (0.05 * ease(y, 1.0, 1.5), -0.07 * ease(y, 0.95, 1.5))
    under = smooth_profile([(0.0, 0.905), (0.22, 0.885), (0.42, 0.83), (0.60, 0.775),
                            (0.665, 0.755)], 4)
    gills.lathe(under, 36, lambda t: (2, 2, 0.0), lean)
    over = smooth_profile([(0.665, 0.755), (0.70, 0.775), (0.695, 0.835), (0.63, 0.96),
                           (0.50, 1.11), (0.35, 1.25), (0.20, 1.38), (0.09, 1.475),
                           (0.0, 1.51)], 4)
    cap.lathe(over, 36, lambda t: (2, 2, 0.0), lean)
    for side, foot, arm in ((1, 3, 5), (-1, 4, 6)):
        skin.ball((side * 0.13, 0.075, 0.06), (0.115, 0.078, 0.165), 10, 16, foot)
        skin.ball((side * 0.13, 0.17, 0.0), (0.075, 0.12, 0.075), 8, 12, foot)
        skin.ball((side * 0.345, 0.425, 0.06), (0.058, 0.135, 0.058), 10, 12, arm,
                  quaternion(Z, side * 0.75))
        eye.ball((side * 0.098, 0.605, 0.225), (0.040, 0.062, 0.030), 10, 14, 7,
                 quaternion(Y, side * 0.32))
        glint.ball((side * 0.098 + 0.014, 0.632, 0.2515), (0.013, 0.016, 0.010), 6, 8, 7)
    moves = {}
    for frame in POSES:
        pose = hob_pose(frame)
        for key, value in pose.items():
            moves.setdefault(key, []).append(value)
    rows = [(joint, path, rows) for (joint, path), rows in moves.items()]
    return [skin, cap, gills, eye, glint], joints, rows


def hob_pose(frame):
    """A pose: values by joint and path."""
    step_phase = 2.0 * math.pi * (frame - 1) / 16.0
    walks = 1.0 - ease(frame, 29, 37)
    steady = min((frame - 1) / 36.0, 1.0)
    x = mix(-2.35, HOB_STANDS[0], mix(steady, 1.0, ease(frame, 26, 37)))
    place = (x, 0.035 * walks * abs(math.sin(step_phase)), 0.16 - 0.16 * ease(frame, 1, 37))
    # It crouches when the light comes around the trees, hops as it passes, and follows it.
    fright = ease(frame, 34, 39) - ease(frame, 44, 47)
    hop = math.sin(math.pi * ease(frame, 45, 57))
    land = ease(frame, 56, 58) - ease(frame, 59, 66)
    place = (place[0] - 0.06 * ease(frame, 45, 57), place[1] + 0.42 * hop, place[2])
    squash = 1.0 - 0.20 * fright + 0.13 * hop - 0.14 * land
    wide = 1.0 / math.sqrt(squash)
    light = bulb_at(frame)
    toward = math.atan2(light[0] - place[0], light[2] - place[2])
    height = math.atan2(light[1] - 0.75, math.hypot(light[0] - place[0], light[2] - place[2]))
    behind = toward > 2.2 or toward < -1.9
    # When the light is behind, Hob looks for it on the side where it will come again.
    wanted = max(min(toward, 1.15), -0.95)
    if frame > 56 and behind:
        wanted = mix(-0.95, 1.15, ease(frame, 62, 74))
    sees = ease(frame, 28, 40)
    yaw = mix(1.35, 0.62 * wanted, sees)
    tilt = sees * max(min(height, 0.75), -0.2)
    sway = walks * 0.10 * math.sin(step_phase)
    calm = ease(frame, 78, 86)
    breath = 0.02 * math.sin(2.0 * math.pi * frame / 24.0)
    arms = 0.25 + 0.9 * (ease(frame, 42, 49) - 0.45 * ease(frame, 60, 70)) + 0.35 * calm
    lean = 0.13 * walks - 0.20 * fright - 0.16 * sees * max(tilt, 0.0)
    body = times(quaternion(Y, 0.38 * wanted * sees),
                 times(quaternion(X, lean), quaternion(Z, sway)))
    late = hob_lag(frame)
    cap = times(quaternion(X, -0.28 * tilt - 0.05 * walks + late),
                quaternion(Z, -0.8 * sway + 0.05 * math.sin(0.5 * step_phase) * walks))
    pose = {(0, "translation"): place, (0, "rotation"): quaternion(Y, yaw),
            (1, "rotation"): body, (1, "scale"): (wide, squash + breath, wide),
            (2, "rotation"): cap,
            (2, "scale"): (1.0 + 0.05 * fright, 1.0 - 0.06 * fright + 0.05 * hop,
                           1.0 + 0.05 * fright)}
    for side, foot, arm in ((1, 3, 5), (-1, 4, 6)):
        swing = 0.62 * walks * math.sin(step_phase) * side
        pose[foot, "rotation"] = quaternion(X, -swing + 0.5 * hop)
        lift = max(math.cos(step_phase) * side, 0.0) * 0.07 * walks
        pose[foot, "translation"] = (0.13 * side, 0.24 + lift, 0.0)
        wave = 0.16 * math.sin(2.0 * math.pi * frame / 12.0 + side) * calm
        pose[arm, "rotation"] = times(quaternion(X, swing * 0.8 - 0.35 * sees),
                                      quaternion(Z, side * (arms * sees + 0.12 + wave)))
    blink = 0.12 if 27 <= frame < 29 or 75 <= frame < 77 else 1.0
    wonder = 1.0 + 0.22 * (ease(frame, 36, 42) - 0.5 * ease(frame, 68, 82))
    pose[7, "scale"] = (wonder, wonder * blink, 1.0)
    return pose


def hob_lag(frame):
    """The cap comes after the body: up when it falls, down when it rises."""
    high = lambda f: math.sin(math.pi * ease(f, 45, 57))
    return 0.55 * (high(frame) - high(frame - 3)) * 0.5


# ----------------------------------------------------------------------------------- the meadow

def height(x, z):
    """Height of the ground: flat where Hob walks, with hills behind."""
    hills = 2.0 * math.exp(-(((x + 5.2) / 3.2) ** 2 + ((z + 7.2) / 2.6) ** 2))
    hills += 1.5 * math.exp(-(((x - 4.6) / 2.6) ** 2 + ((z + 6.0) / 2.0) ** 2))
    hills += 0.9 * math.exp(-(((x - 0.4) / 3.0) ** 2 + ((z + 9.5) / 2.2) ** 2))
    mounds = 0.07 * math.sin(1.3 * x + 0.6) * math.sin(1.1 * z) + 0.05 * math.sin(2.3 * x - z)
    far = min(max((math.hypot(x * 0.55, z - 0.2) - 1.2) / 2.0, 0.0), 1.0)
    return hills + mounds * far - 0.02 * far


def meadow():
    ground, stone, tree = (Part(n) for n in ("ground", "stone", "tree"))
    wide, deep = 60, 52
    for row in range(deep + 1):
        for column in range(wide + 1):
            u, v = column / wide, row / deep
            x, z = -11.0 + 22.0 * u, 4.0 - 15.0 * v
            ground.points.append(tuple(round(a, 4) for a in (x, height(x, z), z)))
            ground.uvs.append((u, v))
            ground.bones.append((0, 0, 0.0))
    for row in range(deep):
        for column in range(wide):
            a = row * (wide + 1) + column
            b, c, d = a + 1, a + wide + 2, a + wide + 1
            ground.triangles += [(a, b, c), (a, c, d)]

    def rough(seed):
        return lambda n: 1.0 + 0.10 * math.sin(4.1 * n[0] + seed) * math.sin(3.7 * n[1] + 2 * seed) \
            + 0.08 * math.sin(5.3 * n[2] + 3 * seed)

    for seed, (x, z, r, tall) in enumerate([(1.95, -0.95, 0.34, 0.9), (2.42, -0.55, 0.20, 0.7),
                                            (-1.55, -1.75, 0.26, 0.8), (-3.6, -1.6, 0.22, 0.7),
                                            (0.75, -2.6, 0.30, 1.0)]):
        stone.ball((x, height(x, z) + 0.35 * r * tall, z), (r, r * tall, r * 0.9), 10, 14, 0,
                   quaternion(Y, 1.7 * seed), rough(seed))
    # Trees: a trunk and a crown like a flame, or like a cloud.
    for x, z, size, flame in [(-3.3, -3.4, 1.5, 1), (-4.3, -4.3, 1.9, 1), (-2.6, -5.0, 1.15, 1),
                              (3.35, -3.2, 1.55, 0), (4.5, -4.1, 1.9, 1), (2.7, -4.6, 1.1, 1),
                              (5.4, -3.0, 1.6, 0), (-5.8, -3.6, 1.6, 0), (-0.6, -6.6, 0.9, 1)]:
        y = height(x, z) - 0.05
        trunk = [(0.0, y), (0.09 * size, y), (0.05 * size, y + 0.35 * size),
                 (0.04 * size, y + 0.7 * size), (0.0, y + 0.72 * size)]
        tree.lathe(trunk, 7, lambda t: (0, 0, 0.0), lambda _, x=x, z=z: (x, z))
        crown = [(0.0, 0.34), (0.20, 0.40), (0.335, 0.62), (0.31, 0.92), (0.21, 1.28),
                 (0.10, 1.62), (0.0, 1.86)]
        if not flame:
            crown = [(0.0, 0.42), (0.30, 0.48), (0.46, 0.74), (0.44, 1.02), (0.29, 1.24),
                     (0.12, 1.33), (0.0, 1.35)]
        crown = [(r * size, y + h * size) for r, h in smooth_profile(crown, 2)]
        tree.lathe(crown, 14, lambda t: (0, 0, 0.0),
                   lambda h, x=x, z=z, y=y, s=size: (x + 0.05 * s * math.sin(3 * (h - y) / s), z))
    return [ground, stone, tree]


folder = sys.argv[1]
File().write(os.path.join(folder, "glim.glb"), "glim", *fish())
File().write(os.path.join(folder, "hob.glb"), "hob", *hob())
File().write(os.path.join(folder, "meadow.glb"), "meadow", meadow(), [], [])
for frame in POSES:
    place = ", ".join(f"{x:.3f}" for x in bulb_at(frame))
    print(f'      {{ "frame": {frame}, "value": [{place}] }},')
