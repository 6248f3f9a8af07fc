// How much stands near each pixel's surface: the mean over the four by four slices of the pattern
// around it, on the same surface.
import chiaro::horizons;

/// Shares by the slices of single pixels, as [`packed_shares`] packs them.
@group(0) @binding(2) var slices: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return whole_picture(index);
}

@fragment
fn fs_main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let center = seen_pixel(vec2i(position.xy));
    if center.texel.w == 0.0 {
        return vec4f(0.0);
    }
    return packed_shares(joined_shares(center));
}

fn joined_shares(center: SeenPixel) -> NearShares {
    let last = vec2i(textureDimensions(surface)) - 1;
    let normal = normal_of(center.texel);
    let own = plane_of(abs(center.texel.w), center.texel.z, normal);
    var sum = NearShares(vec4f(0.0), vec4f(0.0));
    var weights = 0.0;
    // Half of the outer ones on each side: each place of the pattern counts once.
    let half = PATTERN / 2;
    for (var index = 0; index < (PATTERN + 1) * (PATTERN + 1); index++) {
        let offset = vec2i(index % (PATTERN + 1), index / (PATTERN + 1)) - half;
        let at = center.at + offset;
        if any(at < vec2i(0)) || any(at > last) {
            continue;
        }
        let texel = textureLoad(surface, at, 0);
        let away = vec2f(offset);
        let error = abs(texel.z - own.depth - dot(own.rise, away));
        let tolerance = max(own.tolerance * max(length(away), 1.0), 1e-30);
        let alike = (dot(normal, normal_of(texel)) - LEAST_ALIKE) / (ALIKE - LEAST_ALIKE);
        let sides = select(vec2f(1.0), vec2f(0.5), abs(offset) == vec2i(half));
        let weight = sides.x * sides.y * clamp(2.0 - error / tolerance, 0.0, 1.0)
            * clamp(alike, 0.0, 1.0) * select(0.0, 1.0, abs(texel.w) == own.object);
        let shares = shares_of(textureLoad(slices, at, 0));
        sum.near += weight * shares.near;
        sum.far += weight * shares.far;
        weights += weight;
    }
    let share = 1.0 / max(weights, 1e-6);
    return NearShares(share * sum.near, share * sum.far);
}
