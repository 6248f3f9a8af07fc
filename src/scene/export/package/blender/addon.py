# The add-on: properties, the panel in the sidebar of the 3D viewport, and what draws in it.

SUBTYPES = {"rad": "ANGLE", "px": "PIXEL", "pixels": "PIXEL"}


def members_of(prefix, keys):
    """Names of properties for keys: Blender takes ASCII alone, and no name twice."""
    found = {}
    for key in keys:
        member = prefix + re.sub(r"[^a-zA-Z0-9_]", "_", key)[:48]
        while member in found.values():
            member += "_"
        found[key] = member
    return found


# The properties of parameters and lights in the scene's `STORED`.
PARAMETER_MEMBERS = members_of("p_", [one["key"] for one in LOOK["parameters"]])
LIGHT_MEMBERS = members_of("light_", [one["id"] for one in LOOK["lights"]])


def redraw(_owner=None, _context=None):
    update_cycles(bpy.context.scene)
    for window in bpy.context.window_manager.windows if bpy.context.window_manager else []:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def member_of(key):
    """The name of a parameter's property."""
    return PARAMETER_MEMBERS[key]


def property_of(parameter):
    """The property of an exposed parameter."""
    own, kind = parameter["default"], parameter["type"]
    common = {
        "name": parameter.get("label") or parameter["key"],
        "description": " ".join(
            filter(None, [parameter.get("help"), f"({parameter['key']})"])
        ),
        "update": redraw,
        "options": {"ANIMATABLE"},
    }
    low, high = parameter.get("min"), parameter.get("max")
    if isinstance(own, bool):
        return bpy.props.BoolProperty(default=own, **common)
    if isinstance(own, list) and all(isinstance(x, (int, float)) for x in own) and len(own) <= 4:
        is_color = kind in ("color", "composite")
        subtype = "COLOR_GAMMA" if is_color and LOOK["colorSpace"] == "display" else "COLOR"
        if is_color:
            return bpy.props.FloatVectorProperty(
                default=own, size=len(own), subtype=subtype, soft_min=0.0, soft_max=1.0, **common
            )
        return bpy.props.FloatVectorProperty(default=own, size=len(own), **common)
    if not isinstance(own, (int, float)):
        return None
    ends = {}
    if low is not None:
        ends["min"] = min(int(low), own) if kind == "int" else min(low, own)
    if high is not None:
        ends["max"] = max(int(high), own) if kind == "int" else max(high, own)
    if kind == "int":
        return bpy.props.IntProperty(default=int(own), **ends, **common)
    subtype = SUBTYPES.get(parameter.get("unit"), "NONE")
    return bpy.props.FloatProperty(default=own, subtype=subtype, **ends, **common)


def is_light(_owner, thing):
    return thing.type == "LIGHT"


def settings_annotations():
    """The properties of the scene."""
    found = {
        "is_shown": bpy.props.BoolProperty(
            name="Show in viewport",
            description="Draw the look over the objects that wear it",
            update=redraw,
        ),
        "fit": bpy.props.BoolProperty(
            name="Fit to unit size",
            description="Measure what wears the look as if it had radius 1, for which looks are "
            "made. It counts where a look has lengths: curvature, widths of lines, patterns in "
            "space, distances of lights",
            default=True,
            update=redraw,
        ),
    }
    for parameter in LOOK["parameters"]:
        made = property_of(parameter) if parameter.get("live", True) else None
        if made is not None:
            found[member_of(parameter["key"])] = made
    for light in LOOK["lights"]:
        found[LIGHT_MEMBERS[light["id"]]] = bpy.props.PointerProperty(
            name=light.get("label") or light["id"],
            description="A light of the scene that this one follows; none for the look's own",
            type=bpy.types.Object,
            poll=is_light,
            update=redraw,
        )
    return found


def options_of(scene):
    """What a scene's settings say; those of the look where the add-on is not registered."""
    settings = getattr(scene, STORED, None)
    options = {
        "parameters": {},
        "lights": {},
        "fit": True if settings is None else settings.fit,
        "time": (scene.frame_current - scene.frame_start) / scene.render.fps,
        "frame": float(scene.frame_current - scene.frame_start),
    }
    if settings is None:
        return options
    for parameter in LOOK["parameters"]:
        member = member_of(parameter["key"])
        if member in settings_type.__annotations__:
            value = getattr(settings, member)
            is_list = isinstance(parameter["default"], list)
            options["parameters"][parameter["key"]] = list(value) if is_list else value
    lights = {key: getattr(settings, member) for key, member in LIGHT_MEMBERS.items()}
    options["lights"] = checked_lights(lights)
    return options


class CHIARO_OT_wear(bpy.types.Operator):
    """Puts the look on the selected objects with faces, and shows it in the viewport"""

    bl_idname = f"object.{STORED}_wear"
    bl_label = "Put on selected"
    bl_options = {"REGISTER", "UNDO"}
    takes_off: bpy.props.BoolProperty(name="Take off", options={"SKIP_SAVE"})

    @classmethod
    def description(cls, _context, properties):
        if properties.takes_off:
            return "Takes the look off the selected objects, with its material for Cycles"
        return cls.__doc__

    def execute(self, context):
        things = [thing for thing in context.selected_objects if thing.type in WEARERS]
        if not things:
            self.report({"WARNING"}, "Select a mesh first")
            return {"CANCELLED"}
        for thing in things:
            wear(thing, not self.takes_off)
            if self.takes_off:
                take_off_in_cycles(thing)
        if not self.takes_off:
            getattr(context.scene, STORED).is_shown = True
        try_again()
        return {"FINISHED"}


class CHIARO_OT_cycles(bpy.types.Operator):
    """Gives the selected objects a material that shows the look in Cycles, over those they have"""

    bl_idname = f"object.{STORED}_cycles"
    bl_label = "Material for Cycles"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        if CYCLES is None:
            cls.poll_message_set(f"No shader for Cycles: {NOT_IN_CYCLES}")
        return CYCLES is not None

    def execute(self, context):
        things = [thing for thing in context.selected_objects if thing.type in WEARERS]
        if not things:
            self.report({"WARNING"}, "Select a mesh first")
            return {"CANCELLED"}
        scene = context.scene
        before = (scene.render.engine, scene.view_settings.view_transform)
        try:
            for thing in things:
                wear_in_cycles(thing, scene)
        except (OSError, RuntimeError, ValueError) as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        if before != (scene.render.engine, scene.view_settings.view_transform):
            message = "Cycles renders now, with Open Shading Language; the view transform is "
            self.report({"INFO"}, message + "Standard, which shows colors as they are")
        return {"FINISHED"}


class CHIARO_OT_try_again(bpy.types.Operator):
    """Draws again what could not be drawn"""

    bl_idname = f"object.{STORED}_try_again"
    bl_label = "Try again"

    def execute(self, _context):
        try_again()
        return {"FINISHED"}


def try_again():
    global PLAYER
    if FAILURE:
        PLAYER = None
    FAILURE.clear()
    PROBLEMS.clear()
    redraw()


class LookPanel:
    """A panel in the sidebar of the 3D viewport."""

    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Chiaro"


class CHIARO_PT_look(LookPanel, bpy.types.Panel):
    bl_idname = f"CHIARO_PT_{STORED}"
    bl_label = LOOK["name"]

    def draw(self, context):
        settings = getattr(context.scene, STORED)
        column = self.layout.column()
        column.use_property_split = True
        column.prop(settings, "is_shown")
        column.prop(settings, "fit")
        row = self.layout.row(align=True)
        row.operator(CHIARO_OT_wear.bl_idname, text="Put on selected")
        row.operator(CHIARO_OT_wear.bl_idname, text="Take off").takes_off = True
        self.layout.operator(CHIARO_OT_cycles.bl_idname)
        told = FAILURE + [f"{name}: {problem}" for name, problem in PROBLEMS.items()]
        for text in told:
            self.layout.label(text=text, icon="ERROR")
        if told:
            self.layout.operator(CHIARO_OT_try_again.bl_idname)


def panel_of(number, label, members):
    """A panel within the look's own, with properties of the scene's settings."""

    def draw(self, context):
        settings = getattr(context.scene, STORED)
        column = self.layout.column()
        column.use_property_split = True
        for member in members:
            column.prop(settings, member)

    name = f"CHIARO_PT_{STORED}_{number}"
    closed = {"DEFAULT_CLOSED"} if number else set()
    about = {
        "bl_idname": name,
        "bl_label": label,
        "bl_parent_id": CHIARO_PT_look.bl_idname,
        "bl_options": closed,
        "draw": draw,
    }
    return type(name, (LookPanel, bpy.types.Panel), about)


def panels():
    """A panel for each group of parameters, the first one open, and one for the lights."""
    groups = {}
    for parameter in LOOK["parameters"]:
        member = member_of(parameter["key"])
        if member in settings_type.__annotations__:
            groups.setdefault(parameter.get("group") or "Parameters", []).append(member)
    if LOOK["lights"]:
        groups["Lights to follow"] = groups.pop("Lights to follow", []) + list(
            LIGHT_MEMBERS.values()
        )
    return [panel_of(number, *group) for number, group in enumerate(groups.items())]


settings_type = type(
    f"CHIARO_PG_{STORED}", (bpy.types.PropertyGroup,), {"__annotations__": settings_annotations()}
)

# What shows the picture over the viewport, with the depths of what was drawn. Rows are turned back.
SHOWING_VERTEX = """
void main() {
    at = corner * vec2(0.5, -0.5) + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
"""
SHOWING_FRAGMENT = """
void main() {
    vec4 found = texture(picture, at);
    if (found.a <= 0.0) discard;
    vec3 straight = clamp(found.rgb / found.a, 0.0, 1.0);
    if (is_linear > 0.5) {
        vec3 high = 1.055 * pow(straight, vec3(1.0 / 2.4)) - 0.055;
        straight = mix(high, 12.92 * straight, lessThanEqual(straight, vec3(0.0031308)));
    }
    if (is_encoding > 0.5) {
        vec3 low = straight / 12.92, high = pow((straight + 0.055) / 1.055, vec3(2.4));
        straight = mix(high, low, lessThanEqual(straight, vec3(0.04045)));
    }
    color = vec4(straight, found.a);
    // A little nearer, so that the mesh itself does not show through.
    gl_FragDepth = texture(depths, at).r - 2e-5;
}
"""
SHOWING = []
HANDLERS = []
# Why nothing is drawn, and why an object is not, by its name.
FAILURE = []
PROBLEMS = {}


def showing_shader():
    if not SHOWING:
        info = gpu.types.GPUShaderCreateInfo()
        info.vertex_in(0, "VEC2", "corner")
        varyings = gpu.types.GPUStageInterfaceInfo("showing")
        varyings.smooth("VEC2", "at")
        info.vertex_out(varyings)
        info.sampler(0, "FLOAT_2D", "picture")
        info.sampler(1, "FLOAT_2D", "depths")
        info.push_constant("FLOAT", "is_linear")
        info.push_constant("FLOAT", "is_encoding")
        info.fragment_out(0, "VEC4", "color")
        info.depth_write("ANY")
        info.vertex_source(SHOWING_VERTEX)
        info.fragment_source(SHOWING_FRAGMENT)
        SHOWING.append(gpu.shader.create_from_info(info))
    return SHOWING[0]


def show(is_encoding):
    """Shows the player's picture in the frame buffer that is bound, with its depths.

    `is_encoding` says that the frame buffer encodes what is drawn as sRGB, as a viewport's does.
    """
    one = player()
    shader = showing_shader()
    target = one.targets["draw"]
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("LESS_EQUAL")
    gpu.state.depth_mask_set(True)
    shader.bind()
    shader.uniform_sampler("picture", target.colors[0])
    shader.uniform_sampler("depths", target.depth)
    shader.uniform_float("is_linear", 1.0 if LOOK["colorSpace"] == "linear" else 0.0)
    shader.uniform_float("is_encoding", 1.0 if is_encoding else 0.0)
    one.screen.draw(shader)
    gpu.state.depth_mask_set(False)
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")


def draw_viewport():
    context = bpy.context
    scene = context.scene
    settings = getattr(scene, STORED, None)
    if settings is None or not settings.is_shown or FAILURE:
        return
    things = [thing for thing in context.visible_objects if thing.get(STORED)]
    if not things:
        return
    region = context.region_data
    viewport = gpu.state.viewport_get()
    try:
        depsgraph = context.evaluated_depsgraph_get()
        size = (viewport[2], viewport[3])
        view, projection = region.view_matrix.copy(), region.window_matrix.copy()
        # Objects that failed are told in the panel and tried when they change, not at each frame.
        things = [thing for thing in things if thing.name not in PROBLEMS]
        player().draw(things, depsgraph, view, projection, size, options_of(scene), PROBLEMS)
        show(True)
    except Exception as problem:
        # Told once in the panel, and in full in the console; not again and again while drawing.
        FAILURE.append(str(problem))
        traceback.print_exc()


@bpy.app.handlers.persistent
def after_load(*_):
    """Objects of another file may have the ids of those before."""
    PROBLEMS.clear()
    MEASURED.clear()
    if PLAYER is not None:
        PLAYER.bodies.clear()


@bpy.app.handlers.persistent
def after_change(scene, depsgraph):
    """Meshes that were edited, or that a new frame deforms, are read again."""
    for update in depsgraph.updates:
        if isinstance(update.id, bpy.types.Object) and update.is_updated_geometry:
            PROBLEMS.pop(update.id.name, None)
            MEASURED.pop(update.id.original.session_uid, None)
            if PLAYER is not None:
                PLAYER.forget(update.id.original)
    update_cycles(scene)


OPERATORS = (CHIARO_OT_wear, CHIARO_OT_cycles, CHIARO_OT_try_again)
CLASSES = (settings_type, *OPERATORS, CHIARO_PT_look, *panels())
LISTENERS = (
    (bpy.app.handlers.depsgraph_update_post, after_change),
    (bpy.app.handlers.frame_change_post, after_change),
    (bpy.app.handlers.load_post, after_load),
)


def register():
    # The add-on may be installed and run in the text editor as well: the last one counts.
    earlier = bpy.app.driver_namespace.pop(STORED, None)
    if earlier is not None:
        earlier()
    for one in CLASSES:
        bpy.utils.register_class(one)
    setattr(bpy.types.Scene, STORED, bpy.props.PointerProperty(type=settings_type))
    for listeners, listener in LISTENERS:
        listeners.append(listener)
    if not bpy.app.background:
        handler = bpy.types.SpaceView3D.draw_handler_add(draw_viewport, (), "WINDOW", "POST_VIEW")
        HANDLERS.append(handler)
    bpy.app.driver_namespace[STORED] = unregister


def unregister():
    if not settings_type.is_registered:
        return
    if bpy.app.driver_namespace.get(STORED) is unregister:
        del bpy.app.driver_namespace[STORED]
    while HANDLERS:
        bpy.types.SpaceView3D.draw_handler_remove(HANDLERS.pop(), "WINDOW")
    for listeners, listener in LISTENERS:
        if listener in listeners:
            listeners.remove(listener)
    delattr(bpy.types.Scene, STORED)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
    FAILURE.clear()
    PROBLEMS.clear()


if __name__ == "__main__":
    register()
