//! A look's cost is halved without a visible difference: tiers are measured, the cheapest tier
//! within 1/255 is adopted from the panel, and the truth in f64 agrees.
#![allow(clippy::print_stdout, reason = "times are told, and judged by nobody")]

use chiaro::accuracy::{MeasuredTier, MeasurementRow, MeasurementSubject};
use chiaro::document::Tier;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;

use super::artist::{JourneyUser, Studio};

/// Cost and error of the whole look in each tier.
fn whole(artist: &JourneyUser) -> Vec<MeasurementRow> {
    let report = artist.app().cost().report().expect("it was measured");
    report
        .rows
        .iter()
        .filter(|row| {
            row.subject == MeasurementSubject::Whole && matches!(row.tier, MeasuredTier::Named(_))
        })
        .cloned()
        .collect()
}

/// Counted sizes of a row: bytes that a frame moves, and instructions.
fn counted(row: &MeasurementRow) -> (u64, u64) {
    let sizes = row.sizes.as_ref().expect("sizes are counted");
    (sizes.traffic, sizes.instructions)
}

#[test]
fn a_look_is_made_half_as_dear_within_1_of_255() {
    let studio = Studio::new();
    let mut artist = studio.window();
    artist.app_mut().show_on("shape:sphere");
    artist.settle();
    // A look of soft layers, warmed a little where the surface is convex. Two passes make that
    // curvature.
    artist.press("Layer Diffuse");
    artist.press("Add layer");
    artist.press("Add Highlight");
    artist.press("Layer Diffuse");
    artist.set_color("Convex color", "#b58a6a");
    artist.set_color("Concave color", "#b4886a");
    artist.set("Shape slope", "0.2");
    assert!(artist.errors().is_empty(), "{:?}", artist.errors());
    artist.tab("Cost and accuracy");
    artist.press("Measure");
    let rows = whole(&artist);
    let exact = rows.iter().find(|row| row.tier == MeasuredTier::Named(Tier::Exact)).unwrap();
    let within =
        rows.iter().filter(|row| row.max_error().is_some_and(|error| error <= 1.0 / 255.0));
    let best = within.min_by_key(|row| counted(row)).expect("exact is within").clone();
    for row in &rows {
        let [time, error] = [row.time.median, row.max_error().unwrap()];
        let (bytes, instructions) = counted(row);
        println!(
            "{:?}: {bytes} bytes, {instructions} instructions, {time:.2} ms, error {error:.1e}",
            row.tier
        );
    }
    let ((bytes, instructions), (all_bytes, all_instructions)) = (counted(&best), counted(exact));
    assert!(2 * bytes <= all_bytes, "{bytes} of {all_bytes} bytes");
    assert!(instructions < all_instructions, "{instructions} of {all_instructions} instructions");

    // The tier is adopted by its row, as one step of the look.
    let word = best.tier.word();
    let (steps, label) = (artist.steps(), format!("Adopt {word} for Whole look"));
    let plot = artist.place("Error against time").center();
    for _ in 0..20 {
        if artist.has(&label) && artist.place(&label).max.y < 858.0 {
            break;
        }
        artist.wheel(plot, -30.0);
    }
    artist.press(&label);
    assert_eq!((artist.look().tier, artist.steps()), (best.tier.of_look(), steps + 1));

    // The comparison is asked of the panel: the picture in the adopted tier against the truth in
    // f64.
    let lists = artist.harness.get_all_by_role(Role::ComboBox);
    let list = lists.into_iter().find(|node| node.value().as_deref() == Some("Compare"));
    let at = list.expect("the list of what to compare with").rect().center();
    artist.click(at);
    artist.press("Truth (f64)");
    let figures = artist.app().wipe().figures().expect("it was compared").clone();
    assert!(figures.pixels > 10_000 && figures.broken == 0, "{figures:?}");
    assert!(figures.max <= 1.0 / 255.0, "{figures:?}");
    studio.finish(artist, "cheap.json");
}
