//! What the pointer does on the tile: strokes, lines, fills and picked colours, each one step of undo.

use std::sync::Arc;

use eframe::egui::{Event, Key, PointerButton, Pos2, Response, TouchPhase, Ui};
use glam::DVec2;

use super::tilt::Tilt;
use super::tools::{Kind, Tools};
use super::work::Work;
use super::{Wish, command};
use crate::document::{Address, HcbtfEdit, Tile};
use crate::editor::command::Command;
use crate::editor::session::Session;
use crate::hcbtf::paint::{self, Stroke};

/// What the pointer is at.
pub(super) enum Going {
    /// A stroke over a sample.
    Stroke { stroke: Box<Stroke>, of: Of },
    /// A line that is not drawn yet: it ends where the pointer is let go.
    Line { from: DVec2, of: Of },
    /// Colours are taken for as long as the pointer is down.
    Pick,
}

/// What a stroke lies over.
pub(super) struct Of {
    address: Address,
    before: Arc<Tile>,
}

impl Of {
    fn new(work: &Work) -> Self {
        let address = work.at();
        Self { address, before: tile_at(work, address) }
    }

    /// The step of undo, if anything is another now. A stroke that leaves no trace paints nothing.
    fn done(self, tile: Tile, work: &Work) -> Option<Command> {
        let is_same = tile == *self.before;
        (!is_same).then(|| command(Wish::Edit(HcbtfEdit::paint(work.hcbtf(), self.address, tile))))
    }
}

/// What a hand paints on: what is shown at a sample, or nothing at all.
pub(super) fn tile_at(work: &Work, address: Address) -> Arc<Tile> {
    work.tile(address).cloned().unwrap_or_else(|| Arc::new(Tile::filled(work.grid().size, [0; 4])))
}

/// Does what the pointer asks for on the tile as it lies now.
pub(super) fn paint(
    ui: &Ui,
    response: &Response,
    tilt: &Tilt,
    going: &mut Option<Going>,
    tools: &mut Tools,
    session: &mut Session,
) -> Option<Command> {
    let (is_down, is_pressed, space, alt, shift, escape) = ui.input(|input| {
        let pointer = &input.pointer;
        (
            pointer.primary_down(),
            pointer.button_pressed(PointerButton::Primary),
            input.key_down(Key::Space),
            input.modifiers.alt,
            input.modifiers.shift,
            input.key_pressed(Key::Escape),
        )
    });
    if escape && going.take().is_some() {
        show(session, None);
        return None;
    }
    let (path, pressure) = path(ui, &mut tools.pen);
    let mut out = None;
    if going.is_none() && is_pressed && response.is_pointer_button_down_on() && !space {
        let at = ui.input(|input| input.pointer.press_origin()).map(|at| tilt.texel(at));
        let kind = if alt { Kind::Pick } else { tools.kind };
        out = at.and_then(|at| begin(at, kind, shift, pressure, going, tools, session));
    }
    if going.is_some() {
        go_on(&path, pressure, tilt, going, tools, session);
    }
    if !is_down && let Some(was) = going.take() {
        let last = ui.input(|input| input.pointer.latest_pos()).map(|at| tilt.texel(at));
        let done = end(was, last, tools, session);
        if done.is_none() {
            show(session, None);
        }
        out = out.or(done);
    }
    out
}

/// Where the pointer went in this frame, and how hard the pen is pressed at its end: what a tablet told last, until the pen
/// goes up.
fn path(ui: &Ui, pen: &mut Option<f64>) -> (Vec<Pos2>, f64) {
    let (mut path, mut last) = (Vec::new(), *pen);
    ui.input(|input| {
        for event in &input.events {
            match event {
                Event::PointerMoved(at) => path.push(*at),
                Event::Touch { phase: TouchPhase::End | TouchPhase::Cancel, .. } => *pen = None,
                Event::Touch { force: Some(force), .. } => {
                    *pen = Some(f64::from(*force));
                    last = *pen;
                }
                _ => {}
            }
        }
    });
    (path, last.unwrap_or(1.0))
}

fn begin(
    at: DVec2,
    kind: Kind,
    is_shifted: bool,
    pressure: f64,
    going: &mut Option<Going>,
    tools: &mut Tools,
    session: &mut Session,
) -> Option<Command> {
    let work = session.painting()?;
    let wraps = work.hcbtf().is_tiling;
    match kind {
        Kind::Pick => {
            pick(work, at, tools);
            *going = Some(Going::Pick);
        }
        Kind::Stamp if is_shifted || tools.stamp.is_none() => {
            tools.stamp = work.tile(work.at()).cloned();
            let told = match tools.stamp {
                Some(_) => "The tile at work is the stamp now: click where it is to go, on this sample or another",
                None => "There is nothing here to be a stamp: go to a painted sample first",
            };
            return Some(Command::Tell(told.to_owned()));
        }
        Kind::Fill => {
            let of = Of::new(work);
            let at = texel(at, of.before.size(), wraps)?;
            let tile = paint::fill(&of.before, at, tools.colors[0], tools.tolerance, wraps);
            return of.done(tile, work);
        }
        Kind::Line => *going = Some(Going::Line { from: at, of: Of::new(work) }),
        _ => {
            let of = Of::new(work);
            let mut stroke = Box::new(Stroke::begin(&of.before, &tools.brush(), &tools.symmetry, wraps));
            stroke.to(at, pressure);
            let live = (of.address, Arc::new(stroke.tile().clone()));
            *going = Some(Going::Stroke { stroke, of });
            show(session, Some(live));
        }
    }
    None
}

fn go_on(
    path: &[Pos2],
    pressure: f64,
    tilt: &Tilt,
    going: &mut Option<Going>,
    tools: &mut Tools,
    session: &mut Session,
) {
    let Some(last) = path.last().map(|at| tilt.texel(*at)) else { return };
    match going {
        Some(Going::Stroke { stroke, of }) => {
            let mut is_changed = false;
            for at in path {
                is_changed |= !stroke.to(tilt.texel(*at), pressure).is_empty();
            }
            if is_changed {
                show(session, Some((of.address, Arc::new(stroke.tile().clone()))));
            }
        }
        Some(Going::Line { from, of }) => {
            let wraps = session.painting().is_some_and(|work| work.hcbtf().is_tiling);
            let tile = paint::line(&of.before, &tools.brush(), &tools.symmetry, wraps, *from, last);
            show(session, Some((of.address, Arc::new(tile))));
        }
        Some(Going::Pick) => {
            if let Some(work) = session.painting() {
                pick(work, last, tools);
            }
        }
        None => {}
    }
}

fn end(was: Going, last: Option<DVec2>, tools: &mut Tools, session: &mut Session) -> Option<Command> {
    match was {
        Going::Stroke { stroke, of } => of.done(stroke.finish(), session.painting()?),
        Going::Line { from, of } => {
            let work = session.painting()?;
            let wraps = work.hcbtf().is_tiling;
            let tile = paint::line(&of.before, &tools.brush(), &tools.symmetry, wraps, from, last.unwrap_or(from));
            of.done(tile, work)
        }
        Going::Pick => {
            tools.picked(tools.colors[0]);
            None
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
    (is_inside || wraps).then(|| [place[0].rem_euclid(sides[0]) as u32, place[1].rem_euclid(sides[1]) as u32])
}
