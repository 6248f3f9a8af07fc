# Reads a file of layers by OpenImageIO, and its mattes by cryptomatte-api; says what it found.
import json
import sys

import cryptomatte_api
import numpy
import OpenImageIO as oiio

path = sys.argv[1]
picture = oiio.ImageInput.open(path)
names = list(picture.spec().channelnames)
pixels = picture.read_image("float")
picture.close()


def channel(name):
    return pixels[:, :, names.index(name)]


layers = sorted({name.rsplit(".", 1)[0] for name in names if name.startswith("layer_")})
whole = numpy.stack([channel("beauty." + c) for c in "RGB"])
parts = sum(numpy.stack([channel(f"{layer}.{c}") for c in "RGB"]) for layer in layers)

(matte,) = cryptomatte_api.Cryptomatte.load(path)
masks = matte.masks()
covered = sum(numpy.asarray(mask) for mask in masks.values())
print(
    json.dumps(
        {
            "names": sorted(masks),
            "coverage": float(abs(covered - channel("A")).max()),
            "sum": float(abs(parts - whole).max()),
            "layers": layers,
        }
    )
)
