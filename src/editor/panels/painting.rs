//! Panels in which an HCBTF is painted. Light that is painted on the picture: `panels::fit`.

use chiaro_locale::text;

use super::table::{PanelPlace, PanelRow, Presence};
use crate::commands::PanelId;

pub(super) const PAINT: PanelRow = PanelRow::new(
    PanelId::PAINT,
    text!("Paint"),
    text!("A surface that changes with the light and the eye, to be painted on (HCBTF)"),
    PanelPlace { beside: &[PanelId::GRAPH], is_for_painting: true, ..PanelPlace::CLOSED },
    |bench, ui, context| bench.painting.show_tile(ui, context.session),
)
.with_interaction(|bench, ui, context| bench.painting.interact(ui, context.session))
.with_each_frame(|bench, _, _, presence| {
    if presence != Presence::Seen {
        bench.painting.rest();
    }
    Vec::new()
})
.with_jobs(|bench| &bench.painting);

pub(super) const SAMPLES: PanelRow = PanelRow::new(
    PanelId::SAMPLES,
    text!("Samples"),
    text!(
        "All lights and views of what is painted at a glance: go from one to another, copy, delete"
    ),
    PanelPlace {
        is_for_painting: true,
        beside: &[
            PanelId::PROFILE,
            PanelId::KEYS,
            PanelId::CODE,
            PanelId::EFFECTS,
            PanelId::PROBLEMS,
        ],
        ..PanelPlace::CLOSED
    },
    |bench, ui, context| bench.painting.show_samples(ui, context.session),
);

pub(super) const SHEET: PanelRow = PanelRow::new(
    PanelId::SHEET,
    text!("Sheet"),
    text!(
        "All of what is painted and filled in one picture, as the thesis lays it out; tells what \
         lies where"
    ),
    PanelPlace { beside: &[PanelId::PAINT, PanelId::GRAPH], ..PanelPlace::CLOSED },
    |bench, ui, context| bench.painting.show_sheet(ui, context.session),
);

pub(super) const DIRECTIONS: PanelRow = PanelRow::new(
    PanelId::DIRECTIONS,
    text!("Light and eye"),
    text!("Where the light and the eye are that you paint for, and what is painted already"),
    PanelPlace { is_for_painting: true, ..PanelPlace::WITH_DOCUMENT.closed() },
    |bench, ui, context| bench.painting.show_directions(ui, context.session),
);

pub(super) const RULES: PanelRow = PanelRow::new(
    PanelId::RULES,
    text!("Fill rules"),
    text!("The rules that fill the lights and views that nobody painted"),
    PanelPlace { beside: &[PanelId::INSPECTOR], is_for_painting: true, ..PanelPlace::CLOSED },
    |bench, ui, context| bench.painting.show_rules(ui, context.session),
);
