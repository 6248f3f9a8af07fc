//! Switch of the lines and handles on the object, which the viewport draws.

use chiaro_locale::tr;

use super::table::{SwitchPlace, ToolRow};
use crate::commands::{Command, ViewCommand, table};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Options,
    |_| Box::new(HandlesSwitch { is_on: true }),
    |tools| tools.of::<HandlesSwitch>().is_on,
    |tools, ui, _| {
        let help = table::help_of(&Command::View(ViewCommand::ToggleHandles));
        let is_on = &mut tools.of_mut::<HandlesSwitch>().is_on;
        ui.checkbox(is_on, tr!("Handles on the object")).on_hover_text(help);
    },
);

/// State of the switch.
pub(crate) struct HandlesSwitch {
    pub(crate) is_on: bool,
}
