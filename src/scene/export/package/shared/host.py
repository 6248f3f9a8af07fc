# Takes what is set from outside, or what the look has where nothing is set.


# A number, or the first of several.
def number_of(given, own):
    if given is None:
        return own
    value = float(given if isinstance(given, (bool, int, float)) else list(given)[0])
    return value if math.isfinite(value) else own


def whole_of(given, own):
    return int(number_of(given, own))


def truth_of(given, own):
    return own if given is None else bool(given)


# A vector. A number fills it; a color of three numbers is opaque.
def vector_of(given, own, is_color=False):
    if given is None:
        return own
    if isinstance(given, (bool, int, float)):
        filled = [number_of(given, 0.0)] * len(own)
        return filled[:3] + [1.0] * (len(own) - 3) if is_color else filled
    numbers = list(given)
    if is_color and len(own) == 4 and len(numbers) == 3:
        numbers.append(1.0)
    return [number_of(x, y) for x, y in zip(numbers + own[len(numbers):], own)]


# Columns of three numbers, from nine in a row.
def matrix_of(given):
    m = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0] if given is None else list(given)
    return [m[0:3], m[3:6], m[6:9]]


# A light: what later ones of `given` set, and what the look has.
def light_of(own, *given):
    values = {}
    for one in given:
        values.update((key, value) for key, value in one.items() if value is not None)
    place = values.get("aimed_at_place")
    light = {
        key: vector_of(values.get(key), [float(x) for x in own[key]])
        for key in ("direction", "position", "aim", "color")
    }
    for key in ("intensity", "inner", "outer", "half_distance", "range"):
        light[key] = number_of(values.get(key), float(own[key]))
    light["aimed_at"] = [*place, 1.0] if place else [0.0, 0.0, 0.0, 0.0]
    light["shadow_map"] = vector_of(values.get("shadow_map"), [0.0, 0.0, 1.0, -1.0])
    return light


# What surrounds the object, of a state.
def surroundings_of(state):
    camera, thing = state.get("camera", {}), state.get("object", {})
    around = {
        "illumination": matrix_of(state.get("illumination")),
        "camera_from_world": matrix_of(camera.get("rotation")),
        "eye": vector_of(camera.get("eye"), [0.0, 0.0, 1.0]),
        "parallel": [0.0, 0.0, 0.0],
        "object_axes": matrix_of(thing.get("axes")),
        "object_middle": vector_of(thing.get("middle"), [0.0, 0.0, 0.0]),
        "object_id": number_of(thing.get("id"), 0.0),
        "viewport": vector_of(state.get("viewport"), [1.0, 1.0]),
        "time": number_of(state.get("time"), 0.0),
        "frame": number_of(state.get("frame"), 0.0),
    }
    if camera.get("parallel"):
        around["parallel"] = vector_of(camera.get("toward"), [0.0, 0.0, 1.0])
    near = thing.get("near", {})
    for member, name in NEAR_OBJECTS.items():
        around[member] = number_of(near.get(name), 1e6)
    return around


# Numbers as the bytes of a uniform: floats of 32 bits, integers where `integers` says.
def bytes_of(numbers, integers):
    most = 3.4028234663852886e38
    words = bytearray()
    for index, x in enumerate(numbers):
        if index in integers:
            words += struct.pack("<I", int(x) & 0xFFFFFFFF)
        else:
            words += struct.pack("<f", 0.0 if x != x else min(max(x, -most), most))
    # Blocks are filled up to 16 bytes.
    return bytes(words + bytes(-len(words) % 16))


# The bytes of a module's uniform `look` in a state.
def prepare(module, state):
    function, integers = NUMBERS[module]
    around = surroundings_of(state)
    settings = settings_of(state)
    if IS_KEYED:
        settings = keyed(settings, around)
    return bytes_of(function(settings, around), integers)
