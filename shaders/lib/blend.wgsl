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

/// Straight color below, for paint modes: never more than a million, whatever light lies over
/// nothing.
fn color_below(below: Composite) -> vec3f {
    return clamp(below.xyz / max(below.w, 1e-6), vec3f(-1e6), vec3f(1e6));
}

/// A layer that covers as *Alpha* does, in its own color where nothing is below, and in the color
/// `mixed` of a paint mode where something is (W3C Compositing and Blending 1, section 5).
fn blend_painted(below: Composite, color: Color, mixed: vec3f, tone: f32, opacity: f32,
    clamped: bool) -> Composite {
    let a = opacity * color.w;
    let paint = (1.0 - below.w) * color.xyz + below.w * mixed;
    let alpha = below.w + tone * a * (1.0 - below.w);
    return blend_finish(below, below.xyz + tone * (paint - below.xyz), alpha, a, clamped);
}

// Contributions of a stack's steps. A step that turns `below` into `above` lets a share of what is
// below through and adds the rest: channel by channel `above` is `through * below` and what is
// added. The step's mode says what is let through; where that would be more than what is left, as
// under a clamp or where a step darkens, what is let through is what is left. So nothing that is
// added is negative, and sums give back `above`.

/// The share of what is below that a layer of *Blend* lets through in its mode: 0 all that is left
/// of it, 1 multiply, 2 alpha, 3 shade, 4 screen.
fn blend_passage(mode: i32, color: Color, tone: f32, opacity: f32) -> vec3f {
    let a = clamp(opacity * color.w, 0.0, 1.0);
    if mode == 1 {
        return mix(vec3f(1.0), clamp(tone * color.xyz, vec3f(0.0), vec3f(1.0)), a);
    }
    if mode == 2 {
        return vec3f(clamp(1.0 - a * tone, 0.0, 1.0));
    }
    if mode == 3 {
        let shade = mix(vec3f(1.0), color.xyz, tone);
        return mix(vec3f(1.0), clamp(shade, vec3f(0.0), vec3f(1.0)), a);
    }
    if mode == 4 {
        return 1.0 - clamp(a * tone * color.xyz, vec3f(0.0), vec3f(1.0));
    }
    return vec3f(1.0);
}

/// All of what is below where it is at least as great, else nothing of it.
fn greater_passage(below: Composite, above: Composite) -> vec3f {
    return select(vec3f(1.0), vec3f(0.0), above.xyz > below.xyz);
}

/// The share of what is below that a step lets through: `asked`, or less where less is left.
fn let_through(below: Composite, above: Composite, asked: vec3f) -> vec3f {
    let some = max(below.xyz, vec3f(1e-30));
    let left = clamp(above.xyz / some, vec3f(0.0), vec3f(1.0));
    return select(asked, left, above.xyz < asked * below.xyz);
}

/// The rest that a step adds which lets this share of what is below through; 0 or more.
fn added_over(below: Composite, above: Composite, through: vec3f) -> vec3f {
    return max(above.xyz - through * below.xyz, vec3f(0.0));
}

/// The part that a stack's lowest color adds where this share of it is let through; 0 or more.
fn held_back(color: Composite, through: vec3f) -> vec3f {
    return max(color.xyz, vec3f(0.0)) * through;
}

/// The share that both of two let through, or of a color the part that one does.
fn both_through(a: vec3f, b: vec3f) -> vec3f {
    return a * b;
}

/// Two contributions together.
fn sum_of_both(a: vec3f, b: vec3f) -> vec3f {
    return a + b;
}

// Shares of what a step adds, among the lights that it comes of. The parts of a share add up to it.

/// A number as the channels of a color.
fn channels_of_number(number: f32) -> vec3f {
    return vec3f(number);
}

/// The channels of a color.
fn channels_of_color(color: Color) -> vec3f {
    return color.xyz;
}

/// The part of a share that a part of a whole has; nothing where the whole is nothing.
fn share_of_part(share: vec3f, part: vec3f, whole: vec3f) -> vec3f {
    let some = max(whole, vec3f(1e-30));
    let proportion = clamp(part / some, vec3f(0.0), vec3f(1.0));
    return share * select(vec3f(0.0), proportion, whole > vec3f(0.0));
}

/// The rest of a share beside a part.
fn rest_of_share(share: vec3f, part: vec3f) -> vec3f {
    return max(share - part, vec3f(0.0));
}

/// All of a share where another is not greater, else nothing of it.
fn share_of_winner(share: vec3f, own: vec3f, other: vec3f) -> vec3f {
    return select(share, vec3f(0.0), other > own);
}

/// The part of a share that a color's alpha leaves to what is below.
fn share_of_below(share: vec3f, below: Composite, color: Color, layers: Composite) -> vec3f {
    return share_of_part(share, below.xyz * clamp(1.0 - color.w, 0.0, 1.0), layers.xyz);
}

/// The part of a share that a part of all weights has.
fn share_of_weight(share: vec3f, part: vec3f, weight: f32, weights: f32, whole: vec3f) -> vec3f {
    return share_of_part(share, part * clamp(weight / max(weights, 1e-30), 0.0, 1.0), whole);
}

/// The part of a share that what is mixed has by a factor that leads away from it.
fn share_of_mixed(share: vec3f, part: vec3f, factor: f32, whole: vec3f) -> vec3f {
    return share_of_part(share, part * clamp(1.0 - factor, 0.0, 1.0), whole);
}

/// All of a share where a light is the one that was taken, else nothing of it.
fn share_of_light(share: vec3f, own: Light, taken: Light) -> vec3f {
    let is_own = all(own.direction == taken.direction) & all(own.color == taken.color)
        & (own.intensity == taken.intensity);
    return select(vec3f(0.0), share, is_own);
}
