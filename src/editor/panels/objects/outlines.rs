//! Lines over the whole picture, which a scene draws after the looks.

use chiaro_locale::{Text, text, tr};
use eframe::egui::{Id, RichText, Ui};

use crate::commands::{Command, SceneCommand};
use crate::document::{ColorSpace, Scene, SceneEdit, SceneOutlines};
use crate::fields::{row, shot};
use crate::state::session::Session;
use crate::widgets::color;
use crate::widgets::number::number_slider;
use crate::widgets::theme;

/// Room for a slider's number, in points.
const NUMBER: f32 = 66.0;

/// Share of the width that a kind of line has.
struct Kind {
    label: Text,
    help: Text,
    /// Field of the scene's outlines.
    field: &'static str,
    share: fn(&mut SceneOutlines) -> &mut f64,
}

/// All kinds of lines.
const KINDS: [Kind; 5] = [
    Kind {
        label: text!("Silhouettes"),
        help: text!("Share of the width where a form ends in front of something else"),
        field: "silhouettes",
        share: |outlines| &mut outlines.silhouettes,
    },
    Kind {
        label: text!("Creases"),
        help: text!("Share of the width where a surface folds by 30 degrees or more"),
        field: "creases",
        share: |outlines| &mut outlines.creases,
    },
    Kind {
        label: text!("Objects"),
        help: text!("Share of the width where two objects meet"),
        field: "borders",
        share: |outlines| &mut outlines.borders,
    },
    Kind {
        label: text!("Materials"),
        help: text!("Share of the width where two materials of an object meet"),
        field: "material_borders",
        share: |outlines| &mut outlines.material_borders,
    },
    Kind {
        label: text!("Ids"),
        help: text!("Share of the width where the Id of a look's Output changes within a material"),
        field: "id_borders",
        share: |outlines| &mut outlines.id_borders,
    },
];

/// Shows the lines of the scene, a row each; those of their kinds where there are any.
pub(super) fn show(
    ui: &mut Ui,
    session: &Session,
    scene: &Scene,
    out: &mut Vec<SceneCommand>,
    commands: &mut Vec<Command>,
) {
    let mut edit = Edit { session, outlines: scene.outlines, out, commands };
    let help = tr!(
        "Lines over the whole picture, drawn after the looks, beside objects too: their width in \
         thousandths of the picture's height, 0 for none. For lines that belong to a look, wire \
         the node Outline"
    );
    let range = 0.0..=SceneOutlines::MOST_WIDTH;
    edit.slider(ui, (tr!("Outlines"), help), ("width", range), |outlines| &mut outlines.width);
    if scene.outlines.width == 0.0 {
        return;
    }
    let mut edited = None;
    let help = tr!("Of all lines; what is below shows through");
    edit.row(ui, (tr!("Color"), help), "color", |ui, label| {
        edited = color::edit(ui, label, scene.outlines.color, ColorSpace::Display, true);
    });
    if let Some((id, color)) = edited {
        edit.outlines.color = color;
        edit.push(id);
    }
    for Kind { label, help, field, share } in &KINDS {
        edit.slider(ui, (label.tr(), help.tr()), (field, 0.0..=1.0), share);
    }
}

/// Outlines that fields change, and where the changes go.
struct Edit<'a> {
    session: &'a Session,
    outlines: SceneOutlines,
    out: &'a mut Vec<SceneCommand>,
    commands: &'a mut Vec<Command>,
}

impl Edit<'_> {
    /// Shows a row of a field, with the mark of what a shot changes of it.
    fn row(
        &mut self,
        ui: &mut Ui,
        (label, help): (&str, &str),
        field: &str,
        add: impl FnOnce(&mut Ui, Id),
    ) {
        let targets = [format!("outlines.{field}")];
        let text = RichText::new(label).color(theme::of(ui).text);
        let slot = |ui: &mut Ui, size| {
            shot::mark(ui, size, self.session, &targets, label, self.commands);
        };
        row::with_slot(ui, text, help, slot, add);
    }

    fn slider(
        &mut self,
        ui: &mut Ui,
        named: (&str, &str),
        (field, range): (&str, std::ops::RangeInclusive<f64>),
        number: impl Fn(&mut SceneOutlines) -> &mut f64,
    ) {
        let mut outlines = self.outlines;
        let number = number(&mut outlines);
        let before = *number;
        let mut changed = None;
        self.row(ui, named, field, |ui, label| {
            ui.spacing_mut().slider_width = (ui.available_width() - NUMBER).max(40.0);
            let slider = number_slider(ui, number, range).max_decimals(2);
            let response = ui.add(slider).labelled_by(label);
            if !number.is_finite() {
                *number = before;
            }
            changed = (response.changed() && *number != before).then_some(response.id);
        });
        if let Some(id) = changed {
            self.outlines = outlines;
            self.push(id);
        }
    }

    /// Pushes the change that the widget made.
    fn push(&mut self, widget: Id) {
        let edit = SceneEdit::SetOutlines { outlines: self.outlines };
        self.out.push(SceneCommand::EditHeld(widget, edit));
    }
}
