# The panel of an add-on without a window: a layout that notes what is drawn, and its buttons.
import bpy


class Layout:
    """Notes properties, buttons and texts instead of drawing them."""

    def __init__(self, notes):
        object.__setattr__(self, "notes", notes)

    def __setattr__(self, _name, _value):
        """Settings of layouts change nothing that is noted."""

    def column(self, **_options):
        return self

    row = column

    def prop(self, data, name, **_options):
        getattr(data, name)
        self.notes.append(("property", data.bl_rna.properties[name].name))

    def label(self, text="", **_options):
        self.notes.append(("text", text))

    def operator(self, name, text=None):
        operator = operator_of(name)
        self.notes.append(("button", text or operator.get_rna_type().name))
        return type("Properties", (), {})()


def operator_of(name):
    group, own = name.split(".")
    return getattr(getattr(bpy.ops, group), own)


def drawn(look):
    """What all panels of an add-on show."""
    notes = []
    for panel in look.CLASSES:
        if issubclass(panel, bpy.types.Panel):
            panel.draw(type("Drawing", (), {"layout": Layout(notes)})(), bpy.context)
    return notes


def add(name, mesh):
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def check(look):
    """Holds that the panel of a registered add-on shows everything, and that its buttons work."""
    notes = drawn(look)
    wanted = {one.get("label") or one["key"] for one in look.LOOK["parameters"]}
    wanted |= {one.get("label") or one["id"] for one in look.LOOK["lights"]}
    shown = {text for kind, text in notes if kind == "property"}
    assert wanted | {"Show in viewport", "Fit to unit size"} == shown, shown ^ wanted
    buttons = [text for kind, text in notes if kind == "button"]
    assert buttons == ["Put on selected", "Take off", "Material for Cycles"], buttons

    look.FAILURE.append("no graphics card")
    look.PROBLEMS["Line"] = "Line has no faces"
    notes = drawn(look)
    assert ("text", "no graphics card") in notes and ("text", "Line: Line has no faces") in notes
    assert ("button", "Try again") in notes
    operator_of(look.CHIARO_OT_try_again.bl_idname)()
    assert not look.FAILURE and not look.PROBLEMS

    wear = operator_of(look.CHIARO_OT_wear.bl_idname)
    cycles = operator_of(look.CHIARO_OT_cycles.bl_idname)
    for one in bpy.context.selected_objects:
        one.select_set(False)
    assert wear() == {"CANCELLED"} and cycles() == {"CANCELLED"}
    mesh = bpy.data.meshes.new("triangle")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 0, 1)], [], [(0, 1, 2)])
    mesh.materials.append(bpy.data.materials.new("blue"))
    one, other = add("one", mesh), add("other", mesh)
    bare = add("bare", bpy.data.meshes.new("bare"))
    for thing in (one, bare):
        thing.select_set(True)
    settings = getattr(bpy.context.scene, look.STORED)
    settings.is_shown = False
    assert wear() == {"FINISHED"} and settings.is_shown
    assert one.get(look.STORED) and not other.get(look.STORED)

    # The material for Cycles is the object's alone, and follows the file of the shader.
    assert cycles() == {"FINISHED"}
    names = lambda thing: [slot.material and slot.material.name for slot in thing.material_slots]
    title = look.LOOK["name"]
    assert [names(thing) for thing in (one, other, bare)] == [[title], ["blue"], [title]]
    scene = bpy.context.scene
    assert (scene.render.engine, scene.view_settings.view_transform) == ("CYCLES", "Standard")
    text = bpy.data.texts[look.CYCLES["file"]]
    source = text.as_string()
    text.from_string("shader old() {}")
    assert cycles() == {"FINISHED"} and text.as_string() == source
    assert wear(takes_off=True) == {"FINISHED"}
    assert [names(thing) for thing in (one, other, bare)] == [["blue"], ["blue"], [None]]
    assert not one.get(look.STORED)
    for thing in (one, other, bare):
        bpy.data.objects.remove(thing)
    scene.render.engine = "BLENDER_EEVEE"
