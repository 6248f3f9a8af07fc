//! What the pointer does on the tile: strokes, lines, fills and picked colors, each one step of
//! undo.

use std::sync::Arc;

use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, Response, TouchPhase, Ui};
use glam::DVec2;

use super::tilt::Tilt;
use super::tools::{Kind, Tools};
use super::{Wish, command};
use crate::commands::Command;
use crate::document::{Address, Hcbtf, HcbtfEdit, Tile};
use crate::hcbtf::paint::{self, Flood, Stroke};
use crate::state::painting::work::Work;
use crate::state::session::Session;

/// What the pointer is at.
pub(super) enum Going {
    /// A stroke over a sample.
    Stroke { stroke: Box<Stroke>, of: Of },
    /// A line that is not drawn yet: it ends where the pointer is let go.
    Line { from: DVec2, of: Of },
    /// Colors are taken for as long as the pointer is down.
    Pick,
}

/// What a stroke lies over.
pub(super) struct Of {
    address: Address,
    before: Arc<Tile>,
    /// Everything as it was, where another step of this frame is not done yet.
    over: Option<Arc<Hcbtf>>,
}

impl Of {
    fn new(work: &Work, is_first: bool) -> Self {
        let address = work.at();
        Self {
            address,
            before: tile_at(work, address),
            over: (!is_first).then(|| work.shown().clone()),
        }
    }

    /// The step of undo, if anything is another now. A stroke that leaves no trace paints nothing.
    /// What was painted is shown from now on: another step of the same frame lies over it.
    fn done(self, tile: Tile, session: &mut Session) -> Option<Command> {
        if tile == *self.before {
            return None;
        }
        let hcbtf = self.over.as_deref().or_else(|| session.painting().map(Work::hcbtf))?;
        let edit = HcbtfEdit::paint(hcbtf, self.address, tile.clone());
        show(session, Some((self.address, Arc::new(tile))));
        Some(command(Wish::Edit(edit)))
    }
}

/// What a hand paints on: what is shown at a sample, or nothing at all.
pub(super) fn tile_at(work: &Work, address: Address) -> Arc<Tile> {
    work.tile(address).cloned().unwrap_or_else(|| Arc::new(Tile::filled(work.grid().size, [0; 4])))
}

/// Does what the pointer asks for on the tile as it lies now: event by event, so that a click
/// counts that is over within a frame, and two of them make two steps.
pub(super) fn paint(
    ui: &Ui,
    response: &Response,
    tilt: &Tilt,
    going: &mut Option<Going>,
    tools: &mut Tools,
    session: &mut Session,
) -> Vec<Command> {
    let (is_down, space, escape) = ui.input(|input| {
        (input.pointer.primary_down(), input.key_down(Key::Space), input.key_pressed(Key::Escape))
    });
    if escape && going.take().is_some() {
        show(session, None);
        return Vec::new();
    }
    // What is pressed and let go within a frame is not down any more.
    let is_quick = !is_down && (response.clicked() || response.hovered());
    let is_over = response.is_pointer_button_down_on() || is_quick;
    let pressure = tools.pen.unwrap_or(1.0);
    let mut hand =
        Events { tilt, going, tools, session, path: Vec::new(), pressure, out: Vec::new() };
    let mut last = ui.input(|input| input.pointer.latest_pos());
    for event in ui.input(|input| input.events.clone()) {
        match event {
            Event::PointerMoved(at) => hand.path.push(at),
            Event::Touch { phase: TouchPhase::End | TouchPhase::Cancel, .. } => {
                hand.tools.pen = None;
            }
            Event::Touch { force: Some(force), .. } => {
                hand.pressure = f64::from(force);
                hand.tools.pen = Some(hand.pressure);
            }
            Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers } => {
                last = Some(pos);
                match pressed {
                    true if is_over && response.rect.contains(pos) && !space => {
                        hand.press(pos, modifiers);
                    }
                    true => {}
                    false => hand.release(last),
                }
            }
            _ => {}
        }
    }
    hand.go_on();
    // Where nobody told that it was let go, as outside the window.
    if !is_down {
        hand.release(last);
    }
    hand.out
}

/// What the pointer does in a frame, and what comes of it.
struct Events<'a> {
    tilt: &'a Tilt,
    going: &'a mut Option<Going>,
    tools: &'a mut Tools,
    session: &'a mut Session,
    /// Where the pointer went since the last button.
    path: Vec<Pos2>,
    /// How hard the pen is pressed: what a tablet told last, until the pen goes up.
    pressure: f64,
    out: Vec<Command>,
}

impl Events<'_> {
    fn press(&mut self, at: Pos2, modifiers: Modifiers) {
        self.path.clear();
        if self.going.is_some() {
            return;
        }
        let kind = if modifiers.alt { Kind::Pick } else { self.tools.kind };
        let begun = self.begin(self.tilt.texel(at), kind, modifiers.shift);
        self.out.extend(begun);
    }

    fn begin(&mut self, at: DVec2, kind: Kind, is_shifted: bool) -> Option<Command> {
        let work = self.session.painting()?;
        let wraps = work.hcbtf().is_tiling;
        let of = || Of::new(work, self.out.is_empty());
        match kind {
            Kind::Pick => {
                pick(work, at, self.tools);
                *self.going = Some(Going::Pick);
            }
            Kind::Stamp if is_shifted || self.tools.stamp.is_none() => {
                self.tools.stamp = work.tile(work.at()).cloned();
                let told = match self.tools.stamp {
                    Some(_) => {
                        "The tile at work is the stamp now: click where it is to go, on this \
                         sample or another"
                    }
                    None => "There is nothing here to be a stamp: go to a painted sample first",
                };
                return Some(Command::Tell(told.to_owned()));
            }
            Kind::Fill => {
                let of = of();
                let at = texel(at, of.before.size(), wraps)?;
                let flood = Flood { tolerance: self.tools.tolerance, edge: self.tools.edge, wraps };
                let tile = paint::fill(&of.before, at, self.tools.colors[0], flood);
                return of.done(tile, self.session);
            }
            Kind::Line => *self.going = Some(Going::Line { from: at, of: of() }),
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
                *self.going = Some(Going::Stroke { stroke, of });
                show(self.session, Some(live));
            }
        }
        None
    }

    /// Takes in where the pointer went.
    fn go_on(&mut self) {
        let path = std::mem::take(&mut self.path);
        let Some(last) = path.last().map(|at| self.tilt.texel(*at)) else { return };
        match self.going {
            Some(Going::Stroke { stroke, of }) => {
                let mut is_changed = false;
                for at in path {
                    is_changed |= !stroke.to(self.tilt.texel(at), self.pressure).is_empty();
                }
                if is_changed {
                    show(self.session, Some((of.address, Arc::new(stroke.tile().clone()))));
                }
            }
            Some(Going::Line { from, of }) => {
                let wraps = self.session.painting().is_some_and(|work| work.hcbtf().is_tiling);
                let tile = paint::line(
                    &of.before,
                    &self.tools.brush(),
                    &self.tools.symmetry,
                    wraps,
                    *from,
                    last,
                );
                show(self.session, Some((of.address, Arc::new(tile))));
            }
            Some(Going::Pick) => {
                if let Some(work) = self.session.painting() {
                    pick(work, last, self.tools);
                }
            }
            None => {}
        }
    }

    fn release(&mut self, at: Option<Pos2>) {
        self.go_on();
        let Some(was) = self.going.take() else { return };
        let done = self.end(was, at.map(|at| self.tilt.texel(at)));
        if done.is_none() {
            show(self.session, None);
        }
        self.out.extend(done);
    }

    fn end(&mut self, was: Going, last: Option<DVec2>) -> Option<Command> {
        match was {
            Going::Stroke { stroke, of } => of.done(stroke.finish(), self.session),
            Going::Line { from, of } => {
                let wraps = self.session.painting()?.hcbtf().is_tiling;
                let (brush, to) = (self.tools.brush(), last.unwrap_or(from));
                let tile = paint::line(&of.before, &brush, &self.tools.symmetry, wraps, from, to);
                of.done(tile, self.session)
            }
            Going::Pick => {
                self.tools.picked(self.tools.colors[0]);
                None
            }
        }
    }
}

fn show(session: &mut Session, live: Option<(Address, Arc<Tile>)>) {
    if let Some(work) = session.painting_mut() {
        work.set_live(live);
        session.painting_changed();
    }
}

fn pick(work: &Work, at: DVec2, tools: &mut Tools) {
    if let Some(tile) = work.tile(work.at())
        && let Some(at) = texel(at, tile.size(), work.hcbtf().is_tiling)
    {
        let color = paint::pick(tile, at);
        if color[3] > 0 {
            tools.colors[0] = color;
        }
    }
}

/// The texel at a place; beyond the edges that of a copy, if there are any.
fn texel(at: DVec2, size: [u32; 2], wraps: bool) -> Option<[u32; 2]> {
    let sides = size.map(i64::from);
    let place = [at.x.floor() as i64, at.y.floor() as i64];
    let is_inside = (0..sides[0]).contains(&place[0]) && (0..sides[1]).contains(&place[1]);
    (is_inside || wraps)
        .then(|| [place[0].rem_euclid(sides[0]) as u32, place[1].rem_euclid(sides[1]) as u32])
}
