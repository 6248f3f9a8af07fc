//! The parts of docs/accuracy.md about whole looks, still and turning.

use std::fmt::Write as _;

use super::looks::{
    EDGE_SHARE, LARGE_ROWS, LookBound, LookEffort, LookFigures, RARE_INSIDE, place_rounding,
};
use super::report::{AccuracyReport, small, word_of};
use super::stability::{Flicker, ON_SMOOTH, STEP};
use crate::accuracy::error::ErrorFigures;
use crate::document::Tier;

pub(super) fn looks_part(report: &AccuracyReport, text: &mut String, plots: &str) {
    let bound = LookBound::of(Tier::Exact);
    let _ = writeln!(
        text,
        "## Example looks\n\n\
         Each look in its exact tier on a sphere, the creature and a plane, over the sphere of \
         lights and views, near (0.45\n\
         times the distance) and far (20 times), from one pixel to the full picture, the picture's \
         border included. Inside of\n\
         what is drawn no pixel is off by what eight bits can show, 1/255, and the RMS is at most \
         {}; but for one in {:.0},\n\
         which may be off by four times as much: the lines of cartoon edges are a few pixels wide, \
         and in large pictures f32\n\
         has three digits of that.\n\n\
         *Edges* are the pixels beside outlines and folds, and as far from there as the curvature \
         pass looks. Coverage is\n\
         decided on a grid of 1/256 of a pixel, and a vertex that f32 leaves beside the middle \
         between two steps is rounded to\n\
         another one than in f64: then a pixel shows what is behind, and is off by as much as that \
         differs. At most\n\
         {} % of the pixels at edges may be, at any size. A pixel whose middle lies on the border \
         of two\n\
         triangles is like them, as their derivatives differ and patterns may leap there. Where \
         one is off, the truth is made\n\
         again for cameras that stand a step of that grid to each side, and where one of these has \
         what was drawn, the pixel\n\
         counts as on an edge; *settled* says how many did.\n\n\
         Looks that read pictures or painted textures (`examples/images`, `examples/hcbtf`) are \
         not among these, as a sampler's\n\
         filter of eight bits is no formula: how far each is from the truth is on its page of the \
         [gallery](gallery/index.html).\n\
         Nor are looks that send rays (`examples/shadows`): alone they cast shadows on themselves \
         at most, and the f64 walk\n\
         takes minutes. Their shadows are held against rays of an f64 walk of its own in \
         [truth/shadows](../tests/truth/shadows.rs).\n\n\
         ![The largest error of each look]({plots}/looks.svg)\n\n\
         {EXACT_HEAD}",
        small(bound.rms),
        1.0 / RARE_INSIDE,
        100.0 * EDGE_SHARE
    );
    exact_rows(&report.looks, text);
    text.push('\n');
    if !report.large.is_empty() {
        let side = LookEffort::large().side();
        let _ = writeln!(
            text,
            "### At 4096 pixels\n\n\
             The same on the creature, 4096 by 4096 pixels, near and far; compared are the \
             {LARGE_ROWS} rows in the middle.\n\
             f32 rounds a place in the picture to {:.1e} of a pixel here, and the cover of a \
             pattern's edge by as much; with one\n\
             pixel in a hundred on such an edge the RMS may be {}.\n\n\
             {EXACT_HEAD}",
            place_rounding(side),
            small(bound.at(side).rms)
        );
        exact_rows(&report.large, text);
        text.push('\n');
    }
    tiers_part(report, text);
}

const EXACT_HEAD: &str = "| look | pictures | pixels | NaN or inf | largest | RMS | edges | \
                          settled | largest there \
                          | over 1/255 | worst pixel inside |\n\
                          | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | \
                          --- |";

fn exact_rows(looks: &[LookFigures], text: &mut String) {
    for one in looks.iter().filter(|one| one.tier == Tier::Exact) {
        let e = &one.error;
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            one.look,
            one.pictures,
            e.pixels,
            e.broken,
            small(e.max),
            small(e.rms),
            e.edges,
            one.settled,
            small(e.edge_max),
            e.edge_visible,
            one.worst_words
        );
    }
}

fn tiers_part(report: &AccuracyReport, text: &mut String) {
    let [balanced, fast] = [Tier::Balanced, Tier::Fast].map(|tier| small(LookBound::of(tier).rms));
    let _ = writeln!(
        text,
        "### In cheaper tiers\n\n\
         The same pictures with every node in a cheaper tier. *balanced* is held as exact is, but \
         for an RMS of {balanced}: what\n\
         nobody sees. A look with a node that states more than 1/255 is held by an RMS of 5e-2 \
         there. *fast* may take curvature from each triangle's own normals: constant over it, 0 on \
         one that is flat. Where\n\
         a warp works on that, single pixels are off by as much as the warp can do; it is held to \
         be finite everywhere, and to\n\
         an RMS of {fast}. `chiaro tune` keeps such a tier away from looks that show it. A line is \
         left out where the tier draws\n\
         as exact does.\n\n\
         | look | tier | NaN or inf | largest | p99.9 | RMS | over 1/255 | worst pixel inside |\n\
         | --- | --- | ---: | ---: | ---: | ---: | ---: | --- |"
    );
    let exact =
        |look: &str| report.looks.iter().find(|one| one.look == look && one.tier == Tier::Exact);
    let same = |a: &ErrorFigures, b: &ErrorFigures| {
        (a.max, a.rms, a.edge_max) == (b.max, b.rms, b.edge_max)
    };
    for one in report.looks.iter().filter(|one| one.tier != Tier::Exact) {
        let e = &one.error;
        if exact(&one.look).is_some_and(|exact| same(&exact.error, e)) {
            continue;
        }
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {:.2} % | {} |",
            one.look,
            word_of(one.tier),
            e.broken,
            small(e.max),
            small(e.p999),
            small(e.rms),
            100.0 * e.visible as f64 / e.pixels.max(1) as f64,
            one.worst_words
        );
    }
    text.push('\n');
}

pub(super) fn stability_part(report: &AccuracyReport, text: &mut String, plots: &str) {
    let _ = writeln!(
        text,
        "## Temporal stability\n\n\
         Each look in its exact tier; a cheaper one flickers by twice its error above at most. \
         The camera turns by {STEP} rad a frame and the lights by twice that the other way; each \
         pixel's change from frame to\n\
         frame, less the change of its truth, is flicker. *Smooth* is where the truth hardly \
         changes from pixel to pixel\n\
         (at most {}, rounding alone), *edges* are terminators, cartoon edges and the borders that \
         direction keys make (1/255,\n\
         for rounding is multiplied by how steep they are).\n\
         *Silhouettes* are pixels beside outlines and folds, and as far from there as the \
         curvature pass looks: there a pixel\n\
         that is covered or not decides, in either of two frames, and at most {} % may flicker by \
         more. Beside each stands the\n\
         largest change of the truth itself.\n\n\
         ![Flicker of each look]({plots}/stability.svg)\n\n\
         | look | mesh | direction keys | smooth | of | edges | of | silhouettes | of | over 1/255 \
         |\n\
         | --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
        small(ON_SMOOTH),
        200.0 * EDGE_SHARE
    );
    for one in &report.stability {
        let of = |flicker: &Flicker| {
            if flicker.count == 0 {
                "none |".to_owned()
            } else {
                format!("{} | {}", small(flicker.max), small(flicker.truth))
            }
        };
        let keys = if one.has_direction_keys { "yes" } else { "" };
        let (smooth, edges, silhouettes) = (of(&one.smooth), of(&one.edges), of(&one.silhouettes));
        let share = format!("{} of {}", one.silhouettes.visible, one.silhouettes.count);
        let _ = writeln!(
            text,
            "| {} | {} | {keys} | {smooth} | {edges} | {silhouettes} | {share} |",
            one.look, one.mesh
        );
    }
}
