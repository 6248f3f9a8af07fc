import chiaro::marks;
import chiaro::paper;
import chiaro::total;

/// Paper grain
///
/// The tooth of paper: heights catch more ink than hollows, most at middle tones, as chalk,
/// charcoal and a dry wash do. It lies on the picture; with Mark place's Object it moves along with
/// an object and does not swim through it.
///
/// @param value "Tone" default=0.5 min=0 max=1 : 1 is paper, 0 is full ink; both stay as they are.
/// @param place "Place" from=pixel : From Mark place; in pixels where Stretch is not wired.
/// @param stretch "Stretch" default=0,0,0 : From Mark place.
/// @param count "Grains" default=160 min=1 max=2000 : How many there are to the picture's height.
/// @param tooth "Tooth" default=0.5 min=0 max=1 : How rough the paper is.
/// @param fiber "Fiber" default=0.3 min=0 max=1 : How much finer grain there is on the grain.
/// @param seed "Seed" default=0 : Another number, another sheet.
/// @param viewport from=viewport hidden
/// @source Kalnins et al. 2002
fn paper_grain(
    value: f32,
    place: vec2f,
    stretch: vec3f,
    count: f32,
    tooth: f32,
    fiber: f32,
    seed: i32,
    viewport: vec2f,
) -> PaperGrain {
    let height = paper_height(spaced(place, stretch, viewport, count), fiber, bitcast<u32>(seed));
    return PaperGrain(1.0 - caught_ink(1.0 - factor_of(value, true), height, tooth), height);
}

struct PaperGrain {
    /// The tone as the paper shows it.
    tone: f32,
    /// The paper's own height, from 0 to 1: for a bump map, or to tint the paper.
    height: f32,
}
