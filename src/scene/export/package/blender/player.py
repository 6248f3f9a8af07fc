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
SIZES = {"position": 3, "normal": 3, "tangent": 4, "uv": 2, "color": 4}

# Blender's textures have no filters or wraps for scripts, so images are filtered here. All images
# of a look have the same.
SAMPLING = """
ivec2 look_texel(ivec2 at, ivec2 size) {
#if WRAP == 0
    return clamp(at, ivec2(0), size - 1);
#elif WRAP == 1
    return (at % size + size) % size;
#else
    ivec2 twice = 2 * size;
    ivec2 turned = (at % twice + twice) % twice;
    return min(turned, twice - 1 - turned);
#endif
}

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
        if any(binding["feed"]["from"] == "image" for binding in self.about["bindings"]):
            image = LOOK["images"][0]
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


class Body:
    """A mesh as the graphics card has it, in axes with y up."""

    def __init__(self, thing, depsgraph):
        evaluated = thing.evaluated_get(depsgraph)
        mesh = evaluated.to_mesh()
        mesh.calc_loop_triangles()
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
            mesh.calc_tangents()
            tangents = self.read(mesh.loops, "tangent", len(vertices), 3)
            signs = self.read(mesh.loops, "bitangent_sign", len(vertices), 1)
            self.arrays["tangent"] = np.hstack([self.turned(tangents), signs])[corners]
        colors = mesh.color_attributes.active_color
        if colors:
            found = self.read(colors.data, "color", len(colors.data), 4)
            is_of_corners = colors.domain == "CORNER"
            self.arrays["color"] = found[corners if is_of_corners else vertices[corners]]
        evaluated.to_mesh_clear()
        used = self.arrays["position"]
        self.low = used.min(axis=0) if len(used) else np.zeros(3)
        self.high = used.max(axis=0) if len(used) else np.zeros(3)
        self.batches = {}

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
        # Lights cast no shadows here: the textures of shadow maps are one texel.
        self.nothing = gpu.types.GPUTexture((1, 1), layers=2, format="RGBA32F")
        self.nothing.clear(format="FLOAT", value=(0.0, 0.0, 0.0, 0.0))
        layout = gpu.types.GPUVertFormat()
        layout.attr_add(id="corner", comp_type="F32", len=2, fetch_mode="FLOAT")
        corners = gpu.types.GPUVertBuf(layout, 3)
        corners.attr_fill("corner", [(-1, -1), (3, -1), (-1, 3)])
        self.screen = gpu.types.GPUBatch(type="TRIS", buf=corners)
        self.size, self.targets, self.bodies = None, {}, {}

    def resize(self, size):
        if self.size == size:
            return
        self.size, self.targets = size, {}
        for one in LOOK["passes"]:
            if one["draws"] == "lights":
                continue
            formats = [FORMATS.get(output["format"], "RGBA16F") for output in one["outputs"]]
            self.targets[one["name"]] = Target(size, formats)

    def body(self, thing, depsgraph):
        key = thing.name_full
        if key not in self.bodies:
            self.bodies[key] = Body(thing, depsgraph)
        return self.bodies[key]

    def forget(self, name):
        self.bodies.pop(name, None)

    def draw(self, things, depsgraph, view, projection, size, options):
        """Draws objects into the player's own picture, which is `self.targets["draw"]`.

        `view` and `projection` are Blender's matrices; `options` has `parameters`, `lights` (light
        objects by the ids of the look's lights), `time`, `frame` and `fit`.
        """
        self.resize(size)
        bodies = [(thing, self.body(thing, depsgraph)) for thing in things]
        bodies = [(thing, body) for thing, body in bodies if len(body.arrays["position"])]
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
        clip = turned @ projection @ Matrix.Scale(1.0 / scale, 4) @ camera
        is_parallel = abs(projection[3][3]) > 0.5
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
        frames = []
        for number, ((thing, body), model) in enumerate(zip(bodies, models)):
            axes, center = object_frame(model, body)
            own = dict(state)
            own["object"] = {"id": number, "axes": columns(axes), "middle": list(center)}
            own["lights"] = {
                key: light_values(key, light, fit @ Y_UP, camera, axes, center)
                for key, light in options.get("lights", {}).items()
                if light is not None
            }
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

    @staticmethod
    def fit(bodies, models):
        """Scale and middle that bring what is drawn to a sphere of radius 1."""
        if not bodies:
            return 1.0, Vector()
        placed = []
        for (_, body), model in zip(bodies, models):
            matrix = np.array(model)
            placed.append(body.arrays["position"] @ matrix[:3, :3].T + matrix[:3, 3])
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
                given = {"view": view_values, "object": values}.get(source, numbers)
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
            if it["binding"] == binding["name"] and it["pass"] in self.targets:
                outputs = next(p for p in LOOK["passes"] if p["name"] == it["pass"])["outputs"]
                names = [output["name"] for output in outputs]
                return self.targets[it["pass"]].colors[names.index(it["output"])]
        return self.nothing


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


def image_texture(about):
    """An image beside this file, its first row first, as it is."""
    path = os.path.join(FOLDER, about["file"])
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


def render(width, height, objects=None, camera=None, parameters=None, lights=None, fit=True):
    """The look on objects before a camera, without a window.

    The result is an array of floats, `height` by `width` by 4, the top row first, premultiplied by
    alpha. `objects` are those of the scene that are visible, where none are named.
    """
    scene = bpy.context.scene
    depsgraph = bpy.context.evaluated_depsgraph_get()
    camera = camera or scene.camera
    if objects is None:
        objects = [thing for thing in scene.objects if thing.type == "MESH" and thing.visible_get()]
    projection = camera.calc_matrix_camera(depsgraph, x=width, y=height)
    options = {
        "parameters": parameters or {},
        "lights": lights or {},
        "fit": fit,
        "time": (scene.frame_current - scene.frame_start) / scene.render.fps,
        "frame": float(scene.frame_current - scene.frame_start),
    }
    view = camera.matrix_world.normalized().inverted()
    one = player()
    one.draw(objects, depsgraph, view, projection, (width, height), options)
    with one.targets["draw"].buffer.bind():
        buffer = gpu.state.active_framebuffer_get().read_color(0, 0, width, height, 4, 0, "FLOAT")
    buffer.dimensions = width * height * 4
    # The picture was drawn with its rows turned over: the first one is the top.
    return np.array(buffer, np.float32).reshape(height, width, 4)
