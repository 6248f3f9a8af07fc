# The parameters of compiled shaders, as Blender's script nodes ask for them. Blender itself brings
# a module `oslquery` along; the Python package `bpy` does not, so tests put this one in its place.
import re
import sys
import types
from types import SimpleNamespace

KINDS = {"COLOR", "POINT", "VECTOR", "NORMAL"}


def parameter(line):
    """A parameter, of a line `param type name default hints`."""
    fields = line.split("\t")
    word, name, default = fields[1], fields[2], fields[3]
    is_closure = word.startswith("closure")
    kind = word.upper() if word.upper() in KINDS else "NOXFORM"
    numbers = [float(x) for x in re.findall(r"[-+.\deE]+", default)] if not is_closure else []
    if word == "int":
        numbers = [int(x) for x in numbers]
    found = re.findall(r"%meta\{(\w+),(\w+),\"?(.*?)\"?\}", line)
    metadata = [
        SimpleNamespace(name=key, value=value if ty == "string" else float(value))
        for ty, key, value in found
    ]
    return SimpleNamespace(
        name=name,
        isoutput=fields[0] == "oparam",
        isclosure=is_closure,
        isstruct=False,
        varlenarray=False,
        metadata=metadata,
        value=(tuple(numbers) if len(numbers) > 1 else numbers[0]) if numbers else None,
        type=SimpleNamespace(
            arraylen=0,
            vecsemantics=Semantics(kind),
            aggregate=Semantics("SCALAR" if len(numbers) == 1 else "VEC3"),
            basetype=Semantics(word.upper()),
        ),
    )


class Semantics:
    """A word of a type, which knows the others by name as members of an enum do."""

    def __init__(self, word):
        self.word = word

    def __getattr__(self, word):
        return Semantics(word)

    def __eq__(self, other):
        return self.word == other.word

    def __hash__(self):
        return hash(self.word)


class OSLQuery:
    """The parameters of a compiled shader by the path of its file."""

    def __init__(self, path):
        with open(path) as file:
            lines = file.read().splitlines()
        parameters = [line for line in lines if line.startswith(("param\t", "oparam\t"))]
        # Members of structs have names with points.
        self.parameters = [parameter(line) for line in parameters if "." not in line.split("\t")[2]]


def install():
    """Gives `bpy` the module where it has none."""
    try:
        import oslquery  # noqa: F401
    except ModuleNotFoundError:
        module = types.ModuleType("oslquery")
        module.OSLQuery = OSLQuery
        sys.modules["oslquery"] = module
