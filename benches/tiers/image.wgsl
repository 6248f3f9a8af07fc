fn nothing(n: vec3f, l: vec3f, s: f32) -> f32 {
    return n.x + s;
}

fn exact(n: vec3f, l: vec3f, s: f32) -> f32 {
    return textureSample(image, linear_sampler, n.xy).x;
}

fn nearest(n: vec3f, l: vec3f, s: f32) -> f32 {
    return textureSample(image, nearest_sampler, n.xy).x;
}

/// Sampling without derivatives, which one level of detail does not need.
fn at_level_0(n: vec3f, l: vec3f, s: f32) -> f32 {
    return textureSampleLevel(image, linear_sampler, n.xy, 0.0).x;
}

fn loaded(n: vec3f, l: vec3f, s: f32) -> f32 {
    return textureLoad(image, vec2i(fract(n.xy) * 512.0), 0).x;
}
