# Draws the look with Blender's GPU module.
#
# The look's world has y up and unit size; Blender's has z up and any size. Meshes are drawn with y
# turned over, as WebGPU counts rows, and the picture is turned back where it is shown.

FOLDER = os.path.dirname(os.path.abspath(__file__))

# Turns Blender's axes to those of the look.
Y_UP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))

GPU_TYPES = {"float": "FLOAT", "int": "INT", "uint": "UINT", "mat4x4": "MAT4", "mat3x3": "MAT3"}
SAMPLERS = {"sampler2D": "FLOAT_2D", "sampler2DArray": "FLOAT_2D_ARRAY"}
FORMATS = {"rgba32float": "RGBA32F", "r32float": "R32F"}
# Types of objects that have faces.
WEARERS = ("MESH", "CURVE", "SURFACE", "FONT", "META")
SIZES = {"position": 3, "normal": 3, "tangent": 4, "uv": 2, "color": 4}

# Blender's textures have no filters or wraps for scripts, so images are filtered here. All images
# of a look have the same.
SAMPLING = """
ivec2 look_texel(ivec2 at, ivec2 size) {
#if WRAP == 0
    return clamp(at, ivec2(0), size - 1);
#elif WRAP == 1
    return (at + size) % size;
#else
    ivec2 twice = 2 * size;
    ivec2 turned = (at + twice) % twice;
    return min(turned, twice - 1 - turned);
#endif
}

// Texels lie between -1 and twice the size, for remainders of what is less have no meaning.
vec4 look_texture(sampler2D image, vec2 uv) {
    ivec2 size = textureSize(image, 0);
#if WRAP == 0
    uv = clamp(uv, vec2(-1.0), vec2(2.0));
#else
    uv -= 2.0 * floor(0.5 * uv);
#endif
    vec2 place = uv * vec2(size);
#if IS_NEAREST
    return texelFetch(image, look_texel(ivec2(floor(place)), size), 0);
#else
    vec2 low = floor(place - 0.5);
    vec2 share = place - 0.5 - low;
    ivec2 at = ivec2(low);
    vec4 lower = mix(texelFetch(image, look_texel(at, size), 0),
                     texelFetch(image, look_texel(at + ivec2(1, 0), size), 0), share.x);
    vec4 upper = mix(texelFetch(image, look_texel(at + ivec2(0, 1), size), 0),
                     texelFetch(image, look_texel(at + ivec2(1, 1), size), 0), share.x);
    return mix(lower, upper, share.y);
#endif
}

#define texture(image, uv) look_texture(image, uv)
#define textureLod(image, uv, level) look_texture(image, uv)
#define textureGrad(image, uv, x, y) look_texture(image, uv)
"""
WRAPS = {"clamp": 0, "repeat": 1, "mirror": 2}


def gpu_type(word):
    return GPU_TYPES.get(word) or word.upper()


class Shader:
    """A module of the look on the graphics card."""

    def __init__(self, name):
        self.about = LOOK["modules"][name]
        vertex, fragment = SHADERS[name]
        info = gpu.types.GPUShaderCreateInfo()
        self.blocks, self.samplers = {}, []
        structures = {}
        sources = []
        varyings = gpu.types.GPUStageInterfaceInfo(f"varyings_{name}")
        has_varyings = False
        for stage, text in (("vertex", vertex), ("fragment", fragment)):
            lines = []
            for line in text.splitlines():
                block = re.match(r"layout\(std140\) uniform (\w+) \{ (\w+) (\w+); \};", line)
                sampler = re.match(r"uniform highp (\w+) (\w+);", line)
                located = re.match(r"layout\(location = (\d+)\) (in|out) (\w+) (\w+);", line)
                varying = re.match(r"(smooth|flat) (in|out) (\w+) (\w+);", line)
                if block:
                    self.blocks[block[1]] = (block[2], block[3])
                elif sampler:
                    if sampler[2] not in [known for _, known in self.samplers]:
                        self.samplers.append((sampler[1], sampler[2]))
                elif located and stage == "vertex":
                    info.vertex_in(int(located[1]), gpu_type(located[3]), located[4])
                elif located:
                    info.fragment_out(int(located[1]), gpu_type(located[3]), located[4])
                elif varying:
                    if varying[2] == "out":
                        getattr(varyings, varying[1])(gpu_type(varying[3]), varying[4])
                        has_varyings = True
                elif not line.startswith(("#version", "precision")):
                    lines.append(line)
            text = "\n".join(lines)
            for found in re.finditer(r"^struct (\w+) \{\n(.*?)^\};\n", text, re.S | re.M):
                structures.setdefault(found[1], found)
            sources.append(text)
        # Structs of blocks stand before both stages.
        shared = []
        for structure, _ in self.blocks.values():
            self.gather(structure, structures, shared)
        info.typedef_source("".join(structures[word][0] for word in shared))
        for word in shared:
            pattern = rf"^struct {word} \{{\n.*?^\}};\n"
            sources = [re.sub(pattern, "", text, flags=re.S | re.M) for text in sources]
        if has_varyings:
            info.vertex_out(varyings)
        for slot, (structure, variable) in enumerate(self.blocks.values()):
            info.uniform_buf(slot, structure, variable)
        for slot, (kind, variable) in enumerate(self.samplers):
            info.sampler(slot, SAMPLERS[kind], variable)
        info.vertex_source(sources[0])
        flat = [image for image in LOOK["images"] if image["kind"] != "hcbtf"]
        if flat and any(binding["feed"]["from"] == "image" for binding in self.about["bindings"]):
            image = flat[0]
            info.define("WRAP", str(WRAPS[image["wrap"]]))
            info.define("IS_NEAREST", "1" if image["filter"] == "nearest" else "0")
            sources[1] = SAMPLING + sources[1]
        info.fragment_source(sources[1])
        self.shader = gpu.shader.create_from_info(info)

    @staticmethod
    def gather(name, structures, found):
        if name not in structures or name in found:
            return
        for word in re.findall(r"^    (\w+) ", structures[name][2], re.M):
            Shader.gather(word, structures, found)
        found.append(name)


class Target:
    """A texture, or several, that a pass draws into, with depths."""

    def __init__(self, size, formats):
        self.colors = [gpu.types.GPUTexture(size, format=format) for format in formats]
        self.depth = gpu.types.GPUTexture(size, format="DEPTH_COMPONENT32F")
        self.buffer = gpu.types.GPUFrameBuffer(depth_slot=self.depth, color_slots=self.colors)

    def clear(self, outputs):
        for texture, output in zip(self.colors, outputs):
            texture.clear(format="FLOAT", value=[float(x) for x in output["clear"]])
        self.buffer.clear(depth=1.0)


class Layers:
    """The textures of shadow maps: what lights see, a layer for each view of a light."""

    def __init__(self, side, count, formats):
        size = (side, side)
        # An array of one layer would be a flat texture.
        count = max(count, 2)
        self.colors = [
            gpu.types.GPUTexture(size, layers=count, format=format) for format in formats
        ]
        self.depth = gpu.types.GPUTexture(size, format="DEPTH_COMPONENT32F")

    def buffer(self, layer):
        slots = [{"texture": texture, "layer": layer} for texture in self.colors]
        return gpu.types.GPUFrameBuffer(depth_slot=self.depth, color_slots=slots)


# Attributes that modules ask for.
ATTRIBUTES = {one["name"] for module in LOOK["modules"].values() for one in module["attributes"]}


class Body:
    """A mesh as the graphics card has it, in axes with y up."""

    def __init__(self, thing, depsgraph):
        if thing.type not in WEARERS:
            raise ValueError(f"{thing.name} is a {thing.type.lower()} and has no faces to draw")
        evaluated = thing.evaluated_get(depsgraph)
        mesh = evaluated.to_mesh()
        try:
            self.take(thing, mesh)
        finally:
            evaluated.to_mesh_clear()

    def take(self, thing, mesh):
        mesh.calc_loop_triangles()
        if not mesh.loop_triangles:
            raise ValueError(f"{thing.name} has no faces to draw")
        corners = np.empty(3 * len(mesh.loop_triangles), np.int32)
        mesh.loop_triangles.foreach_get("loops", corners)
        vertices = np.empty(len(mesh.loops), np.int32)
        mesh.loops.foreach_get("vertex_index", vertices)
        places = self.read(mesh.vertices, "co", len(mesh.vertices), 3)
        normals = self.read(mesh.corner_normals, "vector", len(vertices), 3)
        self.arrays = {
            "position": self.turned(places)[vertices[corners]],
            "normal": self.turned(normals)[corners],
            "color": np.ones((len(corners), 4), np.float32),
            "uv": np.zeros((len(corners), 2), np.float32),
            "tangent": np.tile(np.array([1, 0, 0, 1], np.float32), (len(corners), 1)),
        }
        if mesh.uv_layers.active:
            uv = self.read(mesh.uv_layers.active.uv, "vector", len(vertices), 2)
            self.arrays["uv"] = uv[corners]
            if "tangent" in ATTRIBUTES:
                self.arrays["tangent"] = self.tangents(mesh, vertices)[corners]
        colors = mesh.color_attributes.active_color
        if colors:
            found = self.read(colors.data, "color", len(colors.data), 4)
            is_of_corners = colors.domain == "CORNER"
            self.arrays["color"] = found[corners if is_of_corners else vertices[corners]]
        used = self.arrays["position"]
        self.low, self.high = used.min(axis=0), used.max(axis=0)
        self.batches = {}

    def tangents(self, mesh, vertices):
        """Tangents of the corners, with the signs of bitangents."""
        # Blender computes tangents of faces with three or four corners alone.
        is_split = any(len(polygon.vertices) > 4 for polygon in mesh.polygons)
        source, corners = mesh, slice(None)
        if is_split:
            source, corners = self.split(mesh)
        try:
            source.calc_tangents()
            tangents = self.read(source.loops, "tangent", len(source.loops), 3)
            signs = self.read(source.loops, "bitangent_sign", len(source.loops), 1)
        finally:
            if is_split:
                bpy.data.meshes.remove(source)
        found = np.tile(np.array([1, 0, 0, 1], np.float32), (len(vertices), 1))
        found[corners] = np.hstack([self.turned(tangents), signs])
        return found

    def split(self, mesh):
        """A mesh of the triangles, and for each of its corners the one that it was."""
        triangles = len(mesh.loop_triangles)
        corners = np.empty(3 * triangles, np.int32)
        mesh.loop_triangles.foreach_get("loops", corners)
        vertices = np.empty(3 * triangles, np.int32)
        mesh.loop_triangles.foreach_get("vertices", vertices)
        places = self.read(mesh.vertices, "co", len(mesh.vertices), 3)
        normals = self.read(mesh.corner_normals, "vector", len(mesh.loops), 3)
        uv = self.read(mesh.uv_layers.active.uv, "vector", len(mesh.loops), 2)
        made = bpy.data.meshes.new("triangles")
        made.from_pydata(places, [], vertices.reshape(-1, 3))
        layer = made.uv_layers.new(name="uv")
        layer.uv.foreach_set("vector", np.ascontiguousarray(uv[corners]).reshape(-1))
        made.normals_split_custom_set(normals[corners])
        return made, corners

    @staticmethod
    def read(collection, name, count, size):
        numbers = np.empty(count * size, np.float32)
        collection.foreach_get(name, numbers)
        return numbers.reshape(-1, size)

    @staticmethod
    def turned(vectors):
        x, y, z = vectors.T
        return np.stack([x, z, -y], axis=1)

    def batch(self, module):
        if module not in self.batches:
            attributes = LOOK["modules"][module]["attributes"]
            layout = gpu.types.GPUVertFormat()
            for one in attributes:
                size = SIZES[one["name"]]
                layout.attr_add(id=one["glsl"], comp_type="F32", len=size, fetch_mode="FLOAT")
            vertices = gpu.types.GPUVertBuf(layout, len(self.arrays["position"]))
            for one in attributes:
                numbers = np.ascontiguousarray(self.arrays[one["name"]], np.float32)
                vertices.attr_fill(one["glsl"], numbers)
            self.batches[module] = gpu.types.GPUBatch(type="TRIS", buf=vertices)
        return self.batches[module]


def columns(matrix):
    """The numbers of a matrix, column after column."""
    return [x for column in matrix.col for x in column]


def packed(binding, values):
    """The bytes of a uniform: each member's numbers at its place."""
    data = bytearray(binding["size"] + -binding["size"] % 16)
    for member in binding["members"]:
        value = values.get(member["name"])
        if value is None:
            continue
        if member["type"] == "u32":
            struct.pack_into("<I", data, member["offset"], int(value))
            continue
        numbers = value if isinstance(value, (list, tuple)) else [value]
        rows = int(member["type"][5]) if member["type"].startswith("mat") else len(numbers)
        for index, x in enumerate(numbers):
            at = member["offset"] + 16 * (index // rows) + 4 * (index % rows)
            struct.pack_into("<f", data, at, x)
    return bytes(data)


class Player:
    """The look on the graphics card, with what it draws into."""

    def __init__(self):
        self.shaders = {name: Shader(name) for name in LOOK["modules"]}
        self.images = [image_texture(image) for image in LOOK["images"]]
        # What shadow maps are while no light draws them.
        self.nothing = gpu.types.GPUTexture((1, 1), layers=2, format="RGBA32F")
        self.nothing.clear(format="FLOAT", value=(0.0, 0.0, 0.0, 0.0))
        layout = gpu.types.GPUVertFormat()
        layout.attr_add(id="corner", comp_type="F32", len=2, fetch_mode="FLOAT")
        corners = gpu.types.GPUVertBuf(layout, 3)
        corners.attr_fill("corner", [(-1, -1), (3, -1), (-1, 3)])
        self.screen = gpu.types.GPUBatch(type="TRIS", buf=corners)
        self.targets, self.bodies, self.layers = {}, {}, {}
        # Targets of the sizes that were drawn last, one for each viewport.
        self.sizes = {}

    def resize(self, size):
        self.targets = self.sizes.pop(size, None) or {
            one["name"]: Target(size, formats_of(one))
            for one in LOOK["passes"]
            if one["draws"] != "lights"
        }
        self.sizes[size] = self.targets
        while len(self.sizes) > 4:
            del self.sizes[next(iter(self.sizes))]

    def body(self, thing, depsgraph):
        key = thing.session_uid
        if key not in self.bodies:
            self.bodies[key] = Body(thing, depsgraph)
        return self.bodies[key]

    def forget(self, thing):
        self.bodies.pop(thing.session_uid, None)

    def bodies_of(self, things, depsgraph, problems):
        """What is drawn of objects. Those that cannot be drawn go to `problems`, with reasons."""
        found = []
        for thing in things:
            try:
                found.append((thing, self.body(thing, depsgraph)))
            except Exception as problem:
                if problems is None:
                    raise
                problems[thing.name] = str(problem)
        if len(self.bodies) > 2 * len(found) + 64:
            self.bodies = {thing.session_uid: body for thing, body in found}
        return found

    def draw(self, things, depsgraph, view, projection, size, options, problems=None):
        """Draws objects into the player's own picture, which is `self.targets["draw"]`.

        `view` and `projection` are Blender's matrices; `options` has `parameters`, `lights` (light
        objects by the ids of the look's lights), `time`, `frame`, `fit` and `shift`, by which the
        picture is moved, in pixels. Objects that cannot be drawn raise errors, or are left out and
        told in `problems` where that is given.
        """
        self.resize(size)
        bodies = self.bodies_of(things, depsgraph, problems)
        models = [Y_UP @ thing.matrix_world @ Y_UP.inverted() for thing, _ in bodies]
        scale, middle = self.fit(bodies, models) if options.get("fit", True) else (1.0, Vector())
        fit = Matrix.Scale(scale, 4) @ Matrix.Translation(-middle)
        models = [fit @ model for model in models]
        world_from_look = Y_UP.inverted() @ fit.inverted()
        camera = Matrix.Scale(scale, 4) @ view @ world_from_look
        # Camera axes have no scale; what is left of it is rounding.
        moved = Matrix.Translation(camera.to_translation())
        camera = moved @ camera.to_quaternion().to_matrix().to_4x4()
        turned = Matrix.Diagonal((1, -1, 1, 1))
        across, down = options.get("shift", (0.0, 0.0))
        moved = Matrix.Translation((2.0 * across / size[0], 2.0 * down / size[1], 0.0))
        clip = moved @ turned @ projection @ Matrix.Scale(1.0 / scale, 4) @ camera
        is_parallel = abs(projection[3][3]) > 0.5
        if not is_parallel:
            # Looks measure sizes on the picture by the matrix's rows, at unit size.
            clip = clip * scale
        back = camera.inverted()
        eye, toward = back.to_translation(), back.to_3x3() @ Vector((0, 0, 1))
        pixel = 2.0 / projection[1][1] / size[1] * (scale if is_parallel else 1.0)
        view_values = {
            "clip_from_world": columns(clip),
            "camera_from_world": columns(camera),
            "eye": [*toward, 0.0] if is_parallel else [*eye, 1.0],
            "screen": [1.0, 1.0, 0.0, 0.0],
        }
        numbers = {
            "pixel": pixel,
            "perspective": 0.0 if is_parallel else 1.0,
            "viewport_height": float(size[1]),
            "rows_up": 0.0,
            "samples": 1.0,
        }
        state = {
            "parameters": options.get("parameters", {}),
            "camera": {
                "rotation": columns(camera.to_3x3()),
                "eye": list(eye),
                "parallel": is_parallel,
                "toward": list(toward),
            },
            "viewport": [float(x) for x in size],
            "time": options.get("time", 0.0),
            "frame": options.get("frame", 0.0),
        }
        frames_of_objects = [object_frame(model, body) for (_, body), model in zip(bodies, models)]
        lights = options.get("lights", {})
        shadows = Shadows(bodies, models, frames_of_objects, camera, size[1], fit, options)
        frames = []
        for number, ((thing, body), model) in enumerate(zip(bodies, models)):
            axes, center = frames_of_objects[number]
            own = dict(state)
            own["object"] = {"id": number, "axes": columns(axes), "middle": list(center)}
            own["lights"] = {
                key: light_values(key, light, fit @ Y_UP, camera, axes, center)
                for key, light in lights.items()
                if light is not None
            }
            for key, place in shadows.places.items():
                own["lights"].setdefault(key, {})["shadow_map"] = place
            values = {
                "world_from_object": columns(model),
                "world_from_normal": columns(model.to_3x3().inverted_safe().transposed()),
                "id": float(number),
                "material": 0,
                "look": 0.0,
            }
            frames.append((body, model, values, own, {}))
        for one in LOOK["passes"]:
            if one["draws"] != "lights":
                self.run(one, frames, view_values, numbers)
            elif shadows.layers:
                self.run_lights(one, frames, shadows)

    @staticmethod
    def fit(bodies, models):
        """Scale and middle that bring what is drawn to a sphere of radius 1."""
        if not bodies:
            return 1.0, Vector()
        placed = placed_of(bodies, models)
        if len(placed) == 1:
            low_high = Vector((bodies[0][1].low + bodies[0][1].high) / 2)
            middle = np.array(models[0] @ low_high)
        else:
            low = np.min([one.min(axis=0) for one in placed], axis=0)
            high = np.max([one.max(axis=0) for one in placed], axis=0)
            middle = (low + high) / 2
        radius = max(np.sqrt(((one - middle) ** 2).sum(axis=1)).max() for one in placed)
        return 1.0 / max(float(radius), 1e-9), Vector(middle)

    def run(self, one, frames, view_values, numbers):
        target = self.targets[one["name"]]
        is_picture = one["name"] == "draw"
        name = one["module"]
        shader = self.shaders[name]
        inputs = {it["binding"]: self.targets.get(it["pass"]) for it in one.get("inputs", [])}
        with target.buffer.bind():
            target.clear(one["outputs"])
            gpu.state.blend_set("ALPHA" if is_picture else "NONE")
            if one["draws"] == "screen":
                gpu.state.depth_test_set("ALWAYS")
                gpu.state.depth_mask_set(False)
                gpu.state.face_culling_set("NONE")
                self.bind(one, shader, inputs, view_values, numbers, {}, None)
                self.screen.draw(shader.shader)
            else:
                gpu.state.depth_test_set("LESS")
                gpu.state.depth_mask_set(True)
                for body, model, values, state, looks in frames:
                    if self.draws_both(one, state):
                        gpu.state.face_culling_set("NONE")
                    else:
                        gpu.state.face_culling_set("BACK")
                    # Rows run the other way, and so do corners.
                    gpu.state.front_facing_set(model.determinant() >= 0.0)
                    if name in NUMBERS and name not in looks:
                        looks[name] = prepare(name, state)
                    self.bind(one, shader, inputs, view_values, numbers, values, looks.get(name))
                    body.batch(name).draw(shader.shader)
            gpu.state.front_facing_set(False)
            gpu.state.face_culling_set("NONE")
            gpu.state.blend_set("NONE")
            gpu.state.depth_mask_set(False)
            gpu.state.depth_test_set("NONE")

    def run_lights(self, one, frames, shadows):
        """Draws what lights see into the layers of their maps, both sides of every mesh."""
        name, shader = one["module"], self.shaders[one["module"]]
        shape = (shadows.side, len(shadows.layers))
        if one["name"] not in self.layers or self.layers[one["name"]][0] != shape:
            self.layers[one["name"]] = (shape, Layers(*shape, formats_of(one)))
        target = self.layers[one["name"]][1]
        for texture, output in zip(target.colors, one["outputs"]):
            texture.clear(format="FLOAT", value=[float(x) for x in output["clear"]])
        for number, layer in enumerate(shadows.layers):
            with target.buffer(number).bind():
                gpu.state.active_framebuffer_get().clear(depth=1.0)
                gpu.state.blend_set("NONE")
                gpu.state.depth_test_set("LESS")
                gpu.state.depth_mask_set(True)
                gpu.state.face_culling_set("NONE")
                for index, (body, model, _, state, looks) in enumerate(frames):
                    caster = {"world_from_object": columns(model), "number": index + 1}
                    if name in NUMBERS and name not in looks:
                        looks[name] = prepare(name, state)
                    self.bind(one, shader, {}, layer, {}, caster, looks.get(name))
                    body.batch(name).draw(shader.shader)
                gpu.state.depth_mask_set(False)
                gpu.state.depth_test_set("NONE")

    @staticmethod
    def draws_both(one, state):
        """Both sides are drawn where the look cuts parts away."""
        key = one.get("sides_parameter")
        if key is None:
            return one.get("sides") == "both"
        own = next(it["default"] for it in LOOK["parameters"] if it["key"] == key)
        return float(state["parameters"].get(key, own)) > 0.0

    def bind(self, one, shader, inputs, view_values, numbers, values, look):
        gpu_shader = shader.shader
        gpu_shader.bind()
        self.alive = []
        for binding in shader.about["bindings"]:
            if binding["kind"] == "uniform":
                block = shader.blocks.get(binding["glsl"]["name"])
                if block is None:
                    continue
                source = binding["feed"]["from"]
                given = {
                    "view": view_values,
                    "light_layer": view_values,
                    "object": values,
                    "light_caster": values,
                }.get(source, numbers)
                data = look if source == "look" else packed(binding, given)
                uniform = gpu.types.GPUUniformBuf(data)
                self.alive.append(uniform)
                gpu_shader.uniform_block(block[1], uniform)
            elif binding["kind"] != "sampler":
                name = binding["glsl"]["name"]
                if name not in [known for _, known in shader.samplers]:
                    continue
                gpu_shader.uniform_sampler(name, self.texture(one, binding))

    def texture(self, one, binding):
        feed = binding["feed"]
        if feed["from"] == "image":
            return self.images[feed["image"]]
        for it in one.get("inputs", []):
            if it["binding"] != binding["name"]:
                continue
            outputs = next(p for p in LOOK["passes"] if p["name"] == it["pass"])["outputs"]
            number = [output["name"] for output in outputs].index(it["output"])
            if it["pass"] in self.targets:
                return self.targets[it["pass"]].colors[number]
            if it["pass"] in self.layers:
                return self.layers[it["pass"]][1].colors[number]
        return self.nothing


def formats_of(one):
    return [FORMATS.get(output["format"], "RGBA16F") for output in one["outputs"]]


def placed_of(bodies, models):
    """Places of all corners of bodies, in the space that models lead to."""
    placed = []
    for (_, body), model in zip(bodies, models):
        matrix = np.array(model)
        placed.append(body.arrays["position"] @ matrix[:3, :3].T + matrix[:3, 3])
    return placed


class Shadows:
    """Views of the lights whose shadows the look draws, and the places of their maps.

    A light that shines from afar has one layer, a lamp six: +x, -x, +y, -y, +z, -z.
    """

    # Least and greatest side of a layer, in texels, and the most bytes of all layers.
    SIDES = (256, 2048)
    MOST_BYTES = 2**28
    TEXEL_BYTES = 32
    # Factor by which a layer is wider than what it shows.
    WIDENED = 1 + 1 / 32

    def __init__(self, bodies, models, object_frames, camera, height, fit, options):
        self.layers, self.places, self.side = [], {}, self.SIDES[0]
        if not bodies or all(one["draws"] != "lights" for one in LOOK["passes"]):
            return
        self.surround(bodies, models)
        for own in LOOK["lights"]:
            if "light.shadow_map" in own.get("fields", ["light.shadow_map"]):
                self.add(own, object_frames[0], camera, fit, options)
        while self.side < 1.5 * height and self.side < self.SIDES[1]:
            self.side *= 2
        bytes_of_side = self.TEXEL_BYTES * len(self.layers)
        while self.side > self.SIDES[0] and self.side**2 * bytes_of_side > self.MOST_BYTES:
            self.side //= 2

    def surround(self, bodies, models):
        """Finds a sphere around all meshes."""
        places = np.concatenate(placed_of(bodies, models))
        self.center = (places.min(axis=0) + places.max(axis=0)) / 2
        self.radius = max(float(np.sqrt(((places - self.center) ** 2).sum(axis=1)).max()), 1e-20)

    def add(self, own, object_frame, camera, fit, options):
        """Adds the layers of a light. Lights of an object are those of the first object."""
        axes, origin = object_frame
        light = options.get("lights", {}).get(own["id"])
        values = dict(own)
        for parameter in LOOK["parameters"]:
            kind, _, rest = parameter["target"].partition(".")
            of, _, field = rest.rpartition(".")
            given = options.get("parameters", {}).get(parameter["key"])
            if kind == "lights" and of == own["id"] and given is not None:
                values[field] = given
        if light is not None:
            values.update(light_values(own["id"], light, fit @ Y_UP, camera, axes, origin))
        world_from_own = Matrix.Identity(3)
        if own["space"] == "camera":
            world_from_own = camera.to_3x3().transposed()
        elif own["space"] == "object":
            world_from_own = axes
        first = len(self.layers)
        if own["type"] == "directional":
            toward = (world_from_own @ Vector(values["direction"])).normalized()
            place = self.add_sun(np.array(toward))
        else:
            place = world_from_own @ Vector(values["position"])
            place = self.add_lamp(np.array(place + origin if own["space"] == "object" else place))
        self.places[own["id"]] = [*place, float(first)]

    def add_sun(self, toward):
        right, up = map_axes(toward)
        half = self.WIDENED * self.radius
        middle = [right @ self.center, up @ self.center]
        depth = 1.001 * self.radius + 1e-5 * float(np.linalg.norm(self.center))
        self.add_layer(
            [
                [*(right / half), -middle[0] / half],
                [*(up / half), -middle[1] / half],
                [*(toward * (-0.5 / depth)), 0.5 + 0.5 * (toward @ self.center) / depth],
                [0.0, 0.0, 0.0, 1.0],
            ],
            [*toward, 0.0],
            0,
        )
        return [float(middle[0]), float(middle[1]), half]

    def add_lamp(self, place):
        distance = float(np.linalg.norm(self.center - place))
        far = max(1.001 * (distance + self.radius), 1e-20)
        near = max(min((distance - self.radius) / 1.8, 0.5 * far), 1e-4 * far)
        depth = far / (far - near)
        axes = np.eye(3)
        for face in range(6):
            axis = face // 2
            right, up = axes[(axis + 1) % 3], axes[(axis + 2) % 3]
            ahead = axes[axis] * (1.0 if face % 2 == 0 else -1.0)
            measure = np.array([*ahead, -(ahead @ place)])
            self.add_layer(
                [
                    [*(right / self.WIDENED), -(right @ place) / self.WIDENED],
                    [*(up / self.WIDENED), -(up @ place) / self.WIDENED],
                    measure * depth - np.array([0.0, 0.0, 0.0, depth * near]),
                    measure,
                ],
                measure,
                1,
            )
        return [0.0, 0.0, self.WIDENED]

    def add_layer(self, rows, measure, is_lamp):
        clip = np.array([list(row) for row in rows])
        # Depths run from -1 to 1, and rows as in the picture.
        clip[2] = 2.0 * clip[2] - clip[3]
        clip[1] = -clip[1]
        self.layers.append(
            {
                "clip_from_world": [float(x) for x in clip.T.reshape(-1)],
                "measure": [float(x) for x in measure],
                "is_lamp": is_lamp,
                "layer": len(self.layers),
            }
        )


def map_axes(toward):
    """Axes of a directional light's map, to the right and up (Duff et al. 2017)."""
    x, y, z = (float(one) for one in toward)
    side = 1.0 if z > -0.4142 else -1.0
    a = -1.0 / (side + z)
    b = x * y * a
    right = np.array([1.0 + side * x * x * a, side * b, -side * x])
    return right, np.array([b, side + y * y * a, -y])


def object_frame(model, body):
    """The object's axes at length 1, and the middle of its box, in the look's world."""
    linear = model.to_3x3()
    x = linear.col[0].normalized()
    y = linear.col[1] - x * x.dot(linear.col[1])
    y = y.normalized()
    axes = Matrix((x, y, x.cross(y))).transposed()
    return axes, model @ Vector((body.low + body.high) / 2)


def light_values(key, light, look_from_world, camera, axes, center):
    """Fields of a light of the look, in its own frame, as a light of Blender has them."""
    own = next(it for it in LOOK["lights"] if it["id"] == key)
    turned = (look_from_world.to_quaternion(), light.matrix_world.to_quaternion())
    turn = turned[0].to_matrix() @ turned[1].to_matrix()
    place = look_from_world @ light.matrix_world.to_translation()
    toward = turn @ Vector((0, 0, 1))
    own_from_world, origin = Matrix.Identity(3), Vector()
    if own["space"] == "camera":
        own_from_world = camera.to_3x3()
    elif own["space"] == "object":
        own_from_world, origin = axes.transposed(), center
    values = {
        "direction": list(own_from_world @ toward),
        "position": list(own_from_world @ (place - origin)),
        "aim": list(own_from_world @ -toward),
        "color": list(light.data.color),
    }
    # Suns have strengths; lamps have watts, which the look knows nothing of.
    if light.data.type == "SUN":
        values["intensity"] = own["intensity"] * light.data.energy
    return values


def painted_texture(path):
    """The layers of a painted surface, a KTX2 file of one level with 8 bits a channel."""
    with open(path, "rb") as file:
        data = file.read()
    fourth = struct.unpack_from("<I", data, 12)[0] if len(data) > 104 else 0
    if fourth != 37:
        raise ValueError(f"{path} is no texture of Chiaro: export the look again")
    width, height, layers = (struct.unpack_from("<I", data, at)[0] for at in (20, 24, 32))
    start, size = (struct.unpack_from("<Q", data, at)[0] for at in (80, 88))
    numbers = np.frombuffer(data, np.uint8, size, start).astype(np.float32) / 255
    # Arrays have two layers at least here; the last one tells where the others are.
    texels = gpu.types.Buffer("FLOAT", len(numbers), numbers)
    return gpu.types.GPUTexture((width, height), layers=layers, format="RGBA8", data=texels)


def image_texture(about):
    """An image beside this file, its first row first, as it is."""
    path = os.path.join(FOLDER, about["file"])
    if not os.path.isfile(path):
        raise FileNotFoundError(f"{about['file']} is to lie beside {os.path.basename(__file__)}")
    if about["kind"] == "hcbtf":
        return painted_texture(path)
    image = bpy.data.images.load(path, check_existing=False)
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    width, height = image.size
    numbers = np.empty(4 * width * height, np.float32)
    image.pixels.foreach_get(numbers)
    bpy.data.images.remove(image)
    numbers = numbers.reshape(height, width, 4)[::-1]
    if LOOK["colorSpace"] == "linear" and about["encoding"] == "color":
        rgb = numbers[..., :3]
        light = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
        numbers = np.concatenate([light, numbers[..., 3:]], axis=2)
    numbers = np.ascontiguousarray(numbers, np.float32).reshape(-1)
    data = gpu.types.Buffer("FLOAT", len(numbers), numbers)
    return gpu.types.GPUTexture((width, height), format="RGBA32F", data=data)


PLAYER = None


def player():
    """The player, made when something is drawn for the first time."""
    global PLAYER
    if PLAYER is None:
        PLAYER = Player()
    return PLAYER


def start_gpu():
    """Has Blender open the graphics card, which it does not by itself without a window."""
    try:
        gpu.platform.renderer_get()
        return
    except SystemError:
        pass
    # A tiny picture of an empty scene by Workbench.
    scene = bpy.data.scenes.new("chiaro")
    camera = bpy.data.objects.new("chiaro", bpy.data.cameras.new("chiaro"))
    try:
        scene.collection.objects.link(camera)
        scene.camera = camera
        scene.render.engine = "BLENDER_WORKBENCH"
        scene.render.resolution_x = scene.render.resolution_y = 8
        bpy.ops.render.render(scene=scene.name)
        gpu.platform.renderer_get()
    except (RuntimeError, SystemError) as problem:
        raise RuntimeError(
            "Blender could not open the graphics card: render a picture with Workbench first, "
            "outside of handlers, or run Blender where it has OpenGL or Vulkan"
        ) from problem
    finally:
        data = camera.data
        bpy.data.scenes.remove(scene)
        bpy.data.objects.remove(camera)
        bpy.data.cameras.remove(data)


def known_words(words):
    return ", ".join(words) or "none"


def checked_parameters(given):
    """Values of parameters by name, colors of the form `#rrggbb` as numbers."""
    known = {one["key"]: one for one in LOOK["parameters"]}
    found = {}
    for name, value in (given or {}).items():
        if name not in known:
            raise ValueError(f"there is no parameter {name}; there are: {known_words(known)}")
        own = known[name]
        if not own.get("live", True):
            raise ValueError(f"the parameter {name} changes nothing: the export fixed its value")
        if isinstance(value, str):
            is_hex = re.fullmatch(r"#([0-9a-fA-F]{2}){3,4}", value)
            if own["type"] not in ("color", "composite") or not is_hex:
                raise ValueError(f"the parameter {name} cannot be {value!r}")
            value = numbers_of_hex(value)
        numbers = value if hasattr(value, "__iter__") else [value]
        if not all(isinstance(x, (bool, int, float)) or hasattr(x, "__float__") for x in numbers):
            raise ValueError(f"the parameter {name} cannot be {value!r}")
        found[name] = value
    return found


def numbers_of_hex(text):
    numbers = [int(text[at : at + 2], 16) / 255 for at in range(1, len(text), 2)]
    if LOOK["colorSpace"] == "linear":
        decode = lambda x: x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4
        numbers[:3] = [decode(x) for x in numbers[:3]]
    return numbers + [1.0] * (4 - len(numbers))


def checked_lights(given):
    """Lights of the scene by the ids of the look's lights; names of objects stand for them."""
    known = [one["id"] for one in LOOK["lights"]]
    found = {}
    for key, light in (given or {}).items():
        if key not in known:
            raise ValueError(f"the look has no light {key}; it has: {known_words(known)}")
        if isinstance(light, str):
            if light not in bpy.data.objects:
                raise ValueError(f"there is no object {light} for the look's light {key}")
            light = bpy.data.objects[light]
        if light is not None and getattr(light, "type", None) != "LIGHT":
            name = getattr(light, "name", light)
            raise ValueError(f"{name} is no light, which the look's light {key} could follow")
        found[key] = light
    return found


def wear(thing, wears=True):
    """Puts the look on an object, or takes it off."""
    if thing.type not in WEARERS:
        raise ValueError(f"{thing.name} is a {thing.type.lower()} and has no faces to draw")
    if wears:
        thing[STORED] = True
    elif STORED in thing:
        del thing[STORED]


def is_in_renders(thing):
    return not (thing.hide_render or any(one.hide_render for one in thing.users_collection))


def wearers_of(view_layer):
    """Objects that wear the look; all with faces where none does. Not those hidden in renders."""
    # Objects that were just removed are None.
    things = [thing for thing in view_layer.objects if thing and thing.type in WEARERS]
    things = [thing for thing in things if is_in_renders(thing)]
    return [thing for thing in things if thing.get(STORED)] or things


# Places of samples in a pixel, from its middle.
def sample_places(count):
    if count == 4:
        return [(-0.125, -0.375), (0.375, -0.125), (-0.375, 0.125), (0.125, 0.375)]
    # Fractions of two numbers that fill the square evenly (Roberts 2018), the first in the middle.
    return [
        ((0.5 + 0.7548776662 * i) % 1.0 - 0.5, (0.5 + 0.5698402910 * i) % 1.0 - 0.5)
        for i in range(count)
    ]


def render(
    width,
    height,
    objects=None,
    camera=None,
    parameters=None,
    lights=None,
    fit=None,
    samples=4,
):
    """The look on objects of the scene before a camera, at the frame that is set.

    The result is an array of floats, `height` by `width` by 4, the top row first, premultiplied by
    alpha, in the look's own color space. What is not given is as the panel has it: `objects` are
    those that wear the look, or all with faces where none does; `parameters` and `lights` are
    changed by those that are given. `lights` has lights of the scene by the ids of the look's.
    """
    start_gpu()
    scene = bpy.context.scene
    depsgraph = bpy.context.evaluated_depsgraph_get()
    camera = camera or scene.camera
    if camera is None or camera.type != "CAMERA":
        raise ValueError("the scene has no camera: add one, or give one as camera=...")
    if width < 1 or height < 1 or samples < 1:
        raise ValueError("width, height and samples are 1 at least")
    if objects is None:
        objects = wearers_of(bpy.context.view_layer)
    elif isinstance(objects, bpy.types.Object):
        objects = [objects]
    if not objects:
        raise ValueError("the scene has no object with faces that is shown in renders")
    options = options_of(scene)
    options["parameters"] |= checked_parameters(parameters)
    options["lights"] = checked_lights(options["lights"] | (lights or {}))
    if fit is not None:
        options["fit"] = fit
    projection = camera.calc_matrix_camera(depsgraph, x=width, y=height)
    view = camera.matrix_world.normalized().inverted()
    one = player()
    # Meshes may have changed since: no handler tells where the add-on is not registered.
    for thing in objects:
        one.forget(thing)
    total = np.zeros((height, width, 4))
    for options["shift"] in sample_places(samples):
        one.draw(objects, depsgraph, view, projection, (width, height), options)
        with one.targets["draw"].buffer.bind():
            read = gpu.state.active_framebuffer_get().read_color(0, 0, width, height, 4, 0, "FLOAT")
        read.dimensions = width * height * 4
        # The picture was drawn with its rows turned over: the first one is the top.
        total += np.array(read, np.float32).reshape(height, width, 4)
    return (total / samples).astype(np.float32)


def pixels_of(picture):
    """A picture of `render` as straight RGBA of 8 bits, encoded as sRGB."""
    alpha = picture[..., 3:]
    straight = np.where(alpha > 0, picture[..., :3] / np.maximum(alpha, 1e-6), 0)
    if LOOK["colorSpace"] == "linear":
        low, high = 12.92 * straight, 1.055 * np.maximum(straight, 0) ** (1 / 2.4) - 0.055
        straight = np.where(straight <= 0.0031308, low, high)
    whole = np.nan_to_num(np.concatenate([straight, alpha], axis=2))
    return np.floor(255 * np.clip(whole, 0, 1) + 0.5).astype(np.uint8)


def save(path, width, height, **options):
    """Writes what `render` draws as a PNG: straight alpha, sRGB, 8 bits a channel."""
    path = bpy.path.abspath(os.fspath(path))
    if not path.lower().endswith(".png"):
        raise ValueError(f"{path} is to end in .png")
    pixels = pixels_of(render(width, height, **options))

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(
            ">I", zlib.crc32(name + data)
        )

    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    parts = [(b"IHDR", head), (b"sRGB", b"\0"), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + b"".join(chunk(*part) for part in parts))
