//! Wedge that is drawn from the window: the values that vary, and the program that draws.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{tr, trn};
use eframe::egui::{self, Button, CollapsingHeader, RichText, Role, TextEdit, Ui, WidgetInfo};

use crate::clock::Clock;
use crate::commands::{Command, FilmCommand};
use crate::document::{ColorSpace, Target, Value, parse_hex};
use crate::fields::lighting::{OwnedKeys, Owner};
use crate::fields::wedge::{selected_values, variation_of};
use crate::files::make_folder;
use crate::panels::frames::command_text;
use crate::panels::frames::document::{document_of, is_unsaved};
use crate::state::runs::{
    CommandLine, ProgramRun, RunEnd, RunLine, ValueSpread, Variation, push_color,
};
use crate::state::session::Session;
use crate::state::wedge::free_sheet;
use crate::widgets::color;
use crate::widgets::menu;
use crate::widgets::number::number_field;
use crate::widgets::text::hint;
use crate::widgets::text::is_typed;
use crate::widgets::theme;

/// Folder of sheets, beside the document.
const FOLDER: &str = "wedges";
/// Widths of pictures that are offered, in pixels.
const WIDTHS: [u32; 3] = [160, 320, 640];
/// Most cells that are drawn without a warning of the time.
const MANY: usize = 64;

/// Wedge that is drawn, or was drawn last.
struct WedgeRun {
    run: ProgramRun,
    clock: Clock,
    messages: Vec<String>,
    count: usize,
    end: Option<RunEnd>,
    sheet: PathBuf,
}

/// Values that vary, and the last run.
pub(super) struct DrawnWedge {
    wake: Arc<dyn Fn() + Send + Sync>,
    pub(super) varied: Vec<Variation>,
    width: u32,
    run: Option<WedgeRun>,
    problem: Option<String>,
    /// True if the values make room for a sheet in the next frame.
    pub(super) makes_room: bool,
    /// Search among the values that can be added.
    search: String,
}

impl DrawnWedge {
    pub(super) fn new(wake: Arc<dyn Fn() + Send + Sync>) -> Self {
        let (varied, width) = (Vec::new(), WIDTHS[1]);
        let search = String::new();
        Self { wake, varied, width, run: None, problem: None, makes_room: false, search }
    }

    pub(super) fn run(&self) -> Option<&ProgramRun> {
        self.run.as_ref().map(|run| &run.run)
    }

    /// Adds a value, in place of another variation of the same.
    pub(super) fn vary(&mut self, variation: Variation) {
        match self.varied.iter_mut().find(|known| known.target == variation.target) {
            Some(known) => *known = variation,
            None => self.varied.push(variation),
        }
    }

    fn count(&self) -> usize {
        self.varied.iter().map(Variation::count).product()
    }

    /// The command line that draws the wedge, and its sheet.
    fn line(&self, session: &Session) -> Result<(CommandLine, PathBuf), String> {
        let document = document_of(session)?;
        let names = self.varied.iter().map(|varied| varied.target.as_str());
        let name: String = names.collect::<Vec<_>>().join("-");
        let is_plain = |sign: char| sign.is_ascii_alphanumeric() || sign == '_';
        let name: String =
            name.chars().map(|sign| if is_plain(sign) { sign } else { '-' }).take(60).collect();
        let name = format!("{}-{name}", document.stem());
        let sheet = free_sheet(&document.folder().join(FOLDER), &name);
        let sheet = Path::new(FOLDER).join(sheet.file_name().unwrap_or_default());
        let sheet = sheet.with_added_extension("png").to_string_lossy().into_owned();
        let shot = session.shot();
        let [width, height] = shot.and_then(|shot| shot.stack().size()).unwrap_or([4, 3]);
        let high = (u64::from(self.width) * u64::from(height) / u64::from(width.max(1))).max(1);
        let size = [self.width, u32::try_from(high).unwrap_or(self.width)];
        let frame = shot.map(|shot| shot.frame_at(session.view().time()));
        let line = document.wedge(&self.varied, &sheet, size, frame);
        let sheet = line.folder.join(&sheet);
        Ok((line, sheet))
    }

    /// Draws the wedge, by the program of this file.
    pub(super) fn draw(&mut self, session: &Session, program: &Path) {
        self.problem = self.start(session, program).err();
    }

    fn start(&mut self, session: &Session, program: &Path) -> Result<(), String> {
        let (line, sheet) = self.line(session)?;
        make_folder(&line.folder.join(FOLDER)).map_err(|problem| problem.message)?;
        let wake = self.wake.clone();
        let run = ProgramRun::start(program, &line, move || wake())?;
        self.run = Some(WedgeRun {
            run,
            clock: Clock::start(),
            messages: Vec::new(),
            count: self.count(),
            end: None,
            sheet,
        });
        Ok(())
    }

    /// Takes what the run has told.
    pub(super) fn update(&mut self) -> Option<Command> {
        let run = self.run.as_mut().filter(|run| run.end.is_none())?;
        let text = |line| match line {
            RunLine::Result(text) | RunLine::Message(text) => text,
        };
        run.messages.extend(run.run.lines().into_iter().map(text));
        run.end = run.run.end();
        let is_done = run.end? == RunEnd::Done;
        is_done.then(|| Command::Film(FilmCommand::ShowWedge(run.sheet.clone())))
    }

    /// Shows the values that vary, and the button that draws.
    pub(super) fn show(&mut self, ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
        let count = self.count();
        let head = match self.varied.is_empty() {
            true => tr!("Vary values").to_owned(),
            false => trn!(count, "Vary values: {count} cell", "Vary values: {count} cells"),
        };
        let closes = std::mem::take(&mut self.makes_room).then_some(false);
        let part = CollapsingHeader::new(head).id_salt("varied").default_open(true).open(closes);
        part.show(ui, |ui| {
            let mut removed = None;
            for (index, varied) in self.varied.iter_mut().enumerate() {
                let name = varied.target.clone();
                if row(ui, index, varied) {
                    removed = Some(index);
                }
                if varied.target != name
                    && let Some(proposed) = proposed(session, &varied.target)
                {
                    *varied = proposed;
                }
                uses(ui, session, varied);
            }
            if let Some(index) = removed {
                self.varied.remove(index);
            }
            self.add_menu(ui, session);
            if self.varied.is_empty() {
                hint(
                    ui,
                    tr!("Each combination of the values is a picture on one sheet. The diamond \
                         beside a value has \"Wedge this value\", too."),
                );
                return;
            }
            self.draw_row(ui, session, count, out);
        });
        if let Some(problem) = &self.problem {
            ui.label(RichText::new(problem).color(theme::of(ui).error));
        }
        self.state(ui, out);
    }

    /// Shows the width of the pictures, the button, and the command line.
    fn draw_row(&mut self, ui: &mut Ui, session: &Session, count: usize, out: &mut Vec<Command>) {
        let line = self.line(session);
        let is_going_on = self.run.as_ref().is_some_and(|run| run.end.is_none());
        ui.horizontal_wrapped(|ui| {
            let text =
                RichText::new(trn!(count, "Draw {count} cell", "Draw {count} cells")).strong();
            let button = ui.add_enabled(line.is_ok() && !is_going_on, Button::new(text));
            let help =
                tr!("Draws the pictures beside the window, which stays free, and shows the sheet");
            if button.on_hover_text(help).clicked() {
                out.push(Command::Film(FilmCommand::DrawWedge));
            }
            ui.spacing_mut().item_spacing.x = 2.0;
            for width in WIDTHS {
                let response = ui.selectable_label(self.width == width, width.to_string());
                let name = tr!("Cells {width} pixels wide");
                response.widget_info(|| {
                    WidgetInfo::selected(Role::RadioButton, true, self.width == width, &name)
                });
                if response.on_hover_text(&name).clicked() {
                    self.width = width;
                }
            }
        });
        let colors = theme::of(ui);
        if count > MANY {
            let text = tr!("These are many: it takes its time.");
            ui.label(RichText::new(text).color(colors.warning));
        }
        if is_unsaved(session) {
            ui.horizontal_wrapped(|ui| {
                let text = tr!("What you changed is not saved, and not in the pictures.");
                ui.label(RichText::new(text).color(colors.warning));
                if ui.small_button(tr!("Save now")).clicked() {
                    out.push(Command::Save);
                }
            });
        }
        match line {
            Ok((line, _)) => {
                command_text(ui, &line, tr!("Copy the command that draws the wedge"), out);
            }
            Err(reason) => {
                ui.label(RichText::new(reason).color(colors.error));
            }
        }
    }

    /// Shows how far the run is, or what went wrong.
    fn state(&self, ui: &mut Ui, out: &mut Vec<Command>) {
        let Some(run) = &self.run else { return };
        let colors = theme::of(ui);
        let last = run.messages.last().map(String::as_str).unwrap_or_default();
        match run.end {
            None => {
                let done = run.messages.iter().filter(|text| text.contains(" of ")).count();
                ui.horizontal(|ui| {
                    let text = trn!(
                        all = run.count,
                        "{done} of {all} cell, {seconds:.0} s",
                        "{done} of {all} cells, {seconds:.0} s",
                        seconds = run.clock.seconds()
                    );
                    ui.label(text);
                    if ui.small_button(tr!("Stop")).clicked() {
                        out.push(Command::Film(FilmCommand::StopWedge));
                    }
                });
                ui.ctx().request_repaint_after(std::time::Duration::from_millis(500));
            }
            Some(RunEnd::Failed) => {
                for message in &run.messages {
                    ui.label(RichText::new(message).color(colors.error));
                }
            }
            Some(RunEnd::Stopped) => {
                ui.label(RichText::new(tr!("Stopped. {last}")).color(colors.warning));
            }
            Some(RunEnd::Done) => {}
        }
    }

    /// Shows the menu of values that can vary.
    fn add_menu(&mut self, ui: &mut Ui, session: &Session) {
        let mut added = None;
        let texts = (tr!("Add a value"), tr!("Find a value"));
        let menu = menu::searching(ui, texts, &mut self.search, |ui, search| {
            let found = offered(session);
            if found.is_empty() {
                hint(ui, tr!("Select a node, or add a light."));
            }
            for (label, variation) in found {
                if search.entry(ui, &label) {
                    added = Some(variation);
                }
            }
        });
        menu.on_hover_text(tr!("Values of the selected nodes and of the lights"));
        if let Some(variation) = added {
            self.vary(variation);
        }
    }
}

/// The variation around the present value of this name; `None` where no value has it.
fn proposed(session: &Session, name: &str) -> Option<Variation> {
    // Fields of lights are named without the list that files have them in.
    let targets = [Target::parse(&format!("lights.{name}")), Target::parse(name)];
    let owners = [Owner::Scene, Owner::Look].into_iter();
    let mut owners = owners.filter_map(|owner| OwnedKeys::of(session, owner));
    let of = |owned| targets.iter().flatten().find_map(|target| variation_of(owned, target));
    owners.find_map(of).filter(|found| found.target == name)
}

/// Values that are offered, each with its label: of the selected nodes, and of the lights.
fn offered(session: &Session) -> Vec<(String, Variation)> {
    let of_look = OwnedKeys::of_look(session);
    let of_nodes = selected_values(session).into_iter().map(|target| (of_look, target));
    let owners = [Owner::Scene, Owner::Look].into_iter();
    let owners = owners.filter_map(|owner| OwnedKeys::of(session, owner));
    let of_lights = owners.flat_map(|owned| {
        let lights = owned.look().lights.iter().filter(move |(id, _)| !owned.is_replaced(id));
        lights.flat_map(move |(id, light)| {
            let fields = light.fields().map(|field| field.name().to_owned());
            fields.map(move |field| (owned, Target::Light { light: id.clone(), field }))
        })
    });
    let named = |(owned, target): (OwnedKeys<'_>, Target)| {
        Some((owned.keys.base.title_of_target(&target), variation_of(owned, &target)?))
    };
    of_nodes.chain(of_lights).filter_map(named).collect()
}

/// Shows a value that varies. Returns true if it is taken away.
fn row(ui: &mut Ui, index: usize, varied: &mut Variation) -> bool {
    let mut is_removed = false;
    ui.push_id(index, |ui| {
        ui.horizontal(|ui| {
            let target = varied.target.clone();
            let width = (ui.available_width() - 30.0).max(60.0);
            let field = ui.add(TextEdit::singleline(&mut varied.target).desired_width(width));
            is_typed(ui, &field, &mut varied.target);
            field.widget_info(|| {
                WidgetInfo::labeled(
                    Role::TextInput,
                    true,
                    tr!("Value {number}", number = index + 1),
                )
            });
            field.on_hover_text(tr!(
                "Name of the value: a field of a light (key.intensity), an input of a node \
                 (rim.falloff) or of one in a group (cheek/rim.falloff), an exposed value (width) \
                 or one of an object (hero.width)"
            ));
            let remove = ui.small_button("×").on_hover_text(tr!("Does not vary it"));
            remove.widget_info(|| {
                WidgetInfo::labeled(Role::Button, true, tr!("Do not vary {target}"))
            });
            is_removed = remove.clicked();
        });
        let target = varied.target.clone();
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            match &mut varied.spread {
                ValueSpread::Numbers { from, to, count, is_angle } => {
                    numbers(ui, &target, [from, to], count, *is_angle);
                }
                ValueSpread::Colors(colors) => swatches(ui, &target, colors),
            }
        });
    });
    is_removed
}

/// Tells of a value within a group that is used several times.
fn uses(ui: &mut Ui, session: &Session, varied: &Variation) {
    let Some(target) = Target::parse(&varied.target) else { return };
    let look = session.look_with_library();
    let count = look.uses_around(&target).len();
    let Target::Input { node, .. } = target else { return };
    if let Some(group) = node.parent().filter(|_| count > 1) {
        let group = look.title_of_path(&group);
        hint(ui, &tr!("In {group} alone: the group is used {count} times."));
    }
}

/// Shows both ends of numbers, and how many there are.
fn numbers(ui: &mut Ui, target: &str, ends: [&mut f64; 2], count: &mut u32, is_angle: bool) {
    let (scale, suffix) = if is_angle { (1.0_f64.to_degrees(), "°") } else { (1.0, "") };
    for (value, name) in ends.into_iter().zip([tr!("from"), tr!("to")]) {
        ui.label(RichText::new(name).color(theme::of(ui).dim));
        let mut shown = *value * scale;
        let drag = number_field(ui, &mut shown).speed(0.01 * scale).max_decimals(3).suffix(suffix);
        let response = ui.add(drag);
        response.widget_info(|| {
            WidgetInfo::labeled(Role::SpinButton, true, format!("{target} {name}"))
        });
        if response.changed() && shown.is_finite() {
            *value = (shown / scale * 1e6).round() / 1e6;
        }
    }
    let drag = number_field(ui, count).range(1..=480).speed(0.05).suffix(tr!(" values"));
    let response = ui.add(drag);
    response.widget_info(|| {
        WidgetInfo::labeled(Role::SpinButton, true, tr!("Number of values of {target}"))
    });
}

/// Shows colors, each with a swatch that opens a picker, and the buttons for more and fewer.
fn swatches(ui: &mut Ui, target: &str, colors: &mut Vec<[f64; 3]>) {
    for (index, color) in colors.iter_mut().enumerate() {
        let [r, g, b] = *color;
        ui.push_id(index, |ui| {
            let name = tr!("Color {number} of {target}", number = index + 1);
            let space = ColorSpace::Display;
            let picked = color::named_swatch(ui, &name, [r, g, b, 1.0], space, false);
            if let Some((_, [r, g, b, _])) = picked {
                *color = [r, g, b];
            }
        });
    }
    let more = ui.small_button("+").on_hover_text(tr!("One color more, near the first one"));
    if more.clicked() {
        push_color(colors);
    }
    let fewer = ui.add_enabled(colors.len() > 1, egui::Button::new("−").small());
    if fewer.on_hover_text(tr!("One color fewer")).clicked() {
        colors.pop();
    }
}

/// The color that a value of a cell is, if it is one.
pub(super) fn color_of(value: &Value) -> Option<egui::Color32> {
    let Value::Text(text) = value else { return None };
    let [r, g, b, _] = parse_hex(text)?;
    let [r, g, b] = [r, g, b].map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    Some(egui::Color32::from_rgb(r, g, b))
}
