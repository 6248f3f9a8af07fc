//! Outputs of nodes as layers of the frames: picked from the looks, listed, and taken away.

use std::iter;

use chiaro_locale::tr;
use eframe::egui::containers::menu::{MenuButton, MenuConfig};
use eframe::egui::{PopupCloseBehavior, RichText, Role, ScrollArea, Ui, WidgetInfo, vec2};

use crate::compile::wire_outputs;
use crate::fields::row::labelled;
use crate::film::is_legal;
use crate::state::reading::LookWithLibrary;
use crate::state::runs::{FrameChoices, OfferedOutput, matching_outputs, nearest_outputs};
use crate::state::session::Session;
use crate::state::snapshot::Stamp;
use crate::widgets::menu::search_field;
use crate::widgets::text::{formed, hint};
use crate::widgets::theme;

/// Most outputs of a list.
const MOST: usize = 200;
/// Width of the menu, and room for the button that takes a layer away, in points.
const WIDTH: f32 = 240.0;
const REMOVE: f32 = 24.0;

/// Outputs that the open documents offer, and the search among them.
#[derive(Default)]
pub(super) struct OutputMenu {
    offered: Vec<OfferedOutput>,
    /// State of the documents that the outputs are of.
    of: Option<Stamp>,
    search: String,
}

impl OutputMenu {
    /// Finds the outputs anew where the documents changed, once they are compiled.
    fn know_outputs(&mut self, session: &Session) {
        let now = session.stamp().without_view();
        if self.of.as_ref() == Some(&now) || self.of.is_some() && session.is_compiling() {
            return;
        }
        self.offered = offered(session);
        self.of = Some(now);
    }

    /// Shows the outputs that are picked, and the menu that picks more.
    pub(super) fn show(&mut self, ui: &mut Ui, choices: &mut FrameChoices, session: &Session) {
        self.know_outputs(session);
        let mut removed = None;
        for index in 0..choices.outputs.len() {
            if self.picked(ui, choices, index) {
                removed = Some(index);
            }
        }
        if let Some(index) = removed {
            choices.outputs.remove(index);
        }
        let config = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
        let menu = MenuButton::new(tr!("Add an output")).config(config);
        let (button, shown) = menu.ui(ui, |ui| self.list(ui));
        button.on_hover_text(tr!("Outputs of the looks' nodes, each as a layer of its own"));
        if let Some(output) = shown.and_then(|shown| shown.inner) {
            choices.pick(&output);
        }
    }

    /// Shows an output that is picked, with the name of its layer. Returns true if it is taken
    /// away.
    fn picked(&self, ui: &mut Ui, choices: &mut FrameChoices, index: usize) -> bool {
        let names: Vec<String> = choices.outputs.iter().map(|output| output.name.clone()).collect();
        let picked = &mut choices.outputs[index];
        let known = self.offered.iter().find(|offered| offered.output == picked.output);
        let title = known.map_or_else(|| picked.output.clone(), |known| known.title.clone());
        let read = |text: &str| match text {
            text if !is_legal(text) => {
                Err(tr!("letters, digits and _ alone, and no digit first").to_owned())
            }
            text if names.iter().enumerate().any(|(at, name)| at != index && name == text) => {
                Err(tr!("another layer has this name").to_owned())
            }
            text => Ok(text.to_owned()),
        };
        let mut is_removed = false;
        let help = tr!("Name of the layer of {output}", output = picked.output);
        labelled(ui, &title, &help, |ui, label| {
            let size = vec2((ui.available_width() - REMOVE).max(40.0), ui.available_height());
            let name =
                ui.allocate_ui(size, |ui| formed(ui, label, &picked.name, String::clone, read));
            if let Some((_, name)) = name.inner {
                picked.name = name;
            }
            let remove = ui.small_button("×").on_hover_text(tr!("Takes the layer away"));
            let name = tr!("Take {output} away", output = picked.output);
            remove.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
            is_removed = remove.clicked();
        });
        if known.is_none() && !self.offered.is_empty() {
            let near = self.unknown(ui, &picked.output.clone());
            picked.output = near.unwrap_or_else(|| picked.output.clone());
        }
        is_removed
    }

    /// Tells that no node has an output, and which ones are near. Returns the one that is chosen.
    fn unknown(&self, ui: &mut Ui, output: &str) -> Option<String> {
        let text = tr!("No node has the output {output}.");
        ui.label(RichText::new(text).small().color(theme::of(ui).error));
        let near = nearest_outputs(&self.offered, output);
        let chosen = |ui: &mut Ui| {
            ui.label(RichText::new(tr!("Did you mean")).small());
            near.iter()
                .find(|near| ui.small_button(**near).clicked())
                .map(|near| (*near).to_owned())
        };
        if near.is_empty() { None } else { ui.horizontal_wrapped(chosen).inner }
    }

    /// Shows the outputs that can be picked. Returns the one that is.
    fn list(&mut self, ui: &mut Ui) -> Option<String> {
        ui.set_width(WIDTH);
        let takes_first = search_field(ui, tr!("Find an output"), &mut self.search);
        let mut chosen = None;
        let area = ScrollArea::vertical().max_height(320.0).auto_shrink([false, true]);
        area.show(ui, |ui| {
            for (index, offered) in
                matching_outputs(&self.offered, &self.search).take(MOST).enumerate()
            {
                let button = ui.button(&offered.title).on_hover_text(&offered.output);
                if button.clicked() || index == 0 && takes_first {
                    chosen = Some(offered.output.clone());
                }
            }
        });
        if self.offered.is_empty() {
            hint(ui, tr!("The looks have problems: mend them to see their outputs."));
        } else if matching_outputs(&self.offered, &self.search).next().is_none() {
            chosen = self.unknown(ui, &self.search);
        }
        if chosen.is_some() {
            self.search.clear();
            ui.close();
        }
        chosen
    }
}

/// Outputs of the open look, and of the others of the scene.
fn offered(session: &Session) -> Vec<OfferedOutput> {
    let open = session.look_with_library();
    let others: Vec<_> = session.open_scene().into_iter().flat_map(|it| it.other_looks()).collect();
    let is_alone = others.is_empty();
    let looks = iter::once(open.look).chain(others.into_iter().map(|worn| &worn.look));
    let mut all = Vec::new();
    for look in looks {
        let of_look = LookWithLibrary { look, ..open };
        // A look with problems offers nothing, and tells of them in *Problems*.
        for wire in wire_outputs(look, open.library).unwrap_or_default() {
            let (output, title) = (
                format!("{}.{}", wire.path, wire.port),
                of_look.title_of_output(&wire.path, &wire.port),
            );
            let is_own = look.find(&wire.path).is_some();
            // The command line takes no such name of a look.
            let has_no_name = is_alone || look.name.is_empty() || look.name.contains('=');
            all.push(match has_no_name {
                true => OfferedOutput { output, title, is_own },
                false => OfferedOutput {
                    output: format!("{}:{output}", look.name),
                    title: format!("{}: {title}", look.name),
                    is_own,
                },
            });
        }
    }
    all
}
