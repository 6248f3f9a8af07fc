//! Sheet shown large, in place of the graph: each picture as wide as there is room, in the columns
//! of the sheet, with its values below it in letters of the window.

use std::collections::BTreeSet;

use chiaro_locale::tr;
use eframe::egui::{
    Color32, FontId, Key, Modifiers, Rect, Response, RichText, Role, ScrollArea, Sense, Stroke,
    StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use super::varied::color_of;
use super::{SheetView, TakenCell, Wedge, help};
use crate::commands::{Command, FilmCommand, keyboard};
use crate::state::session::Session;
use crate::state::wedge::WedgeCell;
use crate::widgets::text::cell as text_cell;
use crate::widgets::theme;

/// Least width of a picture as shown, in points: the sheet is scrolled where it has no room.
const LEAST: f32 = 140.0;
/// Least width of a picture that a hand makes smaller, in points.
const SMALLEST: f32 = 40.0;
/// Greatest enlargement of a picture, in points a pixel.
const MOST: f32 = 2.0;
/// Factor of a step of the buttons and keys that enlarge.
const STEP: f32 = 1.25;
/// Distance between cells, in points.
const GAP: f32 = 12.0;
/// Height of a line of words, in points.
const LINE: f32 = 16.0;

impl Wedge {
    /// True if the sheet is shown in place of the graph.
    pub(crate) fn is_large(&self) -> bool {
        self.is_large && self.shown.is_some()
    }

    /// Shows the sheet in place of the graph, or the graph again.
    pub(crate) fn enlarge(&mut self, is_large: bool) {
        self.is_large = is_large;
    }

    /// Shows the sheet, if it is to be shown large.
    pub(crate) fn show_large(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        let (Some(sheet), Some(shown)) = (&self.sheet, &self.shown) else { return out };
        let (mut taken, mut zoom) = (None, self.zoom);
        theme::panel(ui).show(ui, |ui| {
            ui.set_min_size(ui.available_size());
            ui.horizontal_wrapped(|ui| {
                let close = ui.button(tr!("Show the graph"));
                let help = tr!("Closes the sheet (Escape); the panel Wedge keeps it");
                if close.on_hover_text(help).clicked() {
                    out.push(Command::Film(FilmCommand::EnlargeWedge(false)));
                }
                let name = sheet.path.file_stem().unwrap_or_default().to_string_lossy();
                ui.label(RichText::new(name).strong());
                zoom *= zoom_buttons(ui);
                ui.label(RichText::new(help_of_clicks(session)).color(theme::of(ui).dim));
            });
            ui.add_space(6.0);
            zoom *= zoom_by_hand(ui);
            taken = self.view(sheet, shown, session).show_large(ui, &mut zoom);
        });
        self.zoom = zoom;
        out.extend(taken.and_then(|taken| self.take(taken)));
        out
    }
}

/// Shows the buttons that enlarge the pictures; returns the factor of this frame.
fn zoom_buttons(ui: &mut Ui) -> f32 {
    let mut factor = 1.0;
    for (sign, name, by) in
        [("−", tr!("Smaller pictures"), 1.0 / STEP), ("+", tr!("Larger pictures"), STEP)]
    {
        let button = ui.small_button(sign);
        button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
        let help = tr!("{name} ({sign}, or Ctrl+wheel); the sheet scrolls");
        if button.on_hover_text(help).clicked() {
            factor *= by;
        }
    }
    factor
}

/// Factor of the wheel with Ctrl and of the keys + and −, over the sheet.
fn zoom_by_hand(ui: &Ui) -> f32 {
    if !ui.rect_contains_pointer(ui.max_rect()) {
        return 1.0;
    }
    let wheel = ui.input(|input| input.zoom_delta());
    if keyboard::is_keyboard_taken(ui.ctx()) {
        return wheel;
    }
    let pressed = |keys: &[(Modifiers, Key)]| keys.iter().any(|&key| keyboard::take(ui, key));
    let plain = Modifiers::NONE;
    if pressed(&[(plain, Key::Plus), (plain, Key::Equals), (Modifiers::SHIFT, Key::Plus)]) {
        return wheel * STEP;
    }
    if pressed(&[(plain, Key::Minus)]) { wheel / STEP } else { wheel }
}

/// Sentence on what a click does.
fn help_of_clicks(session: &Session) -> &'static str {
    match session.shot() {
        Some(_) => tr!("A click takes a picture's values into the shot"),
        None => tr!("A click takes a picture's values"),
    }
}

impl SheetView<'_> {
    /// Shows the cells, `zoom` times as large as all of them have room; returns the one that is
    /// taken.
    fn show_large(self, ui: &mut Ui, zoom: &mut f32) -> Option<TakenCell> {
        let cells = self.cells;
        let columns = columns_of(cells);
        let lines = cells.iter().map(|cell| words_of(cell).len()).max().unwrap_or(0);
        let words = lines as f32 * LINE + 4.0;
        let own = cells.iter().filter_map(|cell| cell.place);
        let own = own.fold(Vec2::splat(1.0), |own, [.., width, height]| {
            own.max(vec2(width as f32, height as f32))
        });
        let size =
            picture_size(own, [columns, cells.len().div_ceil(columns)], words, ui.available_size());
        let size = zoomed(size, own, zoom);
        let mut found = None;
        ScrollArea::both().auto_shrink([false, false]).id_salt("large wedge").show(ui, |ui| {
            ui.spacing_mut().item_spacing = vec2(GAP, GAP);
            for (row, several) in cells.chunks(columns).enumerate() {
                ui.horizontal(|ui| {
                    for number in (row * columns..).take(several.len()) {
                        let all = vec2(size.x, size.y + words);
                        let (rect, response) = ui.allocate_exact_size(all, Sense::click());
                        if !ui.is_rect_visible(rect) {
                            continue;
                        }
                        self.paint(ui, rect, size, number, &response);
                        found = self.taken_by(&response, number).or(found);
                        response.on_hover_text(help(self.session));
                    }
                });
            }
        });
        found
    }

    /// Paints a cell: its part of the sheet, and its values below that.
    fn paint(self, ui: &Ui, rect: Rect, size: Vec2, number: usize, response: &Response) {
        let (shown, cell) = (self.shown, &self.cells[number]);
        let colors = theme::of(ui);
        let picture = Rect::from_min_size(rect.min, size);
        ui.painter().rect_filled(picture, 0.0, colors.canvas);
        if let Some(part) = shown.part_of(cell) {
            ui.painter().image(shown.texture.id(), picture, part, Color32::WHITE);
        }
        let stroke = self.frame(ui, number, response);
        ui.painter().rect_stroke(picture, 0.0, stroke, StrokeKind::Outside);
        let is_taken = self.taken == Some(number);
        for (line, (text, color)) in words_of(cell).into_iter().enumerate() {
            let top = picture.bottom() + 4.0 + line as f32 * LINE;
            let mut left = rect.left();
            if let Some(color) = color {
                let swatch = Rect::from_min_size(pos2(left, top + 3.0), vec2(10.0, 10.0));
                ui.painter().rect_filled(swatch, 2.0, color);
                let stroke = Stroke::new(1.0, colors.swatch_edge);
                ui.painter().rect_stroke(swatch, 2.0, stroke, StrokeKind::Inside);
                left += 14.0;
            }
            let place = Rect::from_min_max(pos2(left, top), pos2(rect.right(), top + LINE));
            let ink = if is_taken { colors.accent } else { colors.text };
            text_cell(ui, place, &text, FontId::proportional(12.0), ink);
        }
    }
}

/// Lines below a picture, each with the color that its value is.
fn words_of(cell: &WedgeCell) -> Vec<(String, Option<Color32>)> {
    let values = cell.lines().zip(&cell.values);
    let lines =
        values.map(|((name, text), (_, value))| (format!("{name} = {text}"), color_of(value)));
    let frame = cell.frame.map(|frame| (tr!("frame {frame}"), None));
    lines.chain(frame).collect()
}

/// Number of columns of the sheet.
fn columns_of(cells: &[WedgeCell]) -> usize {
    let lefts: BTreeSet<u32> =
        cells.iter().filter_map(|cell| cell.place).map(|[left, ..]| left).collect();
    lefts.len().max(1)
}

/// Size of a picture, in points: that all of them are seen in the room, columns by rows, each with
/// its words below it, but no smaller than can be judged. `own` is its size in pixels.
fn picture_size(own: Vec2, [columns, rows]: [usize; 2], words: f32, room: Vec2) -> Vec2 {
    let of = |length: f32, count: usize| (length + GAP) / count.max(1) as f32 - GAP;
    // Bars to scroll by take some of the room.
    let across = of(room.x - GAP, columns);
    let down = (of(room.y - GAP, rows) - words) * own.x / own.y;
    let width = across.min(down).min(own.x * MOST).max(LEAST.min(own.x * MOST));
    vec2(width, width * own.y / own.x)
}

/// Size of a picture that is enlarged, between what can be seen and twice its own pixels. A zoom
/// beyond that becomes one that changes nothing more.
fn zoomed(size: Vec2, own: Vec2, zoom: &mut f32) -> Vec2 {
    let most = own.x * MOST;
    let width = (size.x * *zoom).clamp(SMALLEST.min(most), most);
    *zoom = width / size.x.max(1.0);
    vec2(width, width * own.y / own.x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Value;

    fn cell(place: [u32; 4]) -> WedgeCell {
        let color = Value::Text("#ff8000".to_owned());
        let values =
            vec![("key.intensity".to_owned(), Value::Number(0.5)), ("rim.color".to_owned(), color)];
        WedgeCell { values, frame: Some(7), place: Some(place) }
    }

    #[test]
    fn a_sheet_fills_the_room_and_its_words_can_be_read() {
        let cells: Vec<WedgeCell> =
            (0..16).map(|at| cell([16 + at % 4 * 336, 50 + at / 4 * 250, 320, 180])).collect();
        assert_eq!(columns_of(&cells), 4);
        let words = words_of(&cells[0]);
        let texts: Vec<&str> = words.iter().map(|(text, _)| text.as_str()).collect();
        assert_eq!(texts, ["key.intensity = 0.5", "rim.color = #ff8000", "frame 7"]);
        assert!(words[1].1.is_some() && words[0].1.is_none(), "a color has a swatch");
        let own = vec2(320.0, 180.0);
        let size = picture_size(own, [4, 4], 52.0, vec2(620.0, 820.0));
        assert!(size.x >= LEAST && 4.0 * (size.x + GAP) <= 620.0, "all columns are seen: {size}");
        assert!((size.x / size.y - 320.0 / 180.0).abs() < 1e-3);
        // A room too small is scrolled, a sheet of one cell is not blown up.
        assert_eq!(picture_size(own, [4, 4], 52.0, vec2(300.0, 300.0)).x, LEAST);
        assert_eq!(picture_size(own, [1, 1], 52.0, vec2(2000.0, 2000.0)).x, 640.0);
    }

    #[test]
    fn a_sheet_is_enlarged_up_to_twice_its_pixels_and_back() {
        let (size, own) = (vec2(140.0, 78.75), vec2(320.0, 180.0));
        let mut zoom = 320.0 / 140.0;
        assert_eq!(zoomed(size, own, &mut zoom), own, "as large as it was drawn");
        zoom = 100.0;
        assert_eq!(zoomed(size, own, &mut zoom), own * MOST);
        zoom /= STEP;
        assert!(zoomed(size, own, &mut zoom).x < own.x * MOST, "a step back is seen at once");
        zoom = 0.0;
        assert_eq!(zoomed(size, own, &mut zoom).x, SMALLEST);
    }
}
