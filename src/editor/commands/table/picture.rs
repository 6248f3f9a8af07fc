//! Rows of commands that work over the picture, always or while light is painted on it.

use eframe::egui::{Key, Modifiers};

use super::{CTRL, CommandRow, KeyScope, NONE, SHIFT, row};
use crate::commands::{
    Command as C, FitCommand as F, FitGoal, LightBrush, LightMark, PlacingCommand, Switch,
    ViewCommand as V,
};
use crate::state::view::TransformPart;

fn view(command: V, label: &'static str, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::View(command), label, keys, KeyScope::Picture)
}

fn fit(command: F, label: &'static str, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::Fit(command), label, keys, KeyScope::Light)
}

fn place(mark: LightMark, label: &'static str, keys: &'static [(Modifiers, Key)]) -> CommandRow {
    row(C::Placing(PlacingCommand::By(mark)), label, keys, KeyScope::Picture).help(mark.help())
}

pub(super) fn rows() -> Vec<CommandRow> {
    vec![
        place(LightMark::Highlight, "Place the light by its highlight", &[(SHIFT, Key::H)]),
        place(LightMark::Shadow, "Place the light by its shadow", &[(SHIFT, Key::S)]),
        place(LightMark::Terminator, "Place the light by its terminator", &[(SHIFT, Key::T)]),
        row(
            C::Placing(PlacingCommand::Turn(Switch::Toggle)),
            "Place a light",
            &[],
            KeyScope::Picture,
        )
        .help(
            "Puts the light of the selected layer where its highlight, its shadow or its \
                 terminator is at the place that is clicked",
        ),
        row(C::Probe(Switch::Toggle), "Probe a pixel", &[(NONE, Key::I)], KeyScope::Picture)
            .help("Reads the value on every wire at a pixel, f32 beside f64"),
        view(V::Reset, "Reset camera and lights", &[(NONE, Key::R)])
            .help("Turns both back; in a scene to where the scene has them"),
        view(V::FrameObject, "Frame the object", &[(NONE, Key::F)])
            .help("Brings the whole object into view; of a scene the one that is selected"),
        view(V::FrameAll, "Frame all objects", &[(NONE, Key::A)])
            .help("Brings every object into view"),
        view(V::SwitchProjection, "Perspective or parallel", &[(NONE, Key::P)]),
        view(V::ToggleTurntable, "Start or stop the turntable", &[(NONE, Key::T)])
            .help("Turns the object before the camera, until it is switched off again"),
        view(V::ToggleHandles, "Show or hide handles on the object", &[(NONE, Key::H)])
            .help("Lines and handles of the selected layer and its light"),
        view(
            V::ToggleTransform(TransformPart::Place),
            "Move the object in the picture",
            &[(NONE, Key::W)],
        )
        .help("Shows arrows on the selected object of a scene, or hides them; Ctrl drags by steps"),
        view(
            V::ToggleTransform(TransformPart::Turn),
            "Turn the object in the picture",
            &[(NONE, Key::Q)],
        )
        .help("Shows rings on the selected object of a scene, or hides them; Ctrl drags by 15°"),
        view(
            V::ToggleTransform(TransformPart::Scale),
            "Scale the object in the picture",
            &[(NONE, Key::S)],
        )
        .help(
            "Shows squares on the selected object of a scene, or hides them; Ctrl drags by steps",
        ),
        view(V::LookThrough, "Look through the light", &[(NONE, Key::O)]).help(
            "Puts the camera where the light of the selected layer is: the light goes with the \
             view, until the camera has its place again",
        ),
        row(
            C::LinkPointed(true),
            "Link lights to the object pointed at",
            &[(NONE, Key::J)],
            KeyScope::Picture,
        )
        .help("Lets the lights that are selected in Links reach the object under the pointer"),
        row(
            C::LinkPointed(false),
            "Unlink lights from the object pointed at",
            &[(SHIFT, Key::J)],
            KeyScope::Picture,
        )
        .help("Keeps the lights that are selected in Links from the object under the pointer"),
        fit(F::Fit(FitGoal::Local), "Light it as painted, there alone", &[(CTRL, Key::Enter)]),
        fit(F::Fit(FitGoal::ThisLook), "Fit the whole look to the painted light", &[]),
        fit(F::TakeBrush(LightBrush::Light), "Paint where it should be lighter", &[(NONE, Key::B)]),
        fit(F::TakeBrush(LightBrush::Dark), "Paint where it should be darker", &[(NONE, Key::D)]),
        fit(
            F::TakeBrush(LightBrush::Color),
            "Paint a color that it should have",
            &[(NONE, Key::C)],
        ),
        fit(F::TakeBrush(LightBrush::Keep), "Paint what should stay", &[(NONE, Key::K)]),
        fit(F::TakeBrush(LightBrush::Erase), "Erase painted light", &[(NONE, Key::E)]),
        fit(
            F::ResizeBrush { is_larger: false },
            "Smaller brush of light",
            &[(NONE, Key::OpenBracket)],
        ),
        fit(
            F::ResizeBrush { is_larger: true },
            "Larger brush of light",
            &[(NONE, Key::CloseBracket)],
        ),
    ]
}
