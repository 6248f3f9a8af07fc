import chiaro::types;
import chiaro::curve;
import chiaro::color;
import chiaro::total;
import chiaro::antialias;

/// Color ramp
///
/// Turns a number into a color along a ramp: a tone into paint. Before the first stop and after
/// the last one the color stays; the edges of a stepped ramp are antialiased.
///
/// @choice space "Between colors" default=plain plain="Plain" oklab="Oklab" light="Linear light"
///   hue="Around the hues" hsv="HSV" : How two stops mix. Plain takes the numbers as they are;
///   Oklab is even to the eye; Linear light is how lights mix; Around the hues and HSV keep colors
///   vivid and take the shorter way around the color wheel, evenly to the eye or not.
/// @param value "Value" default=0 : Where on the ramp; a tone goes from 0 to 1.
/// @param ramp "Ramp" : Its colors, at most 16.
/// @return color "Color" : Straight RGBA.
/// @opaque
/// @source Ottosson 2020 for Oklab
fn ramp_plain(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    return ramp_at(ramp, bounded(value), w);
}

fn ramp_oklab(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    if ramp.interpolation == INTERPOLATION_STEPPED {
        return ramp_at(ramp, bounded(value), w);
    }
    let place = ramp_place(ramp, bounded(value));
    return mixed_in_oklab(place.before, place.after, place.t);
}

fn ramp_light(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    if ramp.interpolation == INTERPOLATION_STEPPED {
        return ramp_at(ramp, bounded(value), w);
    }
    let place = ramp_place(ramp, bounded(value));
    return mixed_in_light(place.before, place.after, place.t);
}

fn ramp_hue(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    if ramp.interpolation == INTERPOLATION_STEPPED {
        return ramp_at(ramp, bounded(value), w);
    }
    let place = ramp_place(ramp, bounded(value));
    return mixed_by_hue(place.before, place.after, place.t);
}

fn ramp_hsv(value: f32, ramp: Ramp) -> Color {
    let w = footprint_of(value);
    if ramp.interpolation == INTERPOLATION_STEPPED {
        return ramp_at(ramp, bounded(value), w);
    }
    let place = ramp_place(ramp, bounded(value));
    return mixed_in_hsv(place.before, place.after, place.t);
}
