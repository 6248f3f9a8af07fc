# The look as a material for Cycles: a node that runs the shader beside this file.


# Meshes of what wears the look, by the ids of objects; they are read again when they change.
MEASURED = {}


def cycles_material(scene=None):
    """The material that shows the look in Cycles, made where there is none.

    Raises an error where there is no shader for Cycles, and where it cannot be compiled.
    """
    if CYCLES is None:
        raise ValueError(f"there is no shader for Cycles: {NOT_IN_CYCLES}")
    scene = scene or bpy.context.scene
    try:
        import oslquery  # noqa: F401
    except ModuleNotFoundError as problem:
        message = "script nodes need the module oslquery, which the Python package bpy leaves out"
        raise RuntimeError(f"{message}: use Blender itself") from problem
    # Nodes learn of a script's parameters from the engine of the scene.
    scene.render.engine = "CYCLES"
    scene.cycles.shading_system = True
    # Colors are shown as the look has them.
    scene.view_settings.view_transform = "Standard"
    found = [one for one in bpy.data.materials if script_of(one) is not None]
    # The look may have been exported again since.
    for material in found:
        script_of(material).script = shader_text()
    material = found[0] if found else new_cycles_material()
    update_cycles(scene)
    return material


def shader_text():
    """The shader as a text of the file, brought to what lies beside the add-on."""
    path = os.path.join(FOLDER, CYCLES["file"])
    text = bpy.data.texts.get(CYCLES["file"]) or bpy.data.texts.new(CYCLES["file"])
    if os.path.isfile(path):
        with open(path, encoding="utf-8") as file:
            source = file.read()
        # A text in a file of Blender's knows nothing of the folder.
        for image in LOOK["images"]:
            beside = os.path.join(FOLDER, image["file"] or "").replace("\\", "/")
            source = source.replace(f'"{image["file"]}"', f'"{beside}"')
        if text.as_string() != source:
            text.from_string(source)
    elif not text.as_string():
        raise FileNotFoundError(f"{CYCLES['file']} is to lie beside {os.path.basename(__file__)}")
    return text


def new_cycles_material():
    text = shader_text()
    material = bpy.data.materials.new(LOOK["name"])
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    script = tree.nodes.new("ShaderNodeScript")
    script.name = STORED
    script.width = 240
    script.mode = "INTERNAL"
    script.script = text
    if "BSDF" not in script.outputs:
        bpy.data.materials.remove(material)
        raise RuntimeError(f"Cycles could not compile {CYCLES['file']}; its console says why")
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    output.location = (320, 0)
    tree.links.new(script.outputs["BSDF"], output.inputs["Surface"])
    if CYCLES["reads_uv"]:
        map_of_uv = tree.nodes.new("ShaderNodeUVMap")
        map_of_uv.location = (-240, 0)
        tree.links.new(map_of_uv.outputs["UV"], script.inputs["UV"])
    material[STORED] = True
    return material


def script_of(material):
    """The node of the look in a material; `None` for materials of others."""
    if not material.get(STORED) or material.node_tree is None:
        return None
    return material.node_tree.nodes.get(STORED)


def wear_in_cycles(thing, scene=None):
    """Puts the look on an object, in the viewport and in Cycles.

    The material is the object's own, over those of its mesh, which other objects may share.
    """
    wear(thing)
    material = cycles_material(scene)
    if not thing.material_slots:
        thing.data.materials.append(None)
    for slot in thing.material_slots:
        slot.link = "OBJECT"
        slot.material = material
    update_cycles(scene or bpy.context.scene)
    return material


def take_off_in_cycles(thing):
    """Gives an object the materials of its mesh back."""
    for slot in thing.material_slots:
        if slot.link == "OBJECT" and slot.material and script_of(slot.material) is not None:
            slot.material = None
            slot.link = "DATA"


def light_of_shown(color):
    """A color of the look as Cycles takes it: linear light."""
    if LOOK["colorSpace"] == "linear":
        return list(color)
    return [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in color]


def cycles_values(scene):
    """The values of the shader's parameters by name, of a scene's settings."""
    options = options_of(scene)
    given, followed = options["parameters"], options["lights"]
    values = {}
    for own in LOOK["lights"]:
        for field, name in CYCLES["lights"].get(own["id"], {}).items():
            if field in own:
                values[name] = light_of_shown(own[field]) if field == "color" else own[field]
    for parameter in LOOK["parameters"]:
        names = CYCLES["parameters"].get(parameter["key"])
        if names is None:
            continue
        value = given.get(parameter["key"], parameter["default"])
        if not hasattr(value, "__iter__"):
            values[names[0]] = value
            continue
        numbers = [float(x) for x in value]
        is_color = parameter["type"] in ("color", "composite") or len(names) > 1
        if len(names) > 1:
            values[names[1]] = numbers[3] if len(numbers) > 3 else 1.0
        triple = (numbers + [0.0, 0.0])[:3]
        values[names[0]] = light_of_shown(triple) if is_color else triple
    bodies = measured_bodies(wearers_of(bpy.context.view_layer))
    models = [Y_UP @ thing.matrix_world @ Y_UP.inverted() for thing, _ in bodies]
    scale, middle = Player.fit(bodies, models) if options["fit"] else (1.0, Vector())
    values["middle"] = list(Y_UP.inverted() @ middle)
    values["radius"] = 1.0 / scale
    values["seconds"], values["frame"] = options["time"], options["frame"]
    fit = Matrix.Scale(scale, 4) @ Matrix.Translation(-middle)
    look_from_world = fit @ Y_UP
    camera = Matrix.Identity(4)
    if scene.camera is not None:
        camera = (look_from_world @ scene.camera.matrix_world).to_quaternion().to_matrix()
        camera = camera.transposed().to_4x4()
    axes, center = Matrix.Identity(3), Vector()
    if bodies:
        axes, center = object_frame(fit @ models[0], bodies[0][1])
    for key, light in followed.items():
        if light is None:
            continue
        fields = light_values(key, light, look_from_world, camera, axes, center)
        for field, name in CYCLES["lights"].get(key, {}).items():
            if field in fields:
                value = fields[field]
                values[name] = light_of_shown(value) if field == "color" else value
    return values


def measured_bodies(things):
    """Objects with their meshes; without those that have no faces now."""
    found = []
    for thing in things:
        if thing.session_uid not in MEASURED:
            # Asked for only here: it evaluates keyframes, over a value that was just set.
            depsgraph = bpy.context.evaluated_depsgraph_get()
            try:
                MEASURED[thing.session_uid] = Body(thing, depsgraph)
            except ValueError:
                continue
        found.append((thing, MEASURED[thing.session_uid]))
    return found


def set_cycles_values(material, values):
    """Gives the look's node in a material values by name. What is as it was is left alone."""
    for socket in script_of(material).inputs:
        value = values.get(socket.identifier)
        if value is None or socket.is_linked:
            continue
        own = socket.default_value
        if not hasattr(own, "__iter__"):
            if own != value:
                socket.default_value = type(own)(value)
            continue
        numbers = (list(value) + [1.0])[: len(own)]
        if any(abs(a - b) > 1e-6 * max(abs(b), 1.0) for a, b in zip(own, numbers)):
            socket.default_value = numbers


def update_cycles(scene):
    """Brings the materials for Cycles to the scene's settings, lights and time."""
    materials = [one for one in bpy.data.materials if script_of(one) is not None]
    if CYCLES is None or not materials:
        return
    values = cycles_values(scene)
    for material in materials:
        set_cycles_values(material, values)
