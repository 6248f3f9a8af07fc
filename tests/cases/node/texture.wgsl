// Ours.
@group(0) @binding(9) var t: texture_2d<f32>; fn f(x: f32) -> f32 { return f32(textureDimensions(t).x); }