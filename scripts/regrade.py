#!/usr/bin/env python3
"""Grades the lights of rendered frames anew, from their EXR files alone.

    scripts/regrade.py 'out/####.exr' -o 'graded/####.exr' --frames 1-96 \\
        --light sun=0.2 --light lantern=0.8,1.1,0.6 --on hob moon=1.5

The frames have a layer for each light (`chiaro render ... --aov lights`), and for `--on` mattes of
objects (`--matte objects`). What the lights add is multiplied and summed, and the sum decoded as
the header says; nothing is drawn. `--against` names frames that were rendered with that grade, and
tells how far they are away; `--within` (of 1, where white is) makes that a test.

An object's own grade goes by its matte. Where two objects share a pixel the file holds what both
add together, so that the matte's edge is a mean of both: it is told apart from the rest.
"""
import argparse
import json
import os
import re
import struct
import sys

import numpy as np
import OpenImageIO as oiio


def channels(path):
    """Channels of a file by name, and what its header says."""
    file = oiio.ImageInput.open(path)
    if file is None:
        raise SystemExit(f"{path}: {oiio.geterror()}")
    spec = file.spec()
    pixels = np.asarray(file.read_image("float")).reshape(spec.height, spec.width, -1)
    header = {entry.name: entry.value for entry in spec.extra_attribs}
    file.close()
    return {name: pixels[..., at] for at, name in enumerate(spec.channelnames)}, header


def color(layers, name):
    return np.stack([layers[f"{name}.{channel}"] for channel in "RGB"], axis=-1)


def decode(shown):
    """Light of display numbers, by the curve of sRGB."""
    low = shown <= 0.04045
    return np.where(low, shown / 12.92, ((np.where(low, 1.0, shown) + 0.055) / 1.055) ** 2.4)


def encode(light):
    low = light <= 0.0031308
    return np.where(low, light * 12.92, 1.055 * np.where(low, 1.0, light) ** (1.0 / 2.4) - 0.055)


def matte(layers, header, name):
    """Coverage of an object, by Cryptomatte."""
    manifest = {}
    for key, value in header.items():
        if re.fullmatch(r"cryptomatte/\w+/manifest", key):
            manifest.update(json.loads(value))
    if name not in manifest:
        raise SystemExit(f"no matte of `{name}`: there are {', '.join(sorted(manifest)) or 'none'}")
    wanted = struct.unpack("<f", struct.pack("<I", int(manifest[name], 16)))[0]
    coverage = 0.0
    for layer in ("CryptoObject00", "CryptoObject01", "CryptoObject02"):
        for ids, shares in ("RG", "BA"):
            coverage = coverage + np.where(layers[f"{layer}.{ids}"] == np.float32(wanted),
                                           layers[f"{layer}.{shares}"], 0.0)
    return coverage


def regrade(layers, header, lights, own):
    """The graded picture, premultiplied and linear, and where mattes have edges."""
    told = header.get("chiaro", "")
    if "layersIn=" not in told:
        raise SystemExit("no layers of lights: render with --aov lights")
    display = "layersIn=display" in told
    names = {name.split(".")[0] for name in layers if name.startswith("light_")}
    for name in list(lights) + [light for _, light in own]:
        if f"light_{name}" not in names:
            raise SystemExit(f"no layer of `{name}`: there are {', '.join(sorted(names))}")
    total, edges = 0.0, np.zeros(layers["A"].shape, bool)
    for name in sorted(names):
        added = color(layers, name).astype(np.float64) * lights.get(name[6:], np.ones(3))
        for (thing, light), gain in own.items():
            if light == name[6:]:
                cover = matte(layers, header, thing)
                added = added * (1.0 + (gain - 1.0) * cover[..., None])
                edges |= (cover > 0.0) & (cover < 1.0)
        total = total + added
    alpha = layers["A"].astype(np.float64)[..., None]
    if display:
        straight = np.divide(total, alpha, out=np.zeros_like(total), where=alpha > 0)
        total = decode(straight) * alpha
    return np.concatenate([total, alpha], axis=-1), edges


def gains(text):
    name, _, value = text.partition("=")
    values = [float(part) for part in value.split(",")]
    if len(values) not in (1, 3):
        raise SystemExit(f"{text}: a light takes one number or three")
    return name, np.array(values * (1 if len(values) == 3 else 3))


def named(pattern, frame):
    return re.sub("#+", lambda digits: str(frame).zfill(len(digits.group())), pattern)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("frames_of", metavar="FILE")
    parser.add_argument("-o", "--output", metavar="FILE")
    parser.add_argument("--frames", default="0-0", metavar="A-B")
    parser.add_argument("--light", action="append", default=[], metavar="NAME=GAIN")
    parser.add_argument("--on", action="append", default=[], nargs=2, metavar=("OBJECT", "NAME=GAIN"))
    parser.add_argument("--against", metavar="FILE")
    parser.add_argument("--within", type=float)
    options = parser.parse_args()
    lights = dict(gains(text) for text in options.light)
    own = {(thing, gains(text)[0]): gains(text)[1] for thing, text in options.on}
    first, _, last = options.frames.partition("-")
    worst, worst_edge, count = (0.0, None), 0.0, 0
    for frame in range(int(first), int(last or first) + 1):
        layers, header = channels(named(options.frames_of, frame))
        graded, edges = regrade(layers, header, lights, own)
        count += 1
        if options.output:
            height, width, _ = graded.shape
            out = oiio.ImageOutput.create(named(options.output, frame))
            spec = oiio.ImageSpec(width, height, 4, "half")
            spec.attribute("oiio:ColorSpace", "lin_rec709")
            out.open(named(options.output, frame), spec)
            out.write_image(graded.astype(np.float32))
            out.close()
        if options.against:
            other, _ = channels(named(options.against, frame))
            other = np.stack([other[channel] for channel in "RGBA"], axis=-1).astype(np.float64)
            apart = np.abs(encode(graded) - encode(other)).max(axis=-1)
            worst = max(worst, (float(apart[~edges].max()), frame), key=lambda pair: pair[0])
            worst_edge = max(worst_edge, float(apart[edges].max()) if edges.any() else 0.0)
    if options.against:
        said = {"frames": count, "greatest": worst[0], "in_frame": worst[1],
                "greatest_on_edges_of_mattes": worst_edge}
        print(json.dumps(said))
        if options.within is not None and worst[0] > options.within:
            print(f"frame {worst[1]} is {worst[0]:.6f} away, more than {options.within}",
                  file=sys.stderr)
            return 1
    else:
        print(f"{count} frame{'s' if count != 1 else ''} graded")
    return 0


if __name__ == "__main__":
    sys.exit(main())
