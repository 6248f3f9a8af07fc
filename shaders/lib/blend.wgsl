// Laying a layer over what is below (BADF eq. 2; decision D8): the layer's color is straight, the
// stack below is premultiplied, opacity 0 changes nothing in any mode, and what is opaque stays
// opaque.
import chiaro::types;

/// Mix from `below` to `blended` by `opacity`, with `alpha` as its alpha; clamped to [0, 1] if
/// `clamped`. At opacity 0 the result is exactly `below`, whatever that is.
/// @where opacity = 1 and below is finite and blended is finite :
///   select(vec4f(blended, alpha), clamp(vec4f(blended, alpha), vec4f(0.0), vec4f(1.0)), clamped)
fn blend_finish(below: Composite, blended: vec3f, alpha: f32, opacity: f32,
    clamped: bool) -> Composite {
    if opacity <= 0.0 {
        return below;
    }
    let mixed = vec4f(below.xyz + opacity * (blended - below.xyz), alpha);
    return select(mixed, clamp(mixed, vec4f(0.0), vec4f(1.0)), clamped);
}
