import chiaro::types;
import chiaro::color;
import chiaro::total;

/// Mix evenly
///
/// Goes from one color to another in steps that look even, without the gray or the dark that a
/// plain mix passes through.
///
/// @choice space "Space" default=oklab oklab="Oklab" linear="Linear light" hue="Around the hues" :
///   Oklab is what eyes judge as even; Linear light is how lights mix; Around the hues keeps
///   colors vivid and takes the shorter way around the color wheel.
/// @param a "A" default=0,0,0,1 : Straight RGBA, as on screen.
/// @param b "B" default=1,1,1,1 : The same.
/// @param factor "Factor" default=0.5 min=0 max=1 : 0 is A, 1 is B.
/// @return color "Color" : Straight RGBA, as on screen.
/// @bypass a when factor = 0 : its factor is 0
/// @bypass b when factor = 1 : its factor is 1
/// @source Ottosson 2020
fn mix_evenly_oklab(a: Color, b: Color, factor: f32) -> Color {
    return mixed_in_oklab(a, b, factor_of(factor, true));
}

fn mix_evenly_linear(a: Color, b: Color, factor: f32) -> Color {
    return mixed_in_light(a, b, factor_of(factor, true));
}

fn mix_evenly_hue(a: Color, b: Color, factor: f32) -> Color {
    return mixed_by_hue(a, b, factor_of(factor, true));
}
