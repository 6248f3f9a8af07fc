//! Lines over the whole picture, which a scene draws after the looks.

use chiaro_locale::{Text, text, tr};
use eframe::egui::{Id, Slider, Ui};

use crate::commands::SceneCommand;
use crate::document::{ColorSpace, Scene, SceneEdit, SceneOutlines};
use crate::fields::row::labelled;
use crate::widgets::color;

/// Room for a slider's number, in points.
const NUMBER: f32 = 66.0;

/// Share of the width that a kind of line has.
struct Kind {
    label: Text,
    help: Text,
    share: fn(&mut SceneOutlines) -> &mut f64,
}

/// All kinds of lines.
const KINDS: [Kind; 5] = [
    Kind {
        label: text!("Silhouettes"),
        help: text!("Share of the width where a form ends in front of something else"),
        share: |outlines| &mut outlines.silhouettes,
    },
    Kind {
        label: text!("Creases"),
        help: text!("Share of the width where a surface folds by 30 degrees or more"),
        share: |outlines| &mut outlines.creases,
    },
    Kind {
        label: text!("Objects"),
        help: text!("Share of the width where two objects meet"),
        share: |outlines| &mut outlines.borders,
    },
    Kind {
        label: text!("Materials"),
        help: text!("Share of the width where two materials of an object meet"),
        share: |outlines| &mut outlines.material_borders,
    },
    Kind {
        label: text!("Ids"),
        help: text!("Share of the width where the Id of a look's Output changes within a material"),
        share: |outlines| &mut outlines.id_borders,
    },
];

/// Shows the lines of the scene, a row each; those of their kinds where there are any.
pub(super) fn show(ui: &mut Ui, scene: &Scene, out: &mut Vec<SceneCommand>) {
    let mut edit = Edit { outlines: scene.outlines, out };
    let help = tr!(
        "Lines over the whole picture, drawn after the looks, beside objects too: their width in \
         thousandths of the picture's height, 0 for none. For lines that belong to a look, wire \
         the node Outline"
    );
    let range = 0.0..=SceneOutlines::MOST_WIDTH;
    edit.slider(ui, (tr!("Outlines"), help), range, |outlines| &mut outlines.width);
    if scene.outlines.width == 0.0 {
        return;
    }
    labelled(ui, tr!("Color"), tr!("Of all lines; what is below shows through"), |ui, label| {
        let edited = color::edit(ui, label, scene.outlines.color, ColorSpace::Display, true);
        if let Some((id, color)) = edited {
            edit.outlines.color = color;
            edit.push(id);
        }
    });
    for Kind { label, help, share } in &KINDS {
        edit.slider(ui, (label.tr(), help.tr()), 0.0..=1.0, share);
    }
}

/// Outlines that fields change, and where the changes go.
struct Edit<'a> {
    outlines: SceneOutlines,
    out: &'a mut Vec<SceneCommand>,
}

impl Edit<'_> {
    fn slider(
        &mut self,
        ui: &mut Ui,
        (label, help): (&str, &str),
        range: std::ops::RangeInclusive<f64>,
        number: impl Fn(&mut SceneOutlines) -> &mut f64,
    ) {
        labelled(ui, label, help, |ui, label| {
            ui.spacing_mut().slider_width = (ui.available_width() - NUMBER).max(40.0);
            let number = number(&mut self.outlines);
            let before = *number;
            let slider = Slider::new(number, range).max_decimals(2);
            let response = ui.add(slider).labelled_by(label);
            if !number.is_finite() {
                *number = before;
            }
            if response.changed() && *number != before {
                self.push(response.id);
            }
        });
    }

    /// Pushes the change that the widget made.
    fn push(&mut self, widget: Id) {
        let edit = SceneEdit::SetOutlines { outlines: self.outlines };
        self.out.push(SceneCommand::EditHeld(widget, edit));
    }
}
