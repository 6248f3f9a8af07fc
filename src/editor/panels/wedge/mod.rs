//! Wedges: values that vary, drawn on a sheet, and the cells of a sheet: a click on the picture, or
//! in the list below it, takes the values of one.

mod large;
mod varied;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{text, tr};
use eframe::egui::{
    Button, Color32, ColorImage, Image, Rect, Response, RichText, Role, ScrollArea, Sense, Stroke,
    StrokeKind, TextureHandle, TextureOptions, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use crate::commands::{Command, FilmCommand, PanelId};
use crate::document::Value;
use crate::files;
use crate::film::StoredFrame;
use crate::film::sheet::scaled;
use crate::panels::table::{PanelPlace, PanelRow};
use crate::state::runs::{ProgramRun, Variation};
use crate::state::session::Session;
use crate::state::wedge::{CellScope, WedgeCell, WedgeSheet};
use crate::state::worker::{BackgroundJobs, Worker};
use crate::widgets::text::hint;
use crate::widgets::theme;
use varied::{DrawnWedge, color_of};

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::WEDGE,
    text!("Wedge"),
    text!("Values tried side by side on a sheet; a click takes the values of a cell"),
    PanelPlace::WITH_DOCUMENT.closed(),
    |bench, ui, context| bench.wedge.show(ui, context.session),
)
.with_each_frame(|bench, ui, _, _| {
    bench.wedge.take_picture(ui);
    bench.wedge.drawn.update().into_iter().collect()
})
.with_jobs(|bench| &bench.wedge);

/// Greatest length of a sheet's file, in bytes.
const MAX_FILE: u64 = 1 << 28;
/// Greatest side of a sheet as it is shown, in pixels: each device has textures of that size.
const MAX_SIDE: u32 = 2048;
/// Greatest side of a cell under the pointer, in points.
const LARGE: f32 = 320.0;

/// Picture of a sheet, with the sides of its file, in pixels.
struct SheetPicture {
    image: ColorImage,
    size: [u32; 2],
}

/// Picture of a sheet on the screen.
struct ShownSheet {
    texture: TextureHandle,
    size: [u32; 2],
}

impl ShownSheet {
    /// Part of the picture that a cell is, from 0 to 1.
    fn part_of(&self, cell: &WedgeCell) -> Option<Rect> {
        let [left, top, width, height] = cell.place?.map(|side| side as f32);
        let [across, down] = self.size.map(|side| side.max(1) as f32);
        let least = pos2(left / across, top / down);
        Some(Rect::from_min_size(least, vec2(width / across, height / down)))
    }
}

/// A sheet with its picture, as it is shown small or large.
#[derive(Clone, Copy)]
struct SheetView<'s> {
    shown: &'s ShownSheet,
    cells: &'s [WedgeCell],
    /// Cell that was taken last.
    taken: Option<usize>,
    session: &'s Session,
}

/// Number of a cell that is taken, and the frames that it is taken for.
type TakenCell = (usize, CellScope);

/// The panel, with the sheet that was opened last.
pub(crate) struct Wedge {
    sheet: Option<WedgeSheet>,
    /// Cell that was taken last.
    taken: Option<usize>,
    /// Reader of pictures of sheets.
    reader: Worker<PathBuf, (PathBuf, Option<SheetPicture>)>,
    shown: Option<ShownSheet>,
    /// Values that vary, and their drawing.
    drawn: DrawnWedge,
    /// True if the sheet's picture is not there, or cannot be read.
    is_blind: bool,
    /// True if the sheet is to be shown in place of the graph.
    is_large: bool,
    /// Factor of the pictures over the size at which all of them have room there.
    zoom: f32,
}

impl BackgroundJobs for Wedge {
    fn is_busy(&self) -> bool {
        self.reader.owes() || self.drawn.run().is_some_and(ProgramRun::is_going_on)
    }

    fn wait(&self) {
        self.reader.wait();
        self.drawn.run().into_iter().for_each(ProgramRun::wait);
    }
}

/// Reads the picture of a sheet, no larger than it is shown.
fn read(path: PathBuf) -> (PathBuf, Option<SheetPicture>) {
    let picture = || {
        let bytes = files::read(&path, MAX_FILE).ok()?;
        let picture = StoredFrame::read(&bytes).and_then(|frame| frame.picture()).ok()?;
        let size = picture.size;
        let [width, height] = size.map(|side| u64::from(side.max(1)));
        let high = (u64::from(MAX_SIDE) * width / height).max(1);
        let small = scaled(&picture, MAX_SIDE.min(u32::try_from(high).unwrap_or(MAX_SIDE)));
        let sides = small.size.map(|side| side as usize);
        let image = ColorImage::from_rgba_unmultiplied(sides, &small.to_rgba8());
        Some(SheetPicture { image, size })
    };
    let picture = picture();
    (path, picture)
}

impl Wedge {
    /// `wake` is called from another thread when a sheet is read.
    pub(crate) fn new(wake: impl Fn() + Clone + Send + Sync + 'static) -> Self {
        let reader = Worker::new("wedge", wake.clone(), read);
        let drawn = DrawnWedge::new(Arc::new(wake));
        let (is_blind, is_large, zoom) = (false, false, 1.0);
        Self { sheet: None, taken: None, reader, shown: None, drawn, is_blind, is_large, zoom }
    }

    /// Adds a value to those that the next wedge tries.
    pub(crate) fn vary(&mut self, variation: Variation) {
        self.drawn.vary(variation);
    }

    /// Draws the wedge, by the program of this file.
    pub(crate) fn draw(&mut self, session: &Session, program: &Path) {
        self.drawn.draw(session, program);
    }

    /// Sentence on what a stop leaves of a wedge that is being drawn.
    pub(crate) fn going_on(&self) -> Option<String> {
        let run = self.drawn.run().filter(|run| run.is_going_on());
        run.map(|_| tr!("A wedge is being drawn, and has no sheet yet.").to_owned())
    }

    /// Asks the program to stop drawing.
    pub(crate) fn stop(&self) {
        self.drawn.run().into_iter().for_each(ProgramRun::stop);
    }

    /// Shows another sheet, large once its picture is read.
    pub(crate) fn open(&mut self, sheet: WedgeSheet) {
        self.reader.request(|_| sheet.picture());
        self.is_large = sheet.cells.iter().any(|cell| cell.place.is_some());
        (self.sheet, self.taken, self.shown, self.is_blind) = (Some(sheet), None, None, false);
        self.drawn.makes_room = true;
        self.zoom = 1.0;
    }

    fn take_picture(&mut self, ui: &Ui) {
        let wanted = self.sheet.as_ref().map(WedgeSheet::picture);
        for (path, picture) in self.reader.answers() {
            if wanted.as_deref() != Some(path.as_path()) {
                continue;
            }
            self.is_blind = picture.is_none();
            self.shown = picture.map(|SheetPicture { image, size }| ShownSheet {
                texture: ui.ctx().load_texture("wedge", image, TextureOptions::LINEAR),
                size,
            });
        }
    }

    fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        self.drawn.show(ui, session, &mut out);
        ui.separator();
        let Some(sheet) = &self.sheet else {
            hint(
                ui,
                tr!("Open, in the bar, shows a sheet that was drawn before, to take its values."),
            );
            return out;
        };
        let name = sheet.path.file_stem().unwrap_or_default().to_string_lossy();
        let document = sheet.document.display();
        let text = match session.shot() {
            Some(_) => tr!("{name} of {document}: a click takes it into the shot"),
            None => tr!("{name} of {document}: a click takes it into what is open"),
        };
        ui.label(RichText::new(text).small().color(theme::of(ui).dim));
        place_of(ui, &sheet.picture(), &mut out);
        if self.shown.is_some() {
            let (is_large, text, help) = match self.is_large() {
                true => (false, tr!("Show it here"), tr!("Shows the graph again (Escape)")),
                false => (true, tr!("Show it large"), tr!("Shows the sheet in place of the graph")),
            };
            if ui.button(text).on_hover_text(help).clicked() {
                out.push(Command::Film(FilmCommand::EnlargeWedge(is_large)));
            }
        }
        let mut taken = None;
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("wedge").show(ui, |ui| {
            match &self.shown {
                Some(_) if self.is_large() => {}
                Some(shown) => taken = self.view(sheet, shown, session).show_small(ui),
                None if self.is_blind => {
                    let file = sheet.picture();
                    let file = file.file_name().unwrap_or_default().to_string_lossy();
                    hint(ui, &tr!("{file}, the sheet, is not there or cannot be read."));
                }
                None => {}
            }
            for (number, cell) in sheet.cells.iter().enumerate() {
                ui.horizontal(|ui| {
                    swatches(ui, cell);
                    let text = format!("{}  {}", number + 1, cell.label());
                    let button = Button::selectable(self.taken == Some(number), text);
                    let response = ui.add(button.wrap());
                    taken = offer(&response, session).map(|scope| (number, scope)).or(taken);
                    if response.on_hover_text(help(session)).clicked() {
                        taken = Some((number, CellScope::AsKeyed));
                    }
                });
            }
        });
        out.extend(taken.and_then(|taken| self.take(taken)));
        out
    }

    /// The sheet, as it is shown.
    fn view<'s>(
        &self,
        sheet: &'s WedgeSheet,
        shown: &'s ShownSheet,
        session: &'s Session,
    ) -> SheetView<'s> {
        SheetView { shown, cells: &sheet.cells, taken: self.taken, session }
    }

    /// Command that takes a cell, which is marked from now on.
    fn take(&mut self, (number, scope): TakenCell) -> Option<Command> {
        self.taken = Some(number);
        let cell = self.sheet.as_ref()?.cells.get(number)?.clone();
        Some(Command::TakeCell(cell, scope))
    }
}

/// Shows where the picture of a sheet lies; a click opens it.
fn place_of(ui: &mut Ui, file: &Path, out: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(RichText::new(tr!("The sheet is")).color(theme::of(ui).dim));
        let link = ui.link(file.display().to_string());
        if link.on_hover_text(tr!("Opens the picture in the system's own program")).clicked() {
            out.push(Command::Film(FilmCommand::OpenPath(file.to_owned())));
        }
        let folder = file.parent().unwrap_or(file);
        let open = ui.small_button(tr!("Open folder"));
        if open.on_hover_text(folder.display().to_string()).clicked() {
            out.push(Command::Film(FilmCommand::OpenPath(folder.to_owned())));
        }
    });
}

/// Help on a click on a cell.
fn help(session: &Session) -> &'static str {
    match session.shot() {
        None => tr!("Sets these values, as one step that can be undone"),
        Some(_) => tr!(
            "Sets these values, as one step that can be undone: a key at the frame of the sheet \
             where keys move a value, else for the whole shot. The right button offers the whole \
             shot in place of keys"
        ),
    }
}

/// Offers, in a shot, for which frames a cell is taken.
fn offer(response: &Response, session: &Session) -> Option<CellScope> {
    session.shot()?;
    let mut chosen = None;
    response.context_menu(|ui| {
        for (scope, text) in [
            (CellScope::AsKeyed, tr!("Take it, with keys at its frame")),
            (CellScope::WholeShot, tr!("Take it for the whole shot, in place of keys")),
        ] {
            if ui.button(text).clicked() {
                chosen = Some(scope);
                ui.close();
            }
        }
    });
    chosen
}

impl SheetView<'_> {
    /// Shows the sheet as wide as there is room; the cell under the pointer is framed, and tells
    /// its values. Returns the cell that is taken.
    fn show_small(self, ui: &mut Ui) -> Option<TakenCell> {
        let Self { shown, cells, .. } = self;
        let own = Vec2::from(shown.size.map(|side| side as f32));
        let width = ui.available_width().min(own.x);
        let size = vec2(width, width * own.y / own.x);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        let painter = ui.painter_at(rect);
        painter.image(shown.texture.id(), rect, whole, Color32::WHITE);
        let mut found = None;
        for (number, cell) in cells.iter().enumerate() {
            let Some(part) = shown.part_of(cell) else { continue };
            let place = Rect::from_min_max(
                rect.lerp_inside(part.min.to_vec2()),
                rect.lerp_inside(part.max.to_vec2()),
            );
            if !rect.expand(1.0).contains_rect(place) || !ui.is_rect_visible(place) {
                continue;
            }
            let id = ui.scope_id().with(("cell", number));
            let response = ui.interact(place, id, Sense::click());
            let stroke = self.frame(ui, number, &response);
            painter.rect_stroke(place, 0.0, stroke, StrokeKind::Outside);
            found = self.taken_by(&response, number).or(found);
            enlarge(response, shown, cell, (part, part.size() * own), self.session);
        }
        found
    }

    /// Frame around a cell: under the pointer, or taken last.
    fn frame(self, ui: &Ui, number: usize, response: &Response) -> Stroke {
        let is_hot = response.hovered() || response.has_focus();
        let color = theme::of(ui).accent;
        match (is_hot, self.taken == Some(number)) {
            (true, _) => Stroke::new(2.5, color),
            (false, true) => Stroke::new(1.5, color),
            (false, false) => Stroke::NONE,
        }
    }

    /// Names a cell for who does not see it; the cell is returned where it is taken.
    fn taken_by(self, response: &Response, number: usize) -> Option<TakenCell> {
        let values = self.cells[number].label();
        let label = tr!("Cell {number}: {values}", number = number + 1);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
        let offered = offer(response, self.session);
        let scope = if response.clicked() { Some(CellScope::AsKeyed) } else { offered };
        scope.map(|scope| (number, scope))
    }
}

/// Shows the colors of a cell.
fn swatches(ui: &mut Ui, cell: &WedgeCell) {
    ui.spacing_mut().item_spacing.x = 3.0;
    cell.values.iter().for_each(|(_, value)| swatch(ui, value));
}

/// Shows the color that a value is, if it is one.
fn swatch(ui: &mut Ui, value: &Value) {
    let Some(color) = color_of(value) else { return };
    let (rect, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
    ui.painter().rect_filled(rect, 3.0, color);
    let stroke = Stroke::new(1.0, theme::of(ui).swatch_edge);
    ui.painter().rect_stroke(rect, 3.0, stroke, StrokeKind::Inside);
}

/// Tells the values of a cell under the pointer, below its part of the sheet, larger.
fn enlarge(
    response: Response,
    shown: &ShownSheet,
    cell: &WedgeCell,
    (part, size): (Rect, Vec2),
    session: &Session,
) {
    response.on_hover_ui(|ui| {
        let factor = (LARGE / size.max_elem().max(1.0)).min(2.0);
        ui.add(Image::new((shown.texture.id(), size * factor)).uv(part));
        for ((name, text), (_, value)) in cell.lines().zip(&cell.values) {
            ui.horizontal(|ui| {
                swatch(ui, value);
                ui.label(format!("{name} = {text}"));
            });
        }
        if let Some(frame) = cell.frame {
            ui.label(tr!("frame {frame}"));
        }
        ui.label(RichText::new(help(session)).small().color(theme::of(ui).dim));
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_that_is_missing_or_broken_has_no_picture() {
        assert!(read(PathBuf::from("/no/such/sheet.png")).1.is_none());
        let file = tempfile::Builder::new().suffix(".png").tempfile().unwrap();
        std::fs::write(file.path(), b"\x89PNG and no more").unwrap();
        assert!(read(file.path().to_path_buf()).1.is_none());
    }
}
