#!/usr/bin/env python3
"""Grades the lights of rendered frames anew, from their EXR files alone.

    scripts/regrade.py 'out/####.exr' -o 'graded/####.exr' --frames 1-96 \\
        --light sun=0.2 --light lantern=0.8,1.1,0.6 --on hob moon=1.5

The frames have a layer for each light (`chiaro render ... --aov lights`), and for `--on` mattes of
objects (`--matte objects`). What the lights add is multiplied and summed, and the sum decoded as
the header says; nothing is drawn. `--against` names frames that were rendered with that grade, and
tells how far they are away; `--within` (of 1, where white is) makes that a test. `--frames` is
written as for `chiaro render`; without it all frames that are there are graded.

Lights are graded alone: a picture of which they are not the whole, such as one with a backdrop or
outlines over it, is refused (`chiaro comp` writes compositions that keep the rest). Graded files
have the picture, with the time code, the camera and the mattes of the file that they come from, and
no layers of lights.

An object's own grade goes by its matte. Where two objects share a pixel the file holds what both
add together, so that the matte's edge is a mean of both: it is told apart from the rest.
"""
import argparse
import glob
import json
import os
import re
import struct
import sys

import numpy as np
import OpenImageIO as oiio

# Greatest difference of the lights' sum from the picture, where white is 1: a step of a screen.
WHOLE = 1.0 / 255.0


def channels(path):
    """Channels of a file by name, and what its header says."""
    file = oiio.ImageInput.open(path)
    if file is None:
        raise SystemExit(f"{path}: {oiio.geterror()}")
    spec = oiio.ImageSpec(file.spec())
    pixels = np.asarray(file.read_image("float")).reshape(spec.height, spec.width, -1)
    header = {entry.name: entry.value for entry in spec.extra_attribs}
    file.close()
    return {name: pixels[..., at] for at, name in enumerate(spec.channelnames)}, header, spec


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
    alpha = layers["A"].astype(np.float64)[..., None]

    def light_of(total):
        if not display:
            return total
        straight = np.divide(total, alpha, out=np.zeros_like(total), where=alpha > 0)
        return decode(straight) * alpha

    total, whole, edges = 0.0, 0.0, np.zeros(layers["A"].shape, bool)
    for name in sorted(names):
        own_light = color(layers, name).astype(np.float64)
        whole = whole + own_light
        added = own_light * lights.get(name[6:], np.ones(3))
        for (thing, light), gain in own.items():
            if light == name[6:]:
                cover = matte(layers, header, thing)
                added = added * (1.0 + (gain - 1.0) * cover[..., None])
                edges |= (cover > 0.0) & (cover < 1.0)
        total = total + added
    picture = np.stack([layers[channel] for channel in "RGB"], axis=-1).astype(np.float64)
    rest = np.abs(encode(light_of(whole)) - encode(picture)).max()
    if not rest <= WHOLE:
        raise SystemExit(
            f"the lights are not the whole picture: {rest:.4f} of it is a backdrop, an outline or "
            "another rest, which this script would lose; chiaro comp keeps it")
    return np.concatenate([light_of(total), alpha], axis=-1), edges


def gains(text):
    name, _, value = text.partition("=")
    try:
        values = [float(part) for part in value.split(",")]
    except ValueError:
        values = []
    if len(values) not in (1, 3):
        raise SystemExit(f"{text}: a light takes one number or three, as key=0.5 or key=1,0.9,0.8")
    return name, np.array(values * (1 if len(values) == 3 else 3))


def named(pattern, frame):
    return re.sub("#+", lambda digits: str(frame).zfill(len(digits.group())), pattern)


def listed(text):
    """Frames of a list such as `1-96`, `1-96x2` or `1-48,60`."""
    frames = []
    for part in text.split(","):
        found = re.fullmatch(r"(-?\d+)(?:-(-?\d+))?(?:x(\d+))?", part.strip())
        first, last, step = (int(number or 0) for number in found.groups()) if found else (0, 0, 0)
        if found and found[2] is None:
            last = first
        if found and found[3] is None:
            step = 1
        if not found or last < first or step < 1:
            raise SystemExit(f"--frames {text}: write 1-96, every second one as 1-96x2, or 1-48,60")
        frames += range(first, last + 1, step)
    return frames


def there(pattern):
    """Frames that are there, by the numbers in their names."""
    if "#" not in pattern:
        return [0]
    before, after = re.split("#+", pattern, maxsplit=1)
    found = glob.glob(f"{glob.escape(before)}*{glob.escape(after)}")
    numbers = (name[len(before):len(name) - len(after)] for name in found)
    return sorted(int(number) for number in numbers if re.fullmatch(r"-?\d+", number))


# What a graded file does not say: the numbers under the first name's seal are no longer there, and
# tables belong to layers that are left out.
OUT_OF_DATE = re.compile(r"chiaro($|/)|openexr:chunkCount$")


def write(path, picture, layers, come_from):
    """Writes a picture with what its file says of time, camera and mattes, or ends with the
    reason."""
    height, width, _ = picture.shape
    out = oiio.ImageOutput.create(path)
    mattes = [name for name in come_from.channelnames if re.match(r"Crypto\w+\.[RGBA]$", name)]
    # Names in mattes are 32 bits that no half holds: each channel stays of the type that it has.
    half = oiio.TypeDesc("half")
    formats = [come_from.channelformat(come_from.channelnames.index(name)) for name in mattes]
    spec = oiio.ImageSpec(width, height, 4 + len(mattes), "float")
    spec.channelnames = ["R", "G", "B", "A", *mattes]
    spec.channelformats = (half, half, half, half, *formats)
    for side in ("x", "y", "full_x", "full_y", "full_width", "full_height"):
        setattr(spec, side, getattr(come_from, side))
    for entry in come_from.extra_attribs:
        if not OUT_OF_DATE.match(entry.name):
            spec.attribute(entry.name, entry.type, entry.value)
    spec.attribute("oiio:ColorSpace", "lin_rec709")
    pixels = [picture.astype(np.float32)] + [layers[name][..., None] for name in mattes]
    pixels = np.ascontiguousarray(np.concatenate(pixels, axis=-1, dtype=np.float32))
    is_written = out and out.open(path, spec) and out.write_image(pixels)
    if not (is_written and out.close()):
        why = (out.geterror() if out else oiio.geterror()) or "the reason is not known"
        raise SystemExit(f"{path} cannot be written: {why}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("frames_of", metavar="FILE")
    parser.add_argument("-o", "--output", metavar="FILE")
    parser.add_argument("--frames", metavar="A-B")
    parser.add_argument("--light", action="append", default=[], metavar="NAME=GAIN")
    parser.add_argument("--on", action="append", default=[], nargs=2, metavar=("OBJECT", "NAME=GAIN"))
    parser.add_argument("--against", metavar="FILE")
    parser.add_argument("--within", type=float)
    options = parser.parse_args()
    if not (options.output or options.against):
        parser.error("say what to do: -o FILE writes, --against FILE compares")
    if options.within is not None and not options.against:
        parser.error("--within goes with --against")
    frames = listed(options.frames) if options.frames else there(options.frames_of)
    if not frames:
        parser.error(f"there are no frames {options.frames_of}")
    lights = dict(gains(text) for text in options.light)
    own = {(thing, gains(text)[0]): gains(text)[1] for thing, text in options.on}
    worst, worst_edge, count = (0.0, None), 0.0, 0
    for frame in frames:
        layers, header, spec = channels(named(options.frames_of, frame))
        graded, edges = regrade(layers, header, lights, own)
        count += 1
        if options.output:
            write(named(options.output, frame), graded, layers, spec)
        if options.against:
            other, _, _ = channels(named(options.against, frame))
            other = np.stack([other[channel] for channel in "RGBA"], axis=-1).astype(np.float64)
            apart = np.abs(encode(graded) - encode(other)).max(axis=-1)
            inside = float(apart[~edges].max()) if not edges.all() else 0.0
            worst = max(worst, (inside, frame), key=lambda pair: pair[0])
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
