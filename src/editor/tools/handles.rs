//! Switch of the lines and handles on the object, which the viewport draws.

use super::table::{SwitchPlace, ToolRow};
use crate::commands::{Command, ViewCommand, table};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Options,
    |tools| tools.has_handles,
    |tools, ui, _| {
        let help = table::help_of(&Command::View(ViewCommand::ToggleHandles));
        ui.checkbox(&mut tools.has_handles, "Handles on the object").on_hover_text(help);
    },
);
