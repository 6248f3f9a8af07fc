@tool
extends GeometryInstance3D
## What looks made by Chiaro have in common. Each object has a material of its own, whose uniforms
## follow the camera, the object, the lights and the parameters of the look.
##
## Nothing is saved in the scene but what is set in the inspector.

@export_group("Surroundings")
## Rotation that turns the lights of the look together.
@export var illumination := Basis.IDENTITY
## Number that tells this object from others, for looks that ask for it.
@export var object_id := 0
## Seconds, for looks that change with time.
@export var time := 0.0

## Material that draws the object.
var material := ShaderMaterial.new()

var _last := []
var _is_started := false


func _init() -> void:
	# A script that is put on a node of the tree, as the editor does, is not told that it is ready.
	_start.call_deferred()


func _ready() -> void:
	_start()


func _start() -> void:
	if _is_started or not is_inside_tree():
		return
	_is_started = true
	material.shader = _shader()
	var images := _images()
	for image: StringName in images:
		material.set_shader_parameter(image, images[image])
	RenderingServer.instance_geometry_set_material_override(get_instance(), material.get_rid())
	# What moves lights, cameras and objects in a frame comes first.
	process_priority = 1000
	set_process(true)
	update()


func _process(_delta: float) -> void:
	if is_visible_in_tree():
		update()


## Brings the material up to date, before each frame. Call this after a change that has to be seen
## in the same frame.
func update() -> void:
	var around := _surroundings()
	var settings := _settings(around)
	var state := [around, settings]
	if state == _last:
		return
	_last = state
	var uniforms := _uniforms(settings, around)
	for uniform: StringName in uniforms:
		material.set_shader_parameter(uniform, uniforms[uniform])


func _shader() -> Shader:
	return null


func _images() -> Dictionary:
	return {}


## Parameters and lights, as the host work takes them.
func _settings(_around: Dictionary) -> Dictionary:
	return {}


func _uniforms(_settings: Dictionary, _around: Dictionary) -> Dictionary:
	return {}


## The camera that looks at the object; the editor's own while the scene is edited.
func _camera() -> Camera3D:
	if Engine.is_editor_hint():
		return Engine.get_singleton("EditorInterface").get_editor_viewport_3d(0).get_camera_3d()
	return get_viewport().get_camera_3d()


func _surroundings() -> Dictionary:
	var camera := _camera()
	var view := camera.global_transform if camera else Transform3D(Basis.IDENTITY, Vector3(0, 0, 4))
	var is_parallel := camera and camera.projection == Camera3D.PROJECTION_ORTHOGONAL
	var axes := global_basis.orthonormalized()
	axes.z = axes.x.cross(axes.y)
	return {
		illumination = columns_of(illumination),
		camera_from_world = columns_of(view.basis.orthonormalized().transposed()),
		eye = numbers_of(view.origin),
		parallel = numbers_of(view.basis.z.normalized() if is_parallel else Vector3.ZERO),
		object_axes = columns_of(axes),
		object_middle = numbers_of(global_transform * get_aabb().get_center()),
		object_id = float(object_id),
		viewport = numbers_of(get_viewport().get_texture().get_size()),
		time = time,
		frame = 0.0,
	}


## A light of the look: `own` are the look's values, `given` those of parameters, and `lamp` is a
## light of the scene that takes the light's place, or none, or one that was freed.
static func light_of(
	own: Dictionary, given: Dictionary, lamp: Variant, around: Dictionary
) -> Dictionary:
	var light := own.merged(given, true)
	light.merge({aimed_at = [0.0, 0.0, 0.0, 0.0], shadow_map = [0.0, 0.0, 1.0, -1.0]})
	if not is_instance_valid(lamp) or not lamp.is_inside_tree():
		return light
	var followed: Light3D = lamp
	var axes := Basis.IDENTITY
	var origin := Vector3.ZERO
	match own.space:
		"illumination":
			axes = basis_of(around.illumination)
		"camera":
			axes = basis_of(around.camera_from_world).transposed()
		"object":
			axes = basis_of(around.object_axes)
			origin = Vector3(
				around.object_middle[0], around.object_middle[1], around.object_middle[2]
			)
	var to_own := axes.transposed()
	var toward := followed.global_basis.z.normalized()
	light.direction = numbers_of(to_own * toward)
	light.aim = numbers_of(to_own * -toward)
	light.position = numbers_of(to_own * (followed.global_position - origin))
	light.color = numbers_of(followed.light_color).slice(0, 3)
	light.intensity = followed.light_energy if followed.is_visible_in_tree() else 0.0
	if followed is SpotLight3D:
		var wide: float = deg_to_rad(followed.spot_angle)
		light.inner = wide * own.inner / maxf(own.outer, 1e-6)
		light.outer = wide
	return light


## The numbers of a vector or a color. Those of Godot have 32 bits, and arrays of numbers 64.
static func numbers_of(value: Variant) -> Array:
	match typeof(value):
		TYPE_COLOR:
			return [value.r, value.g, value.b, value.a]
		TYPE_VECTOR2:
			return [value.x, value.y]
		TYPE_VECTOR3:
			return [value.x, value.y, value.z]
		TYPE_VECTOR4:
			return [value.x, value.y, value.z, value.w]
	return [value]


## The columns of a basis.
static func columns_of(basis_: Basis) -> Array:
	return [numbers_of(basis_.x), numbers_of(basis_.y), numbers_of(basis_.z)]


static func basis_of(columns: Array) -> Basis:
	var axis := func(i: int) -> Vector3: return Vector3(columns[i][0], columns[i][1], columns[i][2])
	return Basis(axis.call(0), axis.call(1), axis.call(2))


## Uniforms of the numbers of the look, from one of them on.
static func vector2_at(n: Array, at: int) -> Vector2:
	return Vector2(n[at], n[at + 1])


static func vector3_at(n: Array, at: int) -> Vector3:
	return Vector3(n[at], n[at + 1], n[at + 2])


static func vector4_at(n: Array, at: int) -> Vector4:
	return Vector4(n[at], n[at + 1], n[at + 2], n[at + 3])


static func color_at(n: Array, at: int) -> Color:
	return Color(n[at], n[at + 1], n[at + 2], n[at + 3])


## Columns lie four numbers apart.
static func basis_at(n: Array, at: int) -> Basis:
	return Basis(vector3_at(n, at), vector3_at(n, at + 4), vector3_at(n, at + 8))
