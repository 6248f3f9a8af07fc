//! Rows of commands of the timeline and of the open shot, whose panels have the buttons.

use chiaro_locale::{Text, text};

use super::{CommandRow, KeyScope, row};
use crate::commands::{Command as C, PanelId, SceneCommand, ShotCommand, TimelineCommand as T};
use crate::document::ShotEdit;

fn timeline(command: T, label: Text) -> CommandRow {
    row(C::Timeline(command), label, &[], KeyScope::Window)
}

fn shot(command: ShotCommand, label: Text) -> CommandRow {
    row(C::Scene(SceneCommand::Shot(command)), label, &[], KeyScope::Window)
}

fn step(step: u32, label: Text) -> CommandRow {
    shot(ShotCommand::Edit(ShotEdit::SetStep { step: Some(step) }), label)
        .help(text!("The frames for which everything that shades is held, in the open shot"))
}

pub(super) fn rows() -> Vec<CommandRow> {
    vec![
        row(C::ShowPanel(PanelId::TIMELINE), text!("Timeline"), &[], KeyScope::Window)
            .help(text!("Values that change with time: keys, play, scrub")),
        timeline(T::Play, text!("Timeline: play, or pause")),
        timeline(T::ToStart, text!("Timeline: to the start")),
        timeline(T::ToEnd, text!("Timeline: to the end")),
        timeline(T::ToKeyBefore, text!("Timeline: to the key before")),
        timeline(T::ToKeyAfter, text!("Timeline: to the key after")),
        timeline(T::AddMarker, text!("Timeline: add a marker")),
        timeline(T::ChangeEnd, text!("Timeline: loop, once, or back and forth"))
            .help(text!("The next of the three ways to go on at the end of the range")),
        timeline(T::CacheRange, text!("Timeline: cache the range"))
            .help(text!("Draws the frames of the range ahead, so that they play in real time")),
        timeline(T::KeepVersion, text!("Flip book: keep these frames as a version"))
            .help(text!("Later frames are compared with them, such as after an edit")),
        row(
            C::CompareFrames(None),
            text!("Flip book: compare the frames with others..."),
            &[],
            KeyScope::Window,
        )
        .help(text!("With frames that were rendered, or with those of another document")),
        step(1, text!("Shading of the shot on ones")),
        step(2, text!("Shading of the shot on twos")),
        step(3, text!("Shading of the shot on threes")),
        shot(ShotCommand::KeyAll, text!("Key all that the shot changes"))
            .help(text!("A key of each value at the frame of the playhead")),
        shot(ShotCommand::ResetAll, text!("Reset all that the shot changes"))
            .help(text!("Everything is as what lies under the shot has it; one step")),
    ]
}
