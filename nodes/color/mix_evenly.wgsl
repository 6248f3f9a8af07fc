import chiaro::types;
import chiaro::color;
import chiaro::total;

/// Mix evenly
///
/// Goes from one colour to another in steps that look even, without the grey or the dark that a plain mix passes through.
///
/// @choice space "Space" default=oklab oklab="Oklab" linear="Linear light" hue="Around the hues" :
///   Oklab is what eyes judge as even; Linear light is how lights mix; Around the hues keeps colours vivid and takes the
///   shorter way around the color wheel.
/// @param a "A" default=0,0,0,1 : Straight RGBA, as on screen.
/// @param b "B" default=1,1,1,1 : The same.
/// @param factor "Factor" default=0.5 min=0 max=1 : 0 is A, 1 is B.
/// @return color "Color" : Straight RGBA, as on screen.
/// @bypass a when factor = 0 : its factor is 0
/// @bypass b when factor = 1 : its factor is 1
/// @source Ottosson 2020
fn mix_evenly_oklab(a: Color, b: Color, factor: f32) -> Color {
    let t = factor_of(factor, true);
    let lab = mixed_vec3(oklab_of_srgb(a.xyz), oklab_of_srgb(b.xyz), t);
    return ends_kept(a, b, t, srgb_of_oklab(lab));
}

fn mix_evenly_linear(a: Color, b: Color, factor: f32) -> Color {
    let t = factor_of(factor, true);
    let light = vec3f(
        mixed(linear_of_srgb(a.x), linear_of_srgb(b.x), t),
        mixed(linear_of_srgb(a.y), linear_of_srgb(b.y), t),
        mixed(linear_of_srgb(a.z), linear_of_srgb(b.z), t),
    );
    return ends_kept(a, b, t, vec3f(srgb_of_linear(light.x), srgb_of_linear(light.y), srgb_of_linear(light.z)));
}

fn mix_evenly_hue(a: Color, b: Color, factor: f32) -> Color {
    let t = factor_of(factor, true);
    let start = oklab_of_srgb(a.xyz);
    let goal = oklab_of_srgb(b.xyz);
    let chroma = vec2f(length_of(vec3f(start.yz, 0.0)), length_of(vec3f(goal.yz, 0.0)));
    // Grey has no hue; it takes the other's.
    let one = angle_of_point(select(start.z, goal.z, chroma.x < 1e-3), select(start.y, goal.y, chroma.x < 1e-3));
    let other = angle_of_point(select(goal.z, start.z, chroma.y < 1e-3), select(goal.y, start.y, chroma.y < 1e-3));
    let apart = other - one;
    let way = apart - 2.0 * PI * round(apart / (2.0 * PI));
    let turned = sin_cos_of(one + t * way);
    let size = mixed(chroma.x, chroma.y, t);
    return ends_kept(a, b, t, srgb_of_oklab(vec3f(mixed(start.x, goal.x, t), size * turned.y, size * turned.x)));
}

/// The mixed colour with its alpha; exactly A and B at the ends, which going to another space and back would round.
fn ends_kept(a: Color, b: Color, t: f32, rgb: vec3f) -> Color {
    let mixed_color = vec4f(bounded_vec3(rgb), mixed(a.w, b.w, t));
    return select(select(mixed_color, bounded_vec4(b), t >= 1.0), bounded_vec4(a), t <= 0.0);
}
