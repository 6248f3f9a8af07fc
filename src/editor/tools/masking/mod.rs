//! Painting of a layer's mask on the mesh: a stroke on the picture is carried onto the texels of
//! the mesh's UVs on a thread (`work`, `project`), and becomes a step of the mask's file.

mod project;
mod work;

use std::collections::VecDeque;
use std::path::PathBuf;

use chiaro_locale::tr;
use eframe::egui::{
    Color32, CursorIcon, Event, Key, Modifiers, PointerButton, Pos2, Rect, RichText, Role, Shape,
    Stroke, Ui, WidgetInfo,
};
use glam::DVec2;

use super::notice::over_top;
use crate::commands::{Command, MaskCommand};
use crate::frame::Assets;
use crate::ids::NodeId;
use crate::state::masks::{MaskStep, file_of, painted_of};
use crate::state::session::Session;
use crate::state::worker::{BackgroundJobs, Worker};
use crate::tools::probe::picture_size;
use crate::tools::{PictureContext, SwitchPlace, ToolRow};
use crate::widgets::number::number_field;
use crate::widgets::theme;
use project::MaskStroke;
use work::{MaskAnswer, MaskChange, MaskRequest};
pub(crate) use work::{lacks_colors, laying};

pub(super) const TOOL: ToolRow = ToolRow::new(
    SwitchPlace::Elsewhere,
    |parts| Box::new(MaskTool::new(parts.wake())),
    |tools| tools.of::<MaskTool>().is_on(),
    |_, _, _| {},
)
.with_pointer(|tools| &tools.of::<MaskTool>().hint)
.with_drags()
.with_interaction(|tools, ui, context| tools.of_mut::<MaskTool>().interact(ui, context))
.with_overlay(|tools, ui, context, out| tools.of_mut::<MaskTool>().over(ui, context, out))
.with_jobs(|tools| tools.of::<MaskTool>());

/// Largest brush, in points.
const LARGEST: f32 = 400.0;

/// The tool and its state.
pub(crate) struct MaskTool {
    worker: Worker<MaskRequest, MaskAnswer>,
    /// Layer whose mask is painted; `None` while the tool is off.
    layer: Option<NodeId>,
    /// Files of the look and of the mask that painting last began with.
    begun: Option<[PathBuf; 2]>,
    /// Diameter of the brush, in points.
    size: f32,
    /// Part of the brush that covers wholly, in percent.
    hardness: f32,
    /// True if the brush shows the layer, false if it hides it.
    shows: bool,
    /// Points of the stroke under way, on the screen, and whether it shows the layer.
    stroke: Option<(Vec<Pos2>, bool)>,
    /// Changes that wait for those before them.
    waiting: VecDeque<MaskChange>,
    /// Sentence on the last result.
    told: Option<String>,
    hint: String,
}

impl MaskTool {
    fn new(wake: impl Fn() + Send + 'static) -> Self {
        let mut assets = Assets::default();
        Self {
            worker: Worker::new("mask", wake, move |request| work::carry_out(&mut assets, request)),
            layer: None,
            begun: None,
            size: 48.0,
            hardness: 70.0,
            shows: true,
            stroke: None,
            waiting: VecDeque::new(),
            told: None,
            hint: String::new(),
        }
    }

    /// True while a mask is painted.
    pub(crate) fn is_on(&self) -> bool {
        self.layer.is_some()
    }

    /// Begins to paint the mask of a layer, or ends painting.
    pub(crate) fn turn(&mut self, layer: Option<NodeId>, session: &Session) {
        if let Some(layer) = &layer {
            self.begun = files_of(session, layer);
        }
        self.layer = layer;
        (self.stroke, self.told) = (None, None);
        self.waiting.clear();
    }

    /// Says a sentence, without its end, until something is painted.
    pub(crate) fn tell(&mut self, told: String) {
        self.told = Some(told);
    }

    fn interact(&mut self, ui: &Ui, context: &PictureContext<'_>) -> Option<Command> {
        let PictureContext { session, response, rect, .. } = *context;
        let answer = self.worker.answers().pop();
        let Some(layer) = self.layer.clone() else {
            // A stroke that was under way when painting ended.
            let [look, mask] = self.begun.as_ref()?;
            let is_open = |step: &MaskStep| session.path() == Some(look) && step.file == *mask;
            let step = answer?.ok().filter(is_open)?;
            return Some(Command::Mask(MaskCommand::Keep(step)));
        };
        // Another file may be somebody else's: painting it begins anew.
        let files = files_of(session, &layer);
        if files.is_none() || files != self.begun {
            return Some(Command::Mask(MaskCommand::Leave));
        }
        let step = match answer {
            Some(Ok(step)) => {
                self.told = None;
                Some(Command::Mask(MaskCommand::Keep(step)))
            }
            Some(Err(why)) => {
                self.told = Some(why);
                None
            }
            None => None,
        };
        // The step is in the file by the next frame; what waits is made of that file.
        if step.is_none() {
            self.next(ui, session, &layer, rect);
        }
        if step.is_some() && !self.waiting.is_empty() {
            ui.request_repaint();
        }
        self.keys(ui);
        let (is_down, is_pressed, modifiers, origin) = ui.input(|input| {
            let pointer = &input.pointer;
            let is_pressed = pointer.button_pressed(PointerButton::Primary);
            (pointer.primary_down(), is_pressed, input.modifiers, pointer.press_origin())
        });
        let begins = is_pressed && response.is_pointer_button_down_on() && !modifiers.alt;
        if let Some(at) = origin.filter(|_| begins && self.stroke.is_none()) {
            self.stroke = Some((vec![at], self.shows != modifiers.command));
        } else if let Some((points, _)) = &mut self.stroke {
            ui.input(|input| {
                points.extend(input.events.iter().filter_map(|event| match event {
                    Event::PointerMoved(at) => Some(*at),
                    _ => None,
                }));
            });
        }
        if !is_down && let Some((points, shows)) = self.stroke.take() {
            let scale = f64::from(ui.pixels_per_point());
            let pixel = |at: Pos2| {
                let [x, y] = (at - rect.min).into();
                DVec2::new(f64::from(x), f64::from(y)) * scale
            };
            self.waiting.push_back(MaskChange::Stroke(MaskStroke {
                points: points.into_iter().map(pixel).collect(),
                radius: f64::from(self.size) / 2.0 * scale,
                hardness: f64::from(self.hardness) / 100.0,
                shows,
            }));
            ui.request_repaint();
        }
        let hint = match self.shows {
            true => tr!(
                "Drag on the model: the brush shows the layer, with Ctrl the other way · Alt turns \
                 the view · [ and ] change the size, X what the brush does · Esc ends"
            ),
            false => tr!(
                "Drag on the model: the brush hides the layer, with Ctrl the other way · Alt turns \
                 the view · [ and ] change the size, X what the brush does · Esc ends"
            ),
        };
        hint.clone_into(&mut self.hint);
        step
    }

    /// Begins with the next change that waits.
    fn next(&mut self, ui: &Ui, session: &Session, layer: &NodeId, rect: Rect) {
        if self.worker.owes() {
            return;
        }
        let (Some(file), Some((name, laying)), Some(change)) =
            (session.mask_file(layer), painted_of(session.look(), layer), self.waiting.pop_front())
        else {
            return;
        };
        let size = picture_size(rect, ui.pixels_per_point());
        let (name, snapshot) = (name.to_owned(), session.snapshot());
        let request = MaskRequest { file, name, laying, change, size, snapshot };
        self.worker.request(|_| request);
    }

    fn keys(&mut self, ui: &Ui) {
        if crate::commands::keyboard::is_keyboard_taken(ui.ctx()) {
            return;
        }
        let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
        for (key, factor) in [(Key::OpenBracket, 0.8), (Key::CloseBracket, 1.25)] {
            if pressed(key) {
                self.size = (self.size * factor).round().clamp(2.0, LARGEST);
            }
        }
        if pressed(Key::X) {
            self.shows = !self.shows;
        }
    }

    /// Shows the controls, the brush, and the stroke that is not on the mask yet.
    fn over(&mut self, ui: &mut Ui, context: &PictureContext<'_>, out: &mut Vec<Command>) {
        let Some(layer) = self.layer.clone() else { return };
        let PictureContext { session, response, rect, .. } = *context;
        let painter = ui.painter_at(rect);
        if let Some((points, shows)) = &self.stroke {
            let tone = if *shows { Color32::WHITE } else { Color32::BLACK };
            let stroke = Stroke::new(self.size, tone.gamma_multiply(0.35));
            painter.circle_filled(points[0], self.size / 2.0, stroke.color);
            painter.add(Shape::line(points.clone(), stroke));
        }
        if let Some(at) = ui.input(|input| input.pointer.hover_pos()).filter(|_| response.hovered())
        {
            ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
            painter.circle_stroke(at, self.size / 2.0, Stroke::new(3.0, theme::HALO));
            painter.circle_stroke(at, self.size / 2.0, Stroke::new(1.0, Color32::WHITE));
        }
        over_top(ui, rect, "mask", |ui| self.controls(ui, session, &layer, out));
    }

    fn controls(&mut self, ui: &mut Ui, session: &Session, layer: &NodeId, out: &mut Vec<Command>) {
        ui.spacing_mut().item_spacing.x = 5.0;
        let node = session.look().graph.nodes.get(layer);
        let name = node.map_or(layer.as_str(), |node| match node.name.as_str() {
            "" => layer.as_str(),
            name => name,
        });
        let file = file_of(session.look(), layer).unwrap_or_default();
        ui.label(tr!("Mask of {name}")).on_hover_text(tr!(
            "White shows the layer, black hides it. Kept in {file}, beside the look, as soon as a \
             stroke ends"
        ));
        for (shows, label, help) in [
            (true, tr!("Show"), tr!("The brush shows the layer (X)")),
            (false, tr!("Hide"), tr!("The brush hides the layer (X)")),
        ] {
            if ui.selectable_label(self.shows == shows, label).on_hover_text(help).clicked() {
                self.shows = shows;
            }
        }
        let numbers = [
            (
                &mut self.size,
                [tr!("Size"), tr!("Size of the brush")],
                " pt",
                2.0..=LARGEST,
                tr!("Width of the brush on the screen ([, ])"),
            ),
            (
                &mut self.hardness,
                [tr!("Hardness"), tr!("Hardness of the brush")],
                "%",
                0.0..=100.0,
                tr!("Part of the brush without a soft edge"),
            ),
        ];
        for (value, [label, name], suffix, range, help) in numbers {
            ui.label(label);
            let drag = number_field(ui, value).range(range).max_decimals(0).suffix(suffix);
            let response = ui.add(drag).on_hover_text(help);
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
        }
        for (change, label, help) in [
            (MaskChange::Fill(true), tr!("mask" => "Fill"), tr!("The whole mask shows the layer")),
            (MaskChange::Fill(false), tr!("Clear"), tr!("The whole mask hides the layer")),
            (
                MaskChange::Invert,
                tr!("Invert"),
                tr!("Shows what is hidden, and hides what is shown"),
            ),
        ] {
            if ui.button(label).on_hover_text(help).clicked() {
                self.waiting.push_back(change);
                ui.request_repaint();
            }
        }
        if ui.button(tr!("Done")).on_hover_text(tr!("Ends painting (Esc)")).clicked() {
            out.push(Command::Mask(MaskCommand::Leave));
        }
        if let Some(told) = &self.told {
            ui.label(RichText::new(told).color(theme::of(ui).text));
        }
    }
}

/// Files of a look and of the mask of a layer.
fn files_of(session: &Session, layer: &NodeId) -> Option<[PathBuf; 2]> {
    Some([session.path()?.to_path_buf(), session.mask_file(layer)?])
}

impl BackgroundJobs for MaskTool {
    fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    fn wait(&self) {
        self.worker.wait();
    }
}
