//! Panel of the look's picture, with its tools.

use chiaro_locale::text;

use super::table::{PanelPlace, PanelRow, PanelStack};
use crate::commands::PanelId;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::PICTURE,
    text!("Picture"),
    text!("The look on a mesh: drag the lights and the camera"),
    PanelPlace { stack: Some(PanelStack::Picture), ..PanelPlace::CLOSED },
    |bench, ui, context| {
        bench.viewport.show(ui, context.session, bench.picture.as_mut(), &mut bench.tools)
    },
)
.with_interaction(|bench, ui, context| {
    bench.viewport.interact(ui, context.session, &mut bench.tools)
})
.with_jobs(|bench| &bench.viewport);
