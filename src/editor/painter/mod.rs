//! The painting workspace: an HCBTF is painted on, its samples are gone through, and rules fill the
//! rest.
//!
//! A [`Work`] is the document with its past, kept by the session as looks and scenes are. Five
//! panels show it: `easel` with the tools above it is the tile as the eye sees it, `map` is all of
//! its lights and views at a glance, `sheet` is them as one picture, `dome` with `list` where the
//! light and the eye are, and `rules` is what fills them. A stroke changes what is shown here and
//! now; once it ends it is an [`HcbtfEdit`], which [`App`](crate::App) applies. What is painted
//! stands in the viewport at once: the session gives it to whoever draws, in place of the file.

mod arrows;
mod atlas;
mod baking;
pub(crate) mod before;
mod dome;
mod easel;
mod export;
mod filling;
mod grid;
mod hand;
mod icons;
mod import;
mod list;
mod making;
mod map;
mod memory;
mod moves;
mod preview;
mod rules;
mod seen;
mod sheet;
mod start;
mod storing;
mod synthesis;
mod textures;
mod tilt;
mod toolbar;
mod tools;

use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui;
use eframe::egui::{Button, Key, Pos2, Rect, RichText, Slider, Ui, WidgetInfo};

use crate::app::dock::{self, Panel};
use crate::commands::Command;
use crate::commands::shortcuts::{self, Action, Way};
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, Hcbtf, HcbtfEdit, Storage};
use crate::hcbtf::Device;
use crate::hcbtf::exchange::Form;
use crate::panels::problems::sentence;
use crate::state::painting::look;
pub(crate) use crate::state::painting::work::OnDisk;
use crate::state::painting::work::State;
pub use crate::state::painting::work::Work;
use crate::state::session::Session;
use crate::widgets::theme;
pub(crate) use import::Import;
pub(crate) use making::Made;
pub(crate) use start::{Preset, Shown, shown};
pub(crate) use tools::Kind;

/// Something that is asked for of what is painted; [`App`](crate::App) does it.
#[derive(Clone, Debug)]
pub(crate) enum Wish {
    /// A change as an undo step of its own.
    Edit(HcbtfEdit),
    /// A change that goes on for as long as the same widget is held: one undo step in all.
    EditHeld(egui::Id, HcbtfEdit),
    /// Works at another sample.
    GoTo(Address),
    /// Begins a new one, in a look of its own unless the open one is to stay.
    New {
        grid: Grid,
        keeps_look: bool,
    },
    /// Opens the one in a file. The open look stays where it shows that, or where it is to.
    Open {
        path: PathBuf,
        keeps_look: bool,
    },
    /// Divides the open one otherwise, which loses so many painted samples.
    Divide {
        grid: Grid,
        lost: usize,
    },
    /// Paints what the open look shows, or goes on with that; where it is more than one, shows
    /// which there are.
    PaintShown,
    /// Shows the open one in the look that it was painted in, or in one of its own.
    GoBack,
    /// Asks how finely a new one is divided, or how the open one is to be from now on.
    AskGrid {
        changes: bool,
    },
    /// Asks for a new tile of patches of the open one.
    AskSynthesis,
    /// Asks onto which grid the open look is to be baked.
    AskBake,
    /// Bakes it as was asked for; asks for the file where there is none.
    Bake {
        to: Option<PathBuf>,
    },
    /// Begins with what was made, in a look of its own.
    Begin {
        hcbtf: Arc<Hcbtf>,
    },
    /// Asks what pictures of other programs are to become an HCBTF.
    AskImport,
    /// Makes one of pictures; asks for them where there are none.
    Import {
        import: Import,
        from: Option<PathBuf>,
    },
    /// Asks how a texture is to be stored.
    AskTexture,
    /// Writes all samples in another program's form; asks where to.
    Export {
        form: Form,
        /// Of a texture.
        storage: Storage,
        to: Option<PathBuf>,
    },
    Save,
    SaveAs,
    /// Saves to this file.
    SaveTo(PathBuf),
    Close,
}

fn command(wish: Wish) -> Command {
    Command::Paint(wish)
}

/// The workspace, and what it remembers between frames.
pub struct Painting {
    tools: tools::Tools,
    easel: easel::Easel,
    map: map::Map,
    sheet: sheet::Sheet,
    atlas: map::Atlas,
    order: list::Order,
    held: Option<dome::Held>,
    filling: filling::Filling,
    exports: export::Exports,
    memory: memory::Memory,
    /// Which grid, while that is asked for.
    grid: Option<grid::Asked>,
    making: making::Making,
    /// What is to be imported, while that is asked for; the same of a new tile, and of a look that
    /// is baked.
    import: Option<Import>,
    synthesis: Option<synthesis::Asked>,
    baking: Option<baking::Asked>,
    /// What is baked once it has a file.
    bakes: Option<baking::Asked>,
    preview: preview::Preview,
    /// How a texture is to be stored, while that is asked for.
    storing: Option<Storage>,
    seen: seen::Seen,
    /// The sample that is only looked at, and the one for the next frame.
    peek: Option<Address>,
    next_peek: Option<Address>,
}

impl Painting {
    /// `wake` is called from another thread when rules have filled something, or something was
    /// exported. `device` is what it is drawn with.
    pub(crate) fn new(device: Device, wake: impl Fn() + Send + Clone + 'static) -> Self {
        Self {
            tools: tools::Tools::default(),
            easel: easel::Easel::default(),
            map: map::Map::default(),
            sheet: sheet::Sheet::default(),
            atlas: map::Atlas::default(),
            order: list::Order::default(),
            held: None,
            filling: filling::Filling::new(wake.clone()),
            exports: export::Exports::new(wake.clone()),
            memory: memory::Memory::new(device, wake.clone()),
            preview: preview::Preview::new(wake.clone()),
            making: making::Making::new(wake),
            grid: None,
            import: None,
            synthesis: None,
            baking: None,
            bakes: None,
            storing: None,
            seen: seen::Seen::default(),
            peek: None,
            next_peek: None,
        }
    }

    /// Asks what is to be imported.
    pub(crate) fn ask_import(&mut self) {
        self.import = Some(Import::default());
    }

    /// Asks how finely something new is divided, or how what is open is to be.
    pub(crate) fn ask_grid(&mut self, session: &Session, changes: bool) {
        self.grid = Some(grid::Asked::of(session.painting(), changes));
    }

    /// Asks for a new tile of patches of what is painted.
    pub(crate) fn ask_synthesis(&mut self, session: &Session) {
        let work = session.painting();
        self.synthesis = work.map(|work| synthesis::Asked::of(work, self.filling.of(work)));
    }

    /// Asks onto which grid the open look is to be baked.
    pub(crate) fn ask_bake(&mut self) {
        self.baking = Some(baking::Asked::default());
    }

    /// Asks how a texture is to be stored.
    pub(crate) fn ask_texture(&mut self) {
        self.storing = Some(Storage::default());
    }

    /// Remembers what is to be baked until there is a file for it.
    pub(crate) fn hold_bake(&mut self) {
        self.bakes = self.baking.take();
    }

    /// Bakes the open look as was asked for.
    ///
    /// # Errors
    /// Why it cannot be.
    pub(crate) fn bake(&mut self, session: &Session, to: PathBuf) -> Result<(), String> {
        let Some(asked) = self.bakes.take() else { return Ok(()) };
        self.making.begin(asked.job(session, to)?);
        Ok(())
    }

    /// Makes an HCBTF of pictures.
    pub(crate) fn import(&mut self, import: Import, from: PathBuf) {
        self.making.begin(making::Job::Import { import, from });
    }

    /// What was made since the last call, and is to be opened.
    pub(crate) fn made(&mut self) -> Option<Made> {
        match self.making.made()? {
            Made::Tile { made } => {
                if let Some(asked) = &mut self.synthesis {
                    asked.take(made);
                }
                None
            }
            made => Some(made),
        }
    }

    /// Whether one of this grid can be painted here.
    ///
    /// # Errors
    /// What the device cannot hold, and what to take less of.
    pub(crate) fn check(&self, grid: &Grid) -> Result<(), Diagnostic> {
        self.memory.device.check_painted(grid)
    }

    /// What is asked for in front of everything else, while it is.
    pub(crate) fn ask(&mut self, ui: &Ui, session: &Session) -> Option<Command> {
        self.making.show(ui);
        let (work, device) = (session.painting(), &self.memory.device);
        let is_filling = self.filling.is_busy() && look::shows(session);
        import::show(ui, &mut self.import)
            .or_else(|| grid::show(ui, &mut self.grid, work, device))
            .or_else(|| synthesis::show(ui, &mut self.synthesis, &mut self.making, work, device))
            .or_else(|| {
                baking::show(ui, &mut self.baking, &mut self.preview, session, device, is_filling)
            })
            .or_else(|| storing::show(ui, &mut self.storing, work, &mut self.memory))
    }

    /// Writes what is painted in another program's form.
    pub(crate) fn export(&self, session: &Session, form: Form, storage: Storage, to: PathBuf) {
        if let Some(work) = session.painting() {
            self.exports.write(work.shown().clone(), form, storage, to);
        }
    }

    /// What to tell of exports that are done.
    pub(crate) fn exported(&self) -> Option<String> {
        self.exports.told()
    }

    /// What is due once a frame, whichever panels are seen.
    pub(crate) fn tick(&mut self, session: &mut Session) {
        self.peek = self.next_peek.take();
        self.seen.tick(session);
        if let Some(work) = session.painting_mut()
            && self.filling.tick(work, &self.memory.device)
        {
            session.painting_changed();
        }
    }

    /// Shows one of its panels.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        panel: Panel,
        session: &mut Session,
    ) -> Vec<Command> {
        let mut out = Vec::new();
        if session.painting().is_none() || !self.seen.is_shown() {
            match panel {
                Panel::Paint => {
                    self.easel.leave();
                    start::show(ui, session, &mut out);
                }
                _ => dock::hint(ui, &start::in_short(session)),
            }
            return out;
        }
        match panel {
            Panel::Paint => self.show_easel(ui, session, &mut out),
            Panel::Samples | Panel::Directions => self.show_samples(ui, panel, session, &mut out),
            Panel::Sheet => {
                if let Some(work) = session.painting() {
                    self.sheet.show(ui, work, self.easel.is_painting(), &mut out);
                }
            }
            _ => {
                let problem = self.filling.problem.as_ref().map(sentence);
                if let Some(work) = session.painting() {
                    rules::show(
                        ui,
                        work,
                        self.filling.share(),
                        problem.as_deref(),
                        &mut self.memory,
                        &mut out,
                    );
                }
            }
        }
        out
    }

    fn show_easel(&mut self, ui: &mut Ui, session: &mut Session, out: &mut Vec<Command>) {
        toolbar::show(ui, &mut self.tools);
        if let Some(work) = session.painting() {
            self.options(ui, session, work, out);
        }
        let is_free = self.easel.has_pointer() && !shortcuts::is_keyboard_taken(ui.ctx());
        let before = session.painting().map(Work::before);
        let held =
            (is_free && ui.input(|input| input.key_down(Key::V))).then_some(before).flatten();
        out.extend(self.easel.show(ui, session, &mut self.tools, self.peek.or(held)));
        for action in self.easel.keys(ui) {
            self.act(action, session);
        }
    }

    /// Which sample is at work, and how it is shown.
    fn options(&mut self, ui: &mut Ui, session: &Session, work: &Work, out: &mut Vec<Command>) {
        let at = work.at();
        ui.horizontal_wrapped(|ui| {
            let (state, color) = match work.state(at) {
                State::Painted => ("painted".to_owned(), theme::of(ui).accent),
                State::Filled(rule) => {
                    (format!("filled by rule {}", rule + 1), theme::of(ui).second)
                }
                State::Empty => ("empty".to_owned(), theme::of(ui).dim),
            };
            let grid = work.grid();
            ui.label(format!("Light {}", moves::name(grid.light, at.light)));
            ui.label(RichText::new("·").color(theme::of(ui).dim));
            ui.label(format!("Eye {}", moves::name(grid.view, at.view)));
            let help = "A filled sample becomes painted by the first stroke, which begins from \
                        what is shown";
            ui.label(RichText::new(state).color(color)).on_hover_text(help);
            let is_painted = work.state(at) == State::Painted;
            let clear = ui.add_enabled(is_painted, Button::new("Delete painting").small());
            if clear.on_hover_text("Takes this painting away: the rules fill its place").clicked() {
                out.push(command(Wish::Edit(HcbtfEdit::DeleteTile { address: at })));
            }
            self.seen.mark(ui);
        });
        ui.horizontal_wrapped(|ui| {
            let easel = &mut self.easel;
            ui.toggle_value(&mut easel.is_flat, "Flat")
                .on_hover_text("Shows the tile unturned and untilted (F)");
            ui.toggle_value(&mut easel.shows_copies, "Copies").on_hover_text(
                "Repeats the tile around itself, so that seams are seen and painted across (C)",
            );
            ui.toggle_value(&mut easel.shows_arrows, "Arrows")
                .on_hover_text("Shows where the light comes from, and where the eye is (A)");
            if ui.small_button("Fit").on_hover_text("Shows the whole tile again (Home)").clicked() {
                easel.fit();
            }
            self.seen.turn(ui, session, work, out);
            ui.separator();
            let help = "How much of the neighbouring samples shines through";
            ui.label("Onion skin").on_hover_text(help);
            ui.spacing_mut().slider_width = 60.0;
            let slider = ui.add(Slider::new(&mut easel.onion, 0.0..=1.0).show_value(false));
            slider.widget_info(|| WidgetInfo::slider(true, f64::from(easel.onion), "Onion skin"));
            slider.on_hover_text(help);
        });
        // A row of its own, as a list does not wrap with the others.
        if self.easel.onion > 0.0 {
            rules::along(ui, "neighbours by", &mut self.easel.onion_along);
        }
    }

    fn show_samples(
        &mut self,
        ui: &mut Ui,
        panel: Panel,
        session: &Session,
        out: &mut Vec<Command>,
    ) {
        let Some(work) = session.painting() else { return };
        self.atlas.update(ui.ctx(), work, self.easel.is_painting());
        if panel == Panel::Samples {
            return self.map.show(ui, work, &self.atlas, &mut self.next_peek, out);
        }
        let side = ui.available_width().min(ui.available_height() * 0.55).clamp(90.0, 190.0);
        ui.vertical_centered(|ui| {
            if let Some(address) = dome::show(ui, work, &mut self.held, side) {
                out.push(command(Wish::GoTo(address)));
            }
        });
        list::show(ui, work, &self.atlas, &mut self.order, &mut self.next_peek, out);
    }

    /// Does what a key over the tile or the command palette asks for.
    pub(crate) fn act(&mut self, action: Action, session: &mut Session) {
        match action {
            Action::Tool(kind) => self.tools.take(kind),
            Action::Brush { is_larger } => self.tools.resize(is_larger),
            Action::SwapColors => self.tools.colors.swap(0, 1),
            Action::Flat => self.easel.is_flat = !self.easel.is_flat,
            Action::Copies => self.easel.shows_copies = !self.easel.shows_copies,
            Action::Arrows => self.easel.shows_arrows = !self.easel.shows_arrows,
            Action::FitTile => self.easel.fit(),
            Action::StepView(way) => step(session, way, true),
            Action::StepLight(way) => step(session, way, false),
            _ => {}
        }
    }

    /// What may be done at the pointer; empty while it is elsewhere.
    pub(crate) fn hint(&self) -> &str {
        &self.easel.hint
    }

    /// Whether the pointer is over the tile, so that keys are meant for it.
    pub(crate) fn has_pointer(&self) -> bool {
        self.easel.has_pointer()
    }

    /// Nothing of it is seen.
    pub(crate) fn rest(&mut self) {
        self.easel.leave();
    }

    /// Where a place of the tile is on the screen, in texels from its upper left corner; for tests.
    pub fn screen(&self, texel: [f64; 2]) -> Option<Pos2> {
        self.easel.screen(texel)
    }

    /// Where the cell of a sample is on the map; for tests.
    pub fn cell(&self, address: Address) -> Option<Rect> {
        self.map.cell(address)
    }

    /// Where a texel of a sample is on the sheet of all; for tests.
    pub fn on_sheet(&self, address: Address, texel: [u32; 2]) -> Option<Pos2> {
        self.sheet.screen(address, texel)
    }

    pub(crate) fn is_busy(&self) -> bool {
        let is_storing = self.exports.is_busy() || self.memory.is_busy();
        is_storing || self.filling.is_busy() || self.preview.is_busy() || self.making.is_busy()
    }

    pub(crate) fn wait(&self) {
        self.filling.wait();
        self.exports.wait();
        self.memory.wait();
        self.preview.wait();
        self.making.wait();
    }
}

/// So many of something, in words.
pub(crate) fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// Moves the eye or the light by one step.
fn step(session: &mut Session, way: Way, is_view: bool) {
    let Some(work) = session.painting_mut() else { return };
    let (grid, at) = (*work.grid(), work.at());
    work.go_to(match is_view {
        true => Address { view: moves::step(grid.view, at.view, way), ..at },
        false => Address { light: moves::step(grid.light, at.light, way), ..at },
    });
}
