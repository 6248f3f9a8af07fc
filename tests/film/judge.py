# Reads files of layers by OpenImageIO and their mattes by cryptomatte-api: judge.py FILE... Prints
# a list of what each file has:
#   mattes    names in each matte that some pixel is covered by
#   coverage  greatest difference of a matte's coverages, summed, from alpha; black samples are of
#             no light, so that lights may cover less, but nothing where a color is
#   sums      for each kind of contributions how many there are, the greatest difference of their
#             sum from the picture, in half-steps for each, and the least number of all of them
import json
import sys

import cryptomatte_api
import numpy
import OpenImageIO as oiio
from OpenImageIO import ImageBufAlgo as algo

KINDS = ("layer_", "light_", "group_")
# A step of a half at 1, and the least number whose steps are told apart.
STEP, LEAST = 2.0**-11, 0.25


def contributions(file, names, kind):
    """The sum of the layers of a kind against the picture."""

    def colors(layer):
        return algo.channels(file, tuple(f"{layer}.{c}" for c in "RGB"))

    layers = sorted({name.rsplit(".", 1)[0] for name in names if name.startswith(kind)})
    if not layers:
        return None
    whole = colors("beauty" if "beauty.R" in names else "beauty_stack")
    parts = [colors(layer) for layer in layers]
    total = parts[0]
    for part in parts[1:]:
        total = algo.add(total, part)
    size = algo.max(algo.abs(whole), LEAST)
    steps = algo.div(algo.absdiff(total, whole), algo.mul(size, STEP * (len(parts) + 1)))
    for picture in [*parts, steps]:
        if picture.has_error:
            raise SystemExit(picture.geterror())
    return {
        "layers": len(layers),
        "steps": max(algo.computePixelStats(steps).max),
        "least": min(min(algo.computePixelStats(part).min) for part in parts),
    }


def judge(path):
    picture = oiio.ImageInput.open(path)
    if picture is None:
        raise SystemExit(f"{path}: {oiio.geterror()}")
    said, pixels = picture.spec(), picture.read_image("float")
    names = list(said.channelnames)
    # One type for all channels: arithmetic takes a file of halves and floats for one of halves.
    spec = oiio.ImageSpec(said.width, said.height, len(names), "float")
    spec.channelnames = names
    file = oiio.ImageBuf(spec)
    file.set_pixels(oiio.ROI.All, pixels)
    alpha = pixels[:, :, names.index("A")]
    found = {"mattes": {}, "coverage": 0.0}
    if any(name.startswith("Crypto") for name in names):
        for matte in cryptomatte_api.Cryptomatte.load(path):
            masks = matte.masks()
            seen = sorted(name for name, mask in masks.items() if mask.max() > 0.0)
            found["mattes"][matte.metadata().name()] = seen
            covered = sum(masks.values())
            if matte.metadata().name() == "CryptoLight":
                lost = numpy.where(covered > 0.0, 0.0, abs(pixels[:, :, :3]).max(axis=2))
                off = numpy.maximum(covered - alpha, lost)
            else:
                off = abs(covered - alpha)
            found["coverage"] = max(found["coverage"], float(off.max()))
    sums = {kind: contributions(file, names, kind) for kind in KINDS}
    found["sums"] = {kind: sum for kind, sum in sums.items() if sum}
    return found


print(json.dumps([judge(path) for path in sys.argv[1:]]))
