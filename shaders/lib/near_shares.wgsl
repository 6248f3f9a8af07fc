// How much of what a surface looks out at stands near, by how near (docs/math.md 6.8): the shares
// of all directions that are blocked within 2, 4, 8 and on to 256 steps of 1/800 of the picture's
// height. From them follows the occlusion between any two distances.
import chiaro::total;

/// Levels of a share: two fit into a number that an f32 holds exactly.
const SHARE_LEVELS = 4096.0;
/// Steps within which things count for each share, and where the next nearer ones end.
const NEAR_ENDS = vec4f(2.0, 4.0, 8.0, 16.0);
const FAR_ENDS = vec4f(32.0, 64.0, 128.0, 256.0);
const NEAR_BEGINS = vec4f(0.0, 2.0, 4.0, 8.0);
const FAR_BEGINS = vec4f(16.0, 32.0, 64.0, 128.0);
/// Steps between both.
const NEAR_WIDTHS = vec4f(2.0, 2.0, 4.0, 8.0);
const FAR_WIDTHS = vec4f(16.0, 32.0, 64.0, 128.0);
/// Least width in steps over which a share is averaged.
const LEAST_WIDTH = 0.05;

/// Shares of directions that are blocked within so many steps.
struct NearShares {
    /// Within 2, 4, 8 and 16 steps.
    near: vec4f,
    /// Within 32, 64, 128 and 256 steps.
    far: vec4f,
}

/// Shares in one texel.
fn packed_shares(shares: NearShares) -> vec4f {
    let most = SHARE_LEVELS - 1.0;
    let near = floor(clamp(shares.near, vec4f(0.0), vec4f(1.0)) * most + 0.5);
    return near * SHARE_LEVELS + floor(clamp(shares.far, vec4f(0.0), vec4f(1.0)) * most + 0.5);
}

/// The shares that a texel holds.
fn shares_of(texel: vec4f) -> NearShares {
    let packed = clamp(bounded_vec4(texel), vec4f(0.0), vec4f(SHARE_LEVELS * SHARE_LEVELS - 1.0));
    let near = floor(packed / SHARE_LEVELS);
    let share = 1.0 / (SHARE_LEVELS - 1.0);
    return NearShares(near * share, (packed - SHARE_LEVELS * near) * share);
}

/// The sum of the shares within all distances up to so many steps: a share runs straight from one
/// distance to the next, and what lies beyond the last is not known to be blocked.
fn share_sum(shares: NearShares, steps: f32) -> f32 {
    let nearer = vec4f(0.0, shares.near.xyz);
    let farther = vec4f(shares.near.w, shares.far.xyz);
    let near_parts = clamp((steps - NEAR_BEGINS) / NEAR_WIDTHS, vec4f(0.0), vec4f(1.0));
    let far_parts = clamp((steps - FAR_BEGINS) / FAR_WIDTHS, vec4f(0.0), vec4f(1.0));
    let near_means = nearer + 0.5 * near_parts * (shares.near - nearer);
    let far_means = farther + 0.5 * far_parts * (shares.far - farther);
    return dot(NEAR_WIDTHS, near_parts * near_means) + dot(FAR_WIDTHS, far_parts * far_means)
        + max(steps - FAR_ENDS.w, 0.0) * shares.far.w;
}

/// The share of all directions in which something stands near, where things count in full up to
/// `near` and less and less up to `far`, in steps. That is the mean of the shares between both.
fn occlusion_within(shares: NearShares, near: f32, far: f32) -> f32 {
    let first = clamp(near, 0.0, 1e4);
    let last = max(clamp(far, 0.0, 1e4), first + LEAST_WIDTH);
    return clamp((share_sum(shares, last) - share_sum(shares, first)) / (last - first), 0.0, 1.0);
}

/// Steps to a unit of the scene, where a unit is seen so many picture heights large.
fn steps_to_unit(viewport_height: f32, magnification: f32) -> f32 {
    let height = clamp(bounded(viewport_height), 0.0, 1e6);
    return clamp(bounded(magnification), 0.0, 1e15) * height / max(round(height / 800.0), 1.0);
}
