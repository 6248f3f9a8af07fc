//! Painted shading recovers known looks: painted from a hidden look's own picture, the fitted one is the same on a view
//! that was not painted.

#[path = "fit/hidden.rs"]
mod hidden;
mod support;

use chiaro::clock::Clock;
use chiaro::document::Look;
use chiaro::fit::{FitOptions, Fitted, Target, fit_layers};
use chiaro::hcbtf::Progress;
use chiaro::library::Library;

use hidden::{Hidden, difference, hidden, painted, setup_of};

/// A look that knows nothing: a grey base.
fn nothing() -> Look {
    let text = r#"{"chiaro": "look", "version": 1, "name": "From nothing",
        "nodes": [{"id": "base", "kind": "base", "values": {"color": [0.5, 0.5, 0.5]}}, {"id": "output", "kind": "output"}],
        "wires": [{"from": "base.below", "to": "output.color"}]}"#;
    Look::read(text, "nothing.json").value.unwrap()
}

fn from_nothing(hidden: &Hidden, target: &Target) -> Fitted {
    let setup = setup_of(nothing(), hidden.mesh);
    let (options, progress) = (FitOptions::default(), Progress::new());
    fit_layers(&setup, 0, Library::built_in(), target, hidden.layers, &options, &progress).unwrap()
}

/// How far a fitted look may be from the hidden one on the new view.
const NEAR: f64 = 2.0 / 255.0;

/// The proof: `cargo test --release --test fit -- --ignored --nocapture`.
#[test]
#[ignore = "minutes; `the_fit_recovers_hidden_looks` is the quick part of it"]
fn the_rate_over_fifty_hidden_looks() {
    let range = std::env::var("CHIARO_FIT").unwrap_or_default();
    let (first, count) = range.split_once('+').map_or((0, 50), |(a, b)| (a.parse().unwrap(), b.parse().unwrap()));
    let mut near = 0;
    for number in first..first + count {
        let hidden = hidden(number);
        let target = painted(&hidden.look, hidden.mesh);
        let clock = Clock::start();
        let fitted = from_nothing(&hidden, &target);
        let seconds = clock.seconds();
        let difference = difference(&hidden.look, &fitted.look, hidden.mesh);
        near += u64::from(difference < NEAR);
        println!(
            "{number:2} {:14} {} layers: painted view {:.2} -> {:.2}, new view {:.2} of 255 {} ({:.1} s)",
            hidden.mesh,
            hidden.layers,
            255.0 * fitted.report.before,
            255.0 * fitted.report.after,
            255.0 * difference,
            if difference < NEAR { "" } else { "MISSED" },
            seconds,
        );
        if difference >= NEAR {
            hidden.told.iter().for_each(|layer| println!("     hidden {layer}"));
            fitted
                .report
                .changed
                .iter()
                .for_each(|change| println!("     {} {}: {}", change.what, change.place, change.to));
        }
    }
    println!("{near} of {count} are within 2/255 RMS on the new view");
}
