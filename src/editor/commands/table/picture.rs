//! Rows of commands that work over the picture, always or while light is painted on it.

use chiaro_locale::{Text, text};
use eframe::egui::{Key, Modifiers};

use super::{CTRL, CommandRow, KeyScope, NONE, SHIFT, row};
use crate::commands::{
    Command as C, FitCommand as F, FitGoal, LightBrush, LightMark, PlacingCommand, Switch,
    ViewCommand as V,
};
use crate::state::view::TransformPart;

fn view(command: V, label: Text, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::View(command), label, keys, KeyScope::Picture)
}

fn fit(command: F, label: Text, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::Fit(command), label, keys, KeyScope::Light)
}

fn place(mark: LightMark, label: Text, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::Placing(PlacingCommand::By(mark)), label, keys, KeyScope::Picture).help(mark.help())
}

pub(super) fn rows() -> Vec<CommandRow> {
    let mut rows = lights_and_probe();
    rows.extend(views());
    rows.extend(painted_light());
    rows
}

/// Rows that place lights, and the probe.
fn lights_and_probe() -> Vec<CommandRow> {
    vec![
        place(LightMark::Highlight, text!("Place the light by its highlight"), &[(SHIFT, Key::H)]),
        place(LightMark::Shadow, text!("Place the light by its shadow"), &[(SHIFT, Key::S)]),
        place(
            LightMark::Terminator,
            text!("Place the light by its terminator"),
            &[(SHIFT, Key::T)],
        ),
        row(
            C::Placing(PlacingCommand::Turn(Switch::Toggle)),
            text!("Place a light"),
            &[],
            KeyScope::Picture,
        )
        .help(text!(
            "Puts the light of the selected layer where its highlight, its shadow or its \
             terminator is at the place that is clicked"
        )),
        row(C::Probe(Switch::Toggle), text!("Probe a pixel"), &[(NONE, Key::I)], KeyScope::Picture)
            .help(text!(
                "Reads the value on every wire at a pixel, on the canvas and in a table, f32 \
                 beside f64"
            )),
    ]
}

/// Rows about the camera, the object and its links.
fn views() -> Vec<CommandRow> {
    vec![
        view(V::Reset, text!("Reset camera and lights"), &[(NONE, Key::R)])
            .help(text!("Turns both back; in a scene to where the scene has them")),
        view(V::TurnAround, text!("Turn the object around"), &[]).help(text!(
            "For a mesh that faces away: shows its other side in the same light. In a scene it \
             turns the selected object by half"
        )),
        view(V::FrameObject, text!("Frame the object"), &[(NONE, Key::F)])
            .help(text!("Brings the whole object into view; of a scene the one that is selected")),
        view(V::FrameAll, text!("Frame all objects"), &[(NONE, Key::A)])
            .help(text!("Brings every object into view")),
        view(V::SwitchProjection, text!("Perspective or parallel"), &[(NONE, Key::P)]),
        view(V::ToggleTurntable, text!("Start or stop the turntable"), &[(NONE, Key::T)])
            .help(text!("Turns the object before the camera, until it is switched off again")),
        view(V::ToggleHandles, text!("Show or hide handles on the object"), &[(NONE, Key::H)])
            .help(text!("Lines and handles of the selected layer and its light")),
        view(
            V::ToggleTransform(TransformPart::Place),
            text!("Move the object in the picture"),
            &[(NONE, Key::W)],
        )
        .help(text!(
            "Shows arrows on the selected object of a scene, or hides them; Ctrl drags by steps"
        )),
        view(
            V::ToggleTransform(TransformPart::Turn),
            text!("Turn the object in the picture"),
            &[(NONE, Key::Q)],
        )
        .help(text!(
            "Shows rings on the selected object of a scene, or hides them; Ctrl drags by 15°"
        )),
        view(
            V::ToggleTransform(TransformPart::Scale),
            text!("Scale the object in the picture"),
            &[(NONE, Key::S)],
        )
        .help(text!(
            "Shows squares on the selected object of a scene, or hides them; Ctrl drags by steps"
        )),
        view(V::LookThrough, text!("Look through the light"), &[(NONE, Key::O)]).help(text!(
            "Puts the camera where the light of the selected layer is: the light goes with the \
             view, until the camera has its place again"
        )),
        row(
            C::LinkPointed(true),
            text!("Link lights to the object pointed at"),
            &[(NONE, Key::J)],
            KeyScope::Picture,
        )
        .help(text!(
            "Lets the lights that are selected in Links reach the object under the pointer"
        )),
        row(
            C::LinkPointed(false),
            text!("Unlink lights from the object pointed at"),
            &[(SHIFT, Key::J)],
            KeyScope::Picture,
        )
        .help(text!(
            "Keeps the lights that are selected in Links from the object under the pointer"
        )),
    ]
}

/// Rows about light that is painted on the picture.
fn painted_light() -> Vec<CommandRow> {
    vec![
        fit(
            F::Fit(FitGoal::Local),
            text!("Light it as painted, there alone"),
            &[(CTRL, Key::Enter)],
        ),
        fit(F::Fit(FitGoal::ThisLook), text!("Fit the whole look to the painted light"), &[]),
        fit(
            F::TakeBrush(LightBrush::Light),
            text!("Paint where it should be lighter"),
            &[(NONE, Key::B)],
        ),
        fit(
            F::TakeBrush(LightBrush::Dark),
            text!("Paint where it should be darker"),
            &[(NONE, Key::D)],
        ),
        fit(
            F::TakeBrush(LightBrush::Color),
            text!("Paint a color that it should have"),
            &[(NONE, Key::C)],
        ),
        fit(F::TakeBrush(LightBrush::Keep), text!("Paint what should stay"), &[(NONE, Key::K)]),
        fit(F::TakeBrush(LightBrush::Erase), text!("Erase painted light"), &[(NONE, Key::E)]),
        fit(
            F::ResizeBrush { is_larger: false },
            text!("Smaller brush of light"),
            &[(NONE, Key::OpenBracket)],
        ),
        fit(
            F::ResizeBrush { is_larger: true },
            text!("Larger brush of light"),
            &[(NONE, Key::CloseBracket)],
        ),
    ]
}
