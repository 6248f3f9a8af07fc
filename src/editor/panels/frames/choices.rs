//! Choices of frames: which, where, how large, and with which layers.

use chiaro_locale::tr;
use eframe::egui::{self, Button, CollapsingHeader, RichText, Role, TextEdit, Ui, WidgetInfo};

use super::document::named_passes;
use super::outputs::OutputMenu;
use crate::commands::{Command, FilmCommand};
use crate::fields::row::{labelled, several};
use crate::film::LayerNaming;
use crate::panels::table::PanelContext;
use crate::state::reading::spoken;
use crate::state::runs::{
    CONTRIBUTIONS, FilmDocument, FrameChoices, LayerOption, MATTES, SampleDepth,
};
use crate::widgets::number::number_field;
use crate::widgets::text::is_typed;
use crate::widgets::theme;

/// Size that is offered where the document says none, in pixels.
const SIZE: [u32; 2] = [1920, 1080];
/// Parts of the document's size that are offered, in percent.
const PARTS: [u32; 3] = [100, 50, 25];

/// Shows the choices.
pub(super) fn show(
    ui: &mut Ui,
    choices: &mut FrameChoices,
    outputs: &mut OutputMenu,
    context: PanelContext<'_>,
    document: &FilmDocument,
    out: &mut Vec<Command>,
) {
    frames(ui, choices, document);
    files(ui, choices, out);
    size(ui, choices, document);
    if choices.is_png() {
        if let Some(view) = &context.safety.settings.display {
            labelled(
                ui,
                tr!("View"),
                tr!("The view of OpenColorIO that the window shows"),
                |ui, _| {
                    ui.checkbox(&mut choices.has_view, view.view.as_str());
                },
            );
        }
        return;
    }
    numbers(ui, choices);
    let count = choices.aovs.len() + choices.mattes.len() + choices.outputs.len();
    let head = match count {
        0 => tr!("Layers and mattes").to_owned(),
        count => tr!("Layers and mattes: {count}"),
    };
    CollapsingHeader::new(head).id_salt("layers").default_open(true).show(ui, |ui| {
        layers(ui, choices, outputs, context);
    });
}

/// Shows the range and the step.
fn frames(ui: &mut Ui, choices: &mut FrameChoices, document: &FilmDocument) {
    let help = tr!("First and last frame that are rendered, and the step from one to the next");
    several(ui, tr!("Frames"), help, |ui, _| {
        let [mut first, mut last] = choices.range(document);
        for (frame, name) in
            [(&mut first, tr!("Render from frame")), (&mut last, tr!("Render to frame"))]
        {
            let response = ui.add(number_field(ui, frame).speed(0.2));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
            response.on_hover_text(name);
        }
        if [first, last] != choices.range(document) {
            choices.frames = Some([first, last]);
        }
        let drag =
            number_field(ui, &mut choices.step).range(1..=1000).speed(0.1).prefix(tr!("every "));
        let response = ui.add(drag);
        response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, tr!("Step of frames")));
        response.on_hover_text(tr!("1 for every frame, 2 for every second one"));
        let is_other = choices.frames.is_some_and(|frames| frames != document.frames);
        let help = match document.is_shot {
            true => tr!("All frames of the shot"),
            false => tr!("All frames of the document"),
        };
        if is_other && ui.small_button(tr!("All")).on_hover_text(help).clicked() {
            choices.frames = None;
        }
    });
}

/// Shows the folder, the name and the form of the files.
fn files(ui: &mut Ui, choices: &mut FrameChoices, out: &mut Vec<Command>) {
    let help =
        tr!("Folder of the frames, from the document's own; it is made where it is not there");
    labelled(ui, tr!("Folder"), help, |ui, label| {
        let width = (ui.available_width() - 34.0).max(64.0);
        let field = TextEdit::singleline(&mut choices.folder).desired_width(width);
        let response = ui.add(field).labelled_by(label);
        is_typed(ui, &response, &mut choices.folder);
        let choose = ui.small_button("...").on_hover_text(tr!("Chooses the folder"));
        choose.widget_info(|| {
            WidgetInfo::labeled(Role::Button, true, tr!("Choose the folder of the frames"))
        });
        if choose.clicked() {
            out.push(Command::Film(FilmCommand::ChooseFolder(None)));
        }
    });
    let help = tr!("Name of the files; #### stands for the number of the frame, a digit each");
    several(ui, tr!("Name"), help, |ui, label| {
        let width = (ui.available_width() - 92.0).max(64.0);
        let field = TextEdit::singleline(&mut choices.name).desired_width(width);
        let response = ui.add(field).labelled_by(label);
        is_typed(ui, &response, &mut choices.name);
        ui.spacing_mut().item_spacing.x = 2.0;
        for (ending, text, help) in [
            ("exr", "EXR", tr!("Light, with layers and mattes, for a compositor")),
            ("png", "PNG", tr!("The picture as it is shown")),
        ] {
            let is_it = choices.is_png() == (ending == "png");
            let response = ui.selectable_label(is_it, text);
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, text));
            if response.on_hover_text(help).clicked() {
                choices.set_ending(ending);
            }
        }
    });
}

fn size(ui: &mut Ui, choices: &mut FrameChoices, document: &FilmDocument) {
    labelled(ui, tr!("Size"), tr!("Width and height, in pixels"), |ui, _| {
        let Some(own) = document.size.or(choices.size) else {
            let help = tr!("The command takes a size that fits the camera; sets another one");
            if ui.button(tr!("by the command")).on_hover_text(help).clicked() {
                choices.size = Some(SIZE);
            }
            return;
        };
        let mut size = choices.size.unwrap_or(own);
        for (side, name) in size.iter_mut().zip([tr!("Width of frames"), tr!("Height of frames")]) {
            let response = ui.add(number_field(ui, side).range(1..=32_768).speed(2.0));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
            response.on_hover_text(name);
        }
        if Some(size) != choices.size && size != own {
            choices.size = Some(size);
        }
    });
    let (whole, size) = (document.size.unwrap_or(SIZE), choices.size.or(document.size));
    several(ui, tr!("Scale"), tr!("Parts of the whole size, for drafts"), |ui, _| {
        ui.spacing_mut().item_spacing.x = 2.0;
        for part in PARTS {
            let scaled = whole.map(|side| (side * part / 100).max(1));
            let is_it = size == Some(scaled);
            let response = ui.selectable_label(is_it, format!("{part}%"));
            let name = tr!("Frames at {part}%");
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
            let help = format!("{}×{}", scaled[0], scaled[1]);
            if response.on_hover_text(help).clicked() {
                choices.size = Some(scaled);
            }
        }
    });
}

fn numbers(ui: &mut Ui, choices: &mut FrameChoices) {
    let help = tr!("Numbers of an EXR: halves have 16 bits, which is usual; floats have 32");
    several(ui, tr!("Numbers"), help, |ui, _| {
        ui.spacing_mut().item_spacing.x = 2.0;
        for (depth, bits, word) in
            [(SampleDepth::Half, 16, "half"), (SampleDepth::Float, 32, "float")]
        {
            let is_it = choices.depth == depth;
            let response = ui.selectable_label(is_it, tr!("{bits} bits"));
            let name = tr!("Numbers of {bits} bits");
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
            if response.on_hover_text(format!("--depth {word}")).clicked() {
                choices.depth = depth;
            }
        }
    });
}

/// Shows a word that is asked for or not. Returns true if it is to be the other way.
fn switch(ui: &mut Ui, is_on: bool, text: &str, name: &str, help: &str) -> bool {
    let response = ui.add(Button::selectable(is_on, text));
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, is_on, name));
    response.on_hover_text(help).clicked()
}

/// Shows what an EXR has beside the picture.
fn layers(
    ui: &mut Ui,
    choices: &mut FrameChoices,
    outputs: &mut OutputMenu,
    context: PanelContext<'_>,
) {
    let colors = theme::of(ui);
    let head = |ui: &mut Ui, text: &str| {
        ui.label(RichText::new(text).small().color(colors.dim));
    };
    let toggle = |choices: &mut FrameChoices, word: &str| {
        if !choices.aovs.remove(word) {
            choices.aovs.insert(word.to_owned());
        }
    };
    head(ui, tr!("What adds up to the picture, and shadows"));
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(3.0, 3.0);
        for LayerOption { word, label, help } in CONTRIBUTIONS {
            let is_on = choices.aovs.contains(word);
            let help = format!("{help}\n--aov {word}");
            if switch(ui, is_on, label.tr(), &tr!("Layers: {label}"), &help) {
                toggle(choices, word);
            }
        }
    });
    let named = named_passes(context.session);
    if !named.is_empty() {
        head(ui, tr!("Passes that the looks name"));
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(3.0, 3.0);
            for name in &named {
                let is_on = choices.aovs.contains(name);
                let help = tr!("An output of a node that a look names, as a layer");
                if switch(ui, is_on, name, &tr!("Pass {name}"), help) {
                    toggle(choices, name);
                }
            }
        });
    }
    head(ui, tr!("Outputs of nodes"));
    outputs.show(ui, choices, context.session);
    head(ui, tr!("Mattes (Cryptomatte)"));
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(3.0, 3.0);
        for LayerOption { word, label, help } in MATTES {
            let is_on = choices.mattes.contains(word);
            let help = format!("{help}\n--matte {word}");
            if switch(ui, is_on, label.tr(), &tr!("Matte: {label}"), &help)
                && !choices.mattes.remove(word)
            {
                choices.mattes.insert(word);
            }
        }
    });
    head(ui, tr!("Names of these layers"));
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(3.0, 3.0);
        for (word, _) in LayerNaming::all() {
            let is_it = choices.naming == word;
            let program = spoken(word);
            let response = ui.selectable_label(is_it, &program);
            let name = tr!("Names as {program}");
            response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_it, &name));
            let help =
                tr!("How layers of lights are called: Nuke light_key, Karma C_key, Blender \
                     Combined_key, Arnold RGBA_key");
            if response.on_hover_text(format!("{help}\n--naming {word}")).clicked() {
                choices.naming = word;
            }
        }
    });
}
