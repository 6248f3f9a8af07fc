// Concave to convex (BADF eq. 7, 8) as a logistic, because (e^2x - 1) / (e^2x + 1) is inf / inf
// from x = 45 on (D6).
import chiaro::types;
import chiaro::numeric;
import chiaro::total;
import chiaro::slope;

/// kappa fit for use: 0 where it is NaN, within +-1e4.
/// @where |kappa| <= 1e4 : kappa
fn kappa_safe(kappa: f32) -> f32 {
    // An infinite curvature keeps its sign; only NaN has none.
    let is_nan = (bitcast<u32>(kappa) & 0x7fffffffu) > 0x7f800000u;
    return select(clamp(kappa, -1e4, 1e4), 0.0, is_nan);
}

/// 2 lambda - 1 = tanh(kappa slope), in [-1, 1].
fn curvature_signed(kappa: f32, slope: f32) -> f32 {
    let a = kappa_safe(kappa) * clamp(finite_or(slope, 0.0), -1e30, 1e30);
    let magnitude = min(abs(a), 50.0);
    if magnitude < 0.0625 {
        // 1 - z cancels for small a; the series does not.
        let a2 = a * a;
        return a * (1.0 - a2 * (0.333333333333333333
            - a2 * (0.133333333333333333 - a2 * 0.0539682539682539683)));
    }
    let z = exp2_stable(-2.0 * LOG2_E * magnitude);
    let t = (1.0 - z) / (1.0 + z);
    return select(-t, t, a >= 0.0);
}

/// kappa times slope, as far as it makes a difference: within +-20; finite.
fn curvature_argument(kappa: f32, slope: f32) -> f32 {
    return clamp(kappa_safe(kappa) * clamp(finite_or(slope, 0.0), -1e30, 1e30), -20.0, 20.0);
}

/// [`curvature_signed`] by the hardware's exponential.
fn curvature_signed_balanced(kappa: f32, slope: f32) -> f32 {
    return 1.0 - 2.0 / (1.0 + exp2(2.0 * LOG2_E * curvature_argument(kappa, slope)));
}

/// [`curvature_signed`] as a fraction: Lambert's continued fraction of tanh down to the fifth
/// power, ended where it would leave [-1, 1].
fn curvature_signed_fast(kappa: f32, slope: f32) -> f32 {
    let a = clamp(curvature_argument(kappa, slope), -3.647, 3.647);
    let y = a * a;
    return clamp(a * (945.0 + y * (105.0 + y)) / (945.0 + y * (420.0 + y * 15.0)), -1.0, 1.0);
}

/// kappa from how the normal changes between the pixels of a quad (docs/math.md 3), in
/// 1/viewport-height: half the divergence of n.xy / n.z, for a normal and a position in camera
/// axes. `perspective` is 1 or 0; `scale` is half of the viewport's height over what it spans at
/// depth 1 (at every depth without perspective). Call it in uniform control flow.
fn curvature_on_screen(normal: vec3f, position: vec3f, perspective: f32, scale: f32) -> f32 {
    let slope = slope_of(normal);
    let place = position.xy / mix(1.0, max(-position.z, 1e-20), perspective);
    // The place's own derivatives tell the pixel's size, and which way the rows run.
    let x = dpdx(vec2f(slope.x, place.x));
    let y = dpdy(vec2f(slope.y, place.y));
    let divergence = x.x / select(x.y, 1e30, x.y == 0.0) + y.x / select(y.y, 1e30, y.y == 0.0);
    return kappa_safe(divergence / scale);
}

/// The view-centered curvature tensor (xx, xy, yy) from how the normal changes between the pixels
/// of a quad, as [`curvature_on_screen`] takes its trace. Call it in uniform control flow.
fn tensor_on_screen(normal: vec3f, position: vec3f, perspective: f32, scale: f32) -> vec3f {
    let slope = slope_of(normal);
    let place = position.xy / mix(1.0, max(-position.z, 1e-20), perspective);
    let x = dpdx(vec3f(slope, place.x));
    let y = dpdy(vec3f(slope, place.y));
    let along_x = x.xy / (select(x.z, 1e30, x.z == 0.0) * 0.5 * scale);
    let along_y = y.xy / (select(y.z, 1e30, y.z == 0.0) * 0.5 * scale);
    return tensor_safe(vec3f(along_x.x, 0.5 * (along_x.y + along_y.x), along_y.y));
}

/// Tensor fit for use: [`kappa_safe`] of each number.
/// @where |tensor| <= 1e4 : tensor
fn tensor_safe(tensor: vec3f) -> vec3f {
    return vec3f(kappa_safe(tensor.x), kappa_safe(tensor.y), kappa_safe(tensor.z));
}

/// The greatest and the least curvature of a tensor (xx, xy, yy): its eigenvalues.
fn principal_curvatures(tensor: vec3f) -> vec2f {
    let mean = 0.5 * (tensor.x + tensor.z);
    let spread = length(vec2f(0.5 * (tensor.x - tensor.z), tensor.y));
    // The curvature nearer 0 would have no digits left as a difference; the product of both, the
    // determinant, gives it.
    let far = mean + select(-spread, spread, mean >= 0.0);
    let near = divided(tensor.x * tensor.z - tensor.y * tensor.y, far);
    return select(vec2f(near, far), vec2f(far, near), mean >= 0.0);
}
