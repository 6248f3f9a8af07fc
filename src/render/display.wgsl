// What a display shows of the picture: its light, taken out of the numbers that the curve of sRGB
// shows, by the function that follows this text, of a DisplayModule.

@group(0) @binding(0) var picture: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    // One triangle over the whole picture.
    let corner = vec2f(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4f(2.0 * corner - 1.0, 0.0, 1.0);
}

/// Light of numbers as shown (IEC 61966-2-1), the same on both sides of 0, as EXRs are written.
fn light_of(shown: vec3f) -> vec3f {
    let c = abs(shown);
    let low = c / 12.92;
    let high = pow((c + 0.055) / 1.055, vec3f(2.4));
    return sign(shown) * select(high, low, c <= vec3f(0.04045));
}

@fragment
fn fs_main(@builtin(position) place: vec4f) -> @location(0) vec4f {
    let pixel = textureLoad(picture, vec2u(place.xy), 0);
    if pixel.w <= 0.0 {
        return vec4f(0.0);
    }
    let light = light_of(pixel.xyz / pixel.w);
    // Some of ACES 1's steps divide by what black is exactly; a trillionth of white is as black.
    let is_black = all(abs(light) < vec3f(1e-12));
    let shown = shown_by_view(vec4f(select(light, vec3f(1e-12), is_black), 1.0));
    return vec4f(shown.xyz * pixel.w, pixel.w);
}
