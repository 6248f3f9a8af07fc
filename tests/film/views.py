# Shows colors by OpenColorIO and prints the greatest difference to what was shown, of 1 or of the
# number where it is greater: views.py CONFIG FOLDER DISPLAY/VIEW...
import sys

import numpy
import PyOpenColorIO as ocio

config = ocio.Config.CreateFromFile(sys.argv[1])
folder, names = sys.argv[2], sys.argv[3:]


def colors(name):
    return numpy.fromfile(f"{folder}/{name}", numpy.float32).reshape(-1, 3)


shown = colors("shown").astype(numpy.float64)
size = numpy.abs(shown)
light = numpy.where(size <= 0.04045, size / 12.92, ((size + 0.055) / 1.055) ** 2.4)
light = numpy.copysign(light, shown).astype(numpy.float32)
worst = 0.0
for at, name in enumerate(names):
    display, view = name.split("/", 1)
    processor = config.getProcessor(
        "lin_rec709_scene", display, view, ocio.TRANSFORM_DIR_FORWARD
    ).getDefaultCPUProcessor()
    wanted = light.copy()
    processor.applyRGB(wanted)
    made = colors(at)
    if not numpy.isfinite(made).all():
        raise SystemExit(f"{name}: not finite")
    apart = numpy.abs(made - wanted) / numpy.maximum(1.0, numpy.abs(wanted))
    worst = max(worst, float(apart.max()))
print(worst)
