import chiaro::blue_noise;
import chiaro::screen;

/// Dither
///
/// Cuts a tone into few flat ones and lets single pixels decide between two of them, so that the
/// average stays: pixel art, woodcut grain, bands whose edges are sprinkled. Bayer's matrices make
/// a regular weave; blue noise has neither a pattern nor clumps; white noise is chance.
///
/// @param value "Tone" default=0.5 min=0 max=1 : Below 0 counts as 0, above 1 as 1.
/// @param place "Place" from=pixel : In pixels.
/// @choice pattern "Pattern" default=blue blue="Blue noise" bayer_2="Bayer 2" bayer_4="Bayer 4"
///   bayer_8="Bayer 8" white="White noise" : What decides. Blue noise is a tile of 32 by 32, made
///   by void and cluster; white noise is none.
/// @param levels "Tones" default=2 min=2 max=256 : How many are left.
/// @param spread "Spread" default=1 min=0 max=1 : In how much of the way between two tones pixels
///   decide. At 1 the average is the tone; with less, flat bands are left between sprinkled edges;
///   at 0 edges are hard.
/// @param size "Pixel size" default=1 min=1 max=64 : How many of the picture's pixels go into one
///   of these.
/// @return tone "Tone" : From 0 to 1.
/// @unit
/// @source Bayer 1973; Ulichney 1993, void and cluster
fn dither_blue(value: f32, place: vec2f, levels: i32, spread: f32, size: f32) -> f32 {
    return dithered(value, levels, spread, blue_threshold(dither_cell(place, size)));
}

fn dither_bayer_2(value: f32, place: vec2f, levels: i32, spread: f32, size: f32) -> f32 {
    return dithered(value, levels, spread, bayer_threshold(dither_cell(place, size), 1u));
}

fn dither_bayer_4(value: f32, place: vec2f, levels: i32, spread: f32, size: f32) -> f32 {
    return dithered(value, levels, spread, bayer_threshold(dither_cell(place, size), 2u));
}

fn dither_bayer_8(value: f32, place: vec2f, levels: i32, spread: f32, size: f32) -> f32 {
    return dithered(value, levels, spread, bayer_threshold(dither_cell(place, size), 3u));
}

fn dither_white(value: f32, place: vec2f, levels: i32, spread: f32, size: f32) -> f32 {
    return dithered(value, levels, spread, random_threshold(dither_cell(place, size)));
}
