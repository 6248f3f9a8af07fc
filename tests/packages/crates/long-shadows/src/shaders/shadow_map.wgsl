// Long shadows: made by Chiaro 0.1.0, WGSL.
// Draws what each light sees first.
// Bindings of group 0: light 0, caster 1.
// look.rs says what to put there.

// What a light sees of an object, as the passes of shadow maps draw it: how near to the light the
// nearest surface is at each texel, the number of its object from 1 on, and how the nearness
// changes to the next texels.

/// A layer of the maps.
struct LightView {
    /// From world space to the layer, x to the right and y up, z from 0 (near) to 1 (far).
    clip_from_world: mat4x4f,
    /// Row that gives the height toward a directional light, or the depth from a lamp.
    measure: vec4f,
    /// 1 for a lamp, whose nearness is 1 over the depth; else 0.
    is_lamp: f32,
    /// Number of the layer.
    layer: f32,
}

/// An object that casts shadows.
struct LightCaster {
    world_from_object: mat4x4f,
    /// Number of the object, from 1 on.
    number: f32,
}

@group(0) @binding(0) var<uniform> light: LightView;
@group(0) @binding(1) var<uniform> caster: LightCaster;

struct SeenByLight {
    @builtin(position) clip: vec4f,
    @location(0) measure: f32,
}

/// A vertex as the light sees it.
fn seen_by_light(position: vec3f) -> SeenByLight {
    let world = caster.world_from_object * vec4f(position, 1.0);
    return SeenByLight(light.clip_from_world * world, dot(light.measure, world));
}

/// A texel of the map.
fn light_texel(measure: f32) -> vec4f {
    let nearness = select(measure, 1.0 / max(measure, 1e-20), light.is_lamp > 0.5);
    return vec4f(nearness, caster.number, dpdx(nearness), dpdy(nearness));
}
// What each light sees first.
                          

@vertex
fn vs_main(@location(0) position: vec3f) -> SeenByLight {
    return seen_by_light(position);
}

@fragment
fn fs_main(in: SeenByLight) -> @location(0) vec4f {
    return light_texel(in.measure);
}
