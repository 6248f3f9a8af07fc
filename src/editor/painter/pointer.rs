//! The pointer on the tile: strokes, lines, fills and picked colors, each one step of undo.

use std::sync::Arc;

use chiaro_locale::tr;
use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, Response, TouchPhase, Ui};
use glam::DVec2;

use super::tilt::Tilt;
use super::tools::Tools;
use crate::commands::{Command, PaintCommand, PaintTool};
use crate::document::{Address, Hcbtf, HcbtfEdit, Tile};
use crate::hcbtf::paint::{self, Flood, Stroke};
use crate::state::painting::work::OpenPainting;

/// Gesture of the pointer that is under way.
pub(super) enum TileGesture {
    /// Stroke over a sample.
    Stroke { stroke: Box<Stroke>, of: StrokeBase },
    /// Line that is not drawn yet: it ends where the pointer is let go.
    Line { from: DVec2, of: StrokeBase },
    /// Picking of colors, for as long as the pointer is down.
    Pick,
}

/// State of the sample that a stroke lies over.
pub(super) struct StrokeBase {
    address: Address,
    before: Arc<Tile>,
    /// HCBTF as shown when the stroke began, where another step of the same frame is not applied
    /// yet.
    over: Option<Arc<Hcbtf>>,
}

/// The painting as the events of a frame leave it; the strokes before are not applied yet.
struct LivePainting<'a> {
    work: &'a OpenPainting,
    /// Stroke that is shown from now on, where it differs from the session's.
    stroke: Option<Option<(Address, Arc<Tile>)>>,
}

impl LivePainting<'_> {
    fn show(&mut self, stroke: Option<(Address, Arc<Tile>)>) {
        self.stroke = Some(stroke);
    }

    /// Tile that a gesture paints on: the one shown at a sample, or an empty tile.
    fn tile_at(&self, address: Address) -> Arc<Tile> {
        let tile = match &self.stroke {
            Some(stroke) => self.work.tile_with(stroke.as_ref(), address),
            None => self.work.tile(address),
        };
        tile.cloned().unwrap_or_else(|| Arc::new(Tile::filled(self.work.grid().size, [0; 4])))
    }

    /// HCBTF as it is shown.
    fn shown(&self) -> Arc<Hcbtf> {
        match &self.stroke {
            Some(stroke) => Arc::new(self.work.hcbtf_with(stroke.as_ref())),
            None => self.work.shown().clone(),
        }
    }

    fn is_tiling(&self) -> bool {
        self.work.hcbtf().is_tiling
    }
}

impl StrokeBase {
    fn new(painting: &LivePainting<'_>, is_first: bool) -> Self {
        let address = painting.work.at();
        Self {
            address,
            before: painting.tile_at(address),
            over: (!is_first).then(|| painting.shown()),
        }
    }

    /// Step of undo for the finished tile, if the tile has changed; a stroke that leaves no trace
    /// paints nothing. The tile is shown from now on: another step of the same frame lies over it.
    fn done(self, tile: Tile, painting: &mut LivePainting<'_>) -> Option<Command> {
        if tile == *self.before {
            return None;
        }
        let hcbtf = self.over.as_deref().unwrap_or_else(|| painting.work.hcbtf());
        let edit = HcbtfEdit::paint(hcbtf, self.address, tile.clone());
        painting.show(Some((self.address, Arc::new(tile))));
        Some(Command::Paint(PaintCommand::Edit(edit)))
    }
}

/// Applies the pointer's events to the tile as it lies now: event by event, so that a click that is
/// over within a frame counts, and two of them make two steps.
pub(super) fn paint(
    ui: &Ui,
    response: &Response,
    tilt: &Tilt,
    going: &mut Option<TileGesture>,
    tools: &mut Tools,
    work: &OpenPainting,
) -> Vec<Command> {
    let (is_down, space, escape) = ui.input(|input| {
        (input.pointer.primary_down(), input.key_down(Key::Space), input.key_pressed(Key::Escape))
    });
    if escape && going.take().is_some() {
        return vec![Command::Paint(PaintCommand::ShowStroke(None))];
    }
    // A button that is pressed and let go within a frame is no longer down.
    let is_quick = !is_down && (response.clicked() || response.hovered());
    let is_over = response.is_pointer_button_down_on() || is_quick;
    let pressure = tools.pen.unwrap_or(1.0);
    let painting = LivePainting { work, stroke: None };
    let mut gesture =
        Events { tilt, going, tools, painting, path: Vec::new(), pressure, out: Vec::new() };
    let mut last = ui.input(|input| input.pointer.latest_pos());
    for event in ui.input(|input| input.events.clone()) {
        match event {
            Event::PointerMoved(at) => gesture.path.push(at),
            Event::Touch { phase: TouchPhase::End | TouchPhase::Cancel, .. } => {
                gesture.tools.pen = None;
            }
            Event::Touch { force: Some(force), .. } => {
                gesture.pressure = f64::from(force);
                gesture.tools.pen = Some(gesture.pressure);
            }
            Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers } => {
                last = Some(pos);
                match pressed {
                    true if is_over && response.rect.contains(pos) && !space => {
                        gesture.press(pos, modifiers);
                    }
                    true => {}
                    false => gesture.release(last),
                }
            }
            _ => {}
        }
    }
    gesture.go_on();
    // No event tells of a button that is let go outside the window.
    if !is_down {
        gesture.release(last);
    }
    // The stroke is shown before the steps are applied, as each step ends the stroke that is shown.
    let stroke = gesture.painting.stroke.map(PaintCommand::ShowStroke).map(Command::Paint);
    stroke.into_iter().chain(gesture.out).collect()
}

/// Handler of the pointer's events in a frame, with the resulting commands.
struct Events<'a> {
    tilt: &'a Tilt,
    going: &'a mut Option<TileGesture>,
    tools: &'a mut Tools,
    painting: LivePainting<'a>,
    /// Path of the pointer since the last button event.
    path: Vec<Pos2>,
    /// Pressure of the pen: the last value of the tablet, until the pen goes up; 0 to 1, 1 without
    /// a pen.
    pressure: f64,
    out: Vec<Command>,
}

impl Events<'_> {
    fn press(&mut self, at: Pos2, modifiers: Modifiers) {
        self.path.clear();
        if self.going.is_some() {
            return;
        }
        let kind = if modifiers.alt { PaintTool::Pick } else { self.tools.kind };
        let begun = self.begin(self.tilt.texel(at), kind, modifiers.shift);
        self.out.extend(begun);
    }

    fn begin(&mut self, at: DVec2, kind: PaintTool, is_shifted: bool) -> Option<Command> {
        let wraps = self.painting.is_tiling();
        let of = || StrokeBase::new(&self.painting, self.out.is_empty());
        match kind {
            PaintTool::Pick => {
                pick(&self.painting, at, self.tools);
                *self.going = Some(TileGesture::Pick);
            }
            PaintTool::Stamp if is_shifted || self.tools.stamp.is_none() => {
                let work = self.painting.work;
                self.tools.stamp = work.tile(work.at()).cloned();
                let told = match self.tools.stamp {
                    Some(_) => {
                        tr!("The tile at work is the stamp now: click where it is to go, on this \
                             sample or another")
                    }
                    None => {
                        tr!("There is nothing here to be a stamp: go to a painted sample first")
                    }
                };
                return Some(Command::Tell(told.to_owned()));
            }
            PaintTool::Fill => {
                let of = of();
                let at = texel(at, of.before.size(), wraps)?;
                let flood = Flood { tolerance: self.tools.tolerance, edge: self.tools.edge, wraps };
                let tile = paint::fill(&of.before, at, self.tools.colors[0], flood);
                return of.done(tile, &mut self.painting);
            }
            PaintTool::Line => *self.going = Some(TileGesture::Line { from: at, of: of() }),
            _ => {
                let of = of();
                let mut stroke = Box::new(Stroke::begin(
                    &of.before,
                    &self.tools.brush(),
                    &self.tools.symmetry,
                    wraps,
                ));
                stroke.to(at, self.pressure);
                let live = (of.address, Arc::new(stroke.tile().clone()));
                *self.going = Some(TileGesture::Stroke { stroke, of });
                self.painting.show(Some(live));
            }
        }
        None
    }

    /// Continues the gesture along the pointer's path.
    fn go_on(&mut self) {
        let path = std::mem::take(&mut self.path);
        let Some(last) = path.last().map(|at| self.tilt.texel(*at)) else { return };
        match self.going {
            Some(TileGesture::Stroke { stroke, of }) => {
                let mut is_changed = false;
                for at in path {
                    is_changed |= !stroke.to(self.tilt.texel(at), self.pressure).is_empty();
                }
                if is_changed {
                    self.painting.show(Some((of.address, Arc::new(stroke.tile().clone()))));
                }
            }
            Some(TileGesture::Line { from, of }) => {
                let wraps = self.painting.is_tiling();
                let tile = paint::line(
                    &of.before,
                    &self.tools.brush(),
                    &self.tools.symmetry,
                    wraps,
                    *from,
                    last,
                );
                self.painting.show(Some((of.address, Arc::new(tile))));
            }
            Some(TileGesture::Pick) => {
                pick(&self.painting, last, self.tools);
            }
            None => {}
        }
    }

    fn release(&mut self, at: Option<Pos2>) {
        self.go_on();
        let Some(was) = self.going.take() else { return };
        let done = self.end(was, at.map(|at| self.tilt.texel(at)));
        if done.is_none() {
            self.painting.show(None);
        }
        self.out.extend(done);
    }

    fn end(&mut self, was: TileGesture, last: Option<DVec2>) -> Option<Command> {
        match was {
            TileGesture::Stroke { stroke, of } => of.done(stroke.finish(), &mut self.painting),
            TileGesture::Line { from, of } => {
                let wraps = self.painting.is_tiling();
                let (brush, to) = (self.tools.brush(), last.unwrap_or(from));
                let tile = paint::line(&of.before, &brush, &self.tools.symmetry, wraps, from, to);
                of.done(tile, &mut self.painting)
            }
            TileGesture::Pick => {
                self.tools.picked(self.tools.colors[0]);
                None
            }
        }
    }
}

fn pick(painting: &LivePainting<'_>, at: DVec2, tools: &mut Tools) {
    let tile = painting.tile_at(painting.work.at());
    if let Some(at) = texel(at, tile.size(), painting.is_tiling()) {
        let color = paint::pick(&tile, at);
        if color[3] > 0 {
            tools.colors[0] = color;
        }
    }
}

/// Texel at a place; beyond the edges the texel of a copy, where `wraps` is set.
fn texel(at: DVec2, size: [u32; 2], wraps: bool) -> Option<[u32; 2]> {
    let sides = size.map(i64::from);
    let place = [at.x.floor() as i64, at.y.floor() as i64];
    let is_inside = (0..sides[0]).contains(&place[0]) && (0..sides[1]).contains(&place[1]);
    (is_inside || wraps)
        .then(|| [place[0].rem_euclid(sides[0]) as u32, place[1].rem_euclid(sides[1]) as u32])
}
