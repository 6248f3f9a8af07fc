//! The painting workspace: painting on an HCBTF, going through its samples, and filling the rest by
//! rules.
//!
//! An [`OpenPainting`] is the document with its history, kept by the session as looks and scenes
//! are. Five panels show it: `easel`, with the tools above it, shows the tile as the eye sees it;
//! `map` all lights and views at a glance; `sheet` all samples as one picture; `dome` with `list`
//! the directions of the light and the eye; and `rules` the rules that fill the rest. A stroke
//! changes the shown state at once; once it ends it becomes an [`HcbtfEdit`], which
//! [`App`](crate::App) applies. The painting appears in the viewport at once: the session gives it
//! to the renderer in place of the file.

mod arrows;
mod atlas;
mod baking;
pub(crate) mod before;
mod dome;
mod easel;
mod export;
mod filling;
mod grid;
mod icons;
mod import;
mod list;
mod making;
mod map;
mod memory;
mod moves;
mod pointer;
mod preview;
mod rules;
mod sheet;
mod start;
mod storing;
mod synthesis;
mod textures;
mod tilt;
mod toolbar;
mod tools;
mod visibility;

use std::path::PathBuf;

use chiaro_locale::tr;
use eframe::egui::{Button, Key, Pos2, Rect, RichText, Ui, WidgetInfo};

use crate::commands::keyboard;
use crate::commands::{Command, Heading, PaintCommand, PictureImport};
use crate::diag::Diagnostic;
use crate::document::{Address, Grid, HcbtfEdit, Storage};
use crate::hcbtf::Device;
use crate::hcbtf::exchange::ExchangeFormat;
use crate::state::painting::PaintingUpdate;
use crate::state::painting::work::OpenPainting;
use crate::state::painting::work::SampleState;
use crate::state::problem_text::sentence;
use crate::state::session::Session;
use crate::state::session::painting::is_painting_shown;
use crate::state::worker::BackgroundJobs;
use crate::widgets::number::number_slider;
use crate::widgets::text::hint;
use crate::widgets::theme;
pub(crate) use making::MadePainting;
pub(crate) use start::{ShownPainting, shown};

/// The workspace and its state between frames.
pub struct Painting {
    tools: tools::Tools,
    easel: easel::Easel,
    map: map::Map,
    sheet: sheet::Sheet,
    atlas: map::Atlas,
    order: list::Order,
    held: Option<dome::HeldHandle>,
    filling: filling::FillWorker,
    exports: export::Exports,
    memory: memory::Memory,
    /// Dialog for a grid, while it is open.
    grid: Option<grid::GridDialog>,
    making: making::HcbtfWorker,
    /// Dialog for an import, while it is open; likewise the dialogs for a new tile and for a look
    /// to bake.
    import: Option<PictureImport>,
    synthesis: Option<synthesis::SynthesisDialog>,
    baking: Option<baking::BakeDialog>,
    /// Bake that waits for its file.
    bakes: Option<baking::BakeDialog>,
    preview: preview::Preview,
    /// Storage of an exported texture, while its dialog is open.
    storing: Option<Storage>,
    seen: visibility::PaintingVisibility,
    /// Sample that is only looked at, and the one for the next frame.
    peek: Option<Address>,
    next_peek: Option<Address>,
}

impl Painting {
    /// `wake` is called from another thread when rules have filled samples, or an export is done.
    /// `device` gives the limits of the GPU that the painting is drawn with.
    pub(crate) fn new(device: Device, wake: impl Fn() + Send + Clone + 'static) -> Self {
        Self {
            tools: tools::Tools::default(),
            easel: easel::Easel::default(),
            map: map::Map::default(),
            sheet: sheet::Sheet::default(),
            atlas: map::Atlas::default(),
            order: list::Order::default(),
            held: None,
            filling: filling::FillWorker::new(wake.clone()),
            exports: export::Exports::new(wake.clone()),
            memory: memory::Memory::new(device, wake.clone()),
            preview: preview::Preview::new(wake.clone()),
            making: making::HcbtfWorker::new(wake),
            grid: None,
            import: None,
            synthesis: None,
            baking: None,
            bakes: None,
            storing: None,
            seen: visibility::PaintingVisibility::default(),
            peek: None,
            next_peek: None,
        }
    }

    /// Opens the dialog for an import.
    pub(crate) fn ask_import(&mut self) {
        self.import = Some(PictureImport::default());
    }

    /// Opens the dialog for the grid of a new painting, or of the open one if `changes` is set.
    pub(crate) fn ask_grid(&mut self, session: &Session, changes: bool) {
        self.grid = Some(grid::GridDialog::of(session.painting(), changes));
    }

    /// Opens the dialog for a new tile made of patches of the painted one.
    pub(crate) fn ask_synthesis(&mut self, session: &Session) {
        let work = session.painting();
        self.synthesis =
            work.map(|work| synthesis::SynthesisDialog::of(work, self.filling.of(work)));
    }

    /// Opens the dialog for the grid that the open look is to be baked onto.
    pub(crate) fn ask_bake(&mut self) {
        self.baking = Some(baking::BakeDialog::default());
    }

    /// Opens the dialog for the storage of an exported texture.
    pub(crate) fn ask_texture(&mut self) {
        self.storing = Some(Storage::default());
    }

    /// Keeps the bake until its file is chosen.
    pub(crate) fn hold_bake(&mut self) {
        self.bakes = self.baking.take();
    }

    /// Bakes the open look with the choices of the dialog.
    ///
    /// # Errors
    /// The reason why the look cannot be baked.
    pub(crate) fn bake(&mut self, session: &Session, to: PathBuf) -> Result<(), String> {
        let Some(asked) = self.bakes.take() else { return Ok(()) };
        self.making.begin(asked.job(session, to)?);
        Ok(())
    }

    /// Makes an HCBTF from pictures.
    pub(crate) fn import(&mut self, import: PictureImport, from: PathBuf) {
        self.making.begin(making::MakeRequest::Import { import, from });
    }

    /// HCBTF that was made since the last call, and is to be opened.
    pub(crate) fn made(&mut self) -> Option<MadePainting> {
        match self.making.made()? {
            MadePainting::Tile { made } => {
                if let Some(asked) = &mut self.synthesis {
                    asked.take(made);
                }
                None
            }
            made => Some(made),
        }
    }

    /// Checks that a painting of this grid fits the device.
    ///
    /// # Errors
    /// The limit of the device that the grid exceeds, and how to reduce the grid.
    pub(crate) fn check(&self, grid: &Grid) -> Result<(), Diagnostic> {
        self.memory.device.check_painted(grid)
    }

    /// Shows the dialog that is open, in front of everything else.
    pub(crate) fn ask(&mut self, ui: &Ui, session: &Session) -> Option<Command> {
        self.making.show(ui);
        let (work, device) = (session.painting(), &self.memory.device);
        let is_filling = self.filling.is_busy() && is_painting_shown(session);
        import::show(ui, &mut self.import)
            .or_else(|| grid::show(ui, &mut self.grid, work, device))
            .or_else(|| synthesis::show(ui, &mut self.synthesis, &mut self.making, work, device))
            .or_else(|| {
                baking::show(ui, &mut self.baking, &mut self.preview, session, device, is_filling)
            })
            .or_else(|| storing::show(ui, &mut self.storing, work, &mut self.memory))
    }

    /// Writes the painting in another program's form.
    pub(crate) fn export(
        &self,
        session: &Session,
        form: ExchangeFormat,
        storage: Storage,
        to: PathBuf,
    ) {
        if let Some(work) = session.painting() {
            self.exports.write(work.shown().clone(), form, storage, to);
        }
    }

    /// Message about exports that are done.
    pub(crate) fn exported(&self) -> Option<String> {
        self.exports.told()
    }

    /// Work that is due once a frame, whichever panels are seen.
    pub(crate) fn tick(&mut self, session: &Session) -> PaintingUpdate {
        self.peek = self.next_peek.take();
        self.seen.tick(session)
    }

    /// Takes samples that rules filled, and requests the missing ones. Returns true if there are
    /// new ones.
    pub(crate) fn fill(&mut self, work: &mut OpenPainting) -> bool {
        self.filling.tick(work, &self.memory.device)
    }

    /// The open painting, where the open look shows it.
    fn shown<'s>(&self, session: &'s Session) -> Option<&'s OpenPainting> {
        session.painting().filter(|_| self.seen.is_shown())
    }

    /// Shows the tools, and handles the pointer and the keys on the tile.
    pub(crate) fn interact(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        let Some(work) = self.shown(session) else {
            self.easel.leave();
            return out;
        };
        toolbar::show(ui, &mut self.tools);
        self.options(ui, session, work, &mut out);
        let is_free = self.easel.has_pointer() && !keyboard::is_keyboard_taken(ui.ctx());
        let held = (is_free && ui.input(|input| input.key_down(Key::V))).then_some(work.before());
        out.extend(self.easel.interact(ui, work, &mut self.tools, self.peek.or(held)));
        out.extend(self.easel.keys(ui));
        out
    }

    /// Shows the tile as the eye sees it, or the ways to begin a painting.
    pub(crate) fn show_tile(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        match self.shown(session) {
            Some(work) => self.easel.show(ui, work, &self.tools),
            None => start::show(ui, session, &mut out),
        }
        out
    }

    /// Shows all lights and views of the painting at a glance.
    pub(crate) fn show_samples(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        match self.shown(session) {
            Some(work) => {
                self.atlas.update(ui.ctx(), work, self.easel.is_painting());
                self.map.show(ui, work, &self.atlas, &mut self.next_peek, &mut out);
            }
            None => hint(ui, &start::in_short(session)),
        }
        out
    }

    /// Shows all painted and filled samples in one picture.
    pub(crate) fn show_sheet(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        match self.shown(session) {
            Some(work) => self.sheet.show(ui, work, self.easel.is_painting(), &mut out),
            None => hint(ui, &start::in_short(session)),
        }
        out
    }

    /// Shows the directions of the light and the eye, and the list of painted samples.
    pub(crate) fn show_directions(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        let Some(work) = self.shown(session) else {
            hint(ui, &start::in_short(session));
            return out;
        };
        self.atlas.update(ui.ctx(), work, self.easel.is_painting());
        let side = ui.available_width().min(ui.available_height() * 0.55).clamp(90.0, 190.0);
        ui.vertical_centered(|ui| {
            if let Some(address) = dome::show(ui, work, &mut self.held, side) {
                out.push(Command::Paint(PaintCommand::GoTo(address)));
            }
        });
        list::show(ui, work, &self.atlas, &mut self.order, &mut self.next_peek, &mut out);
        out
    }

    /// Shows the rules that fill the rest.
    pub(crate) fn show_rules(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut out = Vec::new();
        let Some(work) = self.shown(session) else {
            hint(ui, &start::in_short(session));
            return out;
        };
        let problem = self.filling.problem.as_ref().map(sentence);
        let share = self.filling.share();
        rules::show(ui, work, share, problem.as_deref(), &mut self.memory, &mut out);
        out
    }

    /// Shows the sample at work, and the options of its display.
    fn options(
        &mut self,
        ui: &mut Ui,
        session: &Session,
        work: &OpenPainting,
        out: &mut Vec<Command>,
    ) {
        let at = work.at();
        ui.horizontal_wrapped(|ui| {
            let color = match work.state(at) {
                SampleState::Painted => theme::of(ui).accent,
                SampleState::Filled(_) => theme::of(ui).second,
                SampleState::Empty => theme::of(ui).dim,
            };
            let grid = work.grid();
            ui.label(tr!("Light {direction}", direction = moves::name(grid.light, at.light)));
            ui.label(RichText::new("·").color(theme::of(ui).dim));
            ui.label(tr!("Eye {direction}", direction = moves::name(grid.view, at.view)));
            let help = tr!(
                "A filled sample becomes painted by the first stroke, which begins from what is \
                 shown"
            );
            ui.label(RichText::new(told_state(work.state(at))).color(color)).on_hover_text(help);
            let is_painted = work.state(at) == SampleState::Painted;
            let clear = ui.add_enabled(is_painted, Button::new(tr!("Delete painting")).small());
            if clear
                .on_hover_text(tr!("Takes this painting away: the rules fill its place"))
                .clicked()
            {
                out.push(Command::Paint(PaintCommand::Edit(HcbtfEdit::DeleteTile { address: at })));
            }
            self.seen.mark(ui);
        });
        ui.horizontal_wrapped(|ui| {
            let easel = &mut self.easel;
            ui.toggle_value(&mut easel.is_flat, tr!("Flat"))
                .on_hover_text(tr!("Shows the tile unturned and untilted (F)"));
            ui.toggle_value(&mut easel.shows_copies, tr!("Copies")).on_hover_text(tr!(
                "Repeats the tile around itself, so that seams are seen and painted across (C)"
            ));
            ui.toggle_value(&mut easel.shows_arrows, tr!("Arrows"))
                .on_hover_text(tr!("Shows where the light comes from, and where the eye is (A)"));
            if ui
                .small_button(tr!("Fit"))
                .on_hover_text(tr!("Shows the whole tile again (Home)"))
                .clicked()
            {
                easel.fit();
            }
            self.seen.turn(ui, session, work, out);
            ui.separator();
            let help = tr!("How much of the neighboring samples shines through");
            ui.label(tr!("Onion skin")).on_hover_text(help);
            ui.spacing_mut().slider_width = 60.0;
            let slider = ui.add(number_slider(ui, &mut easel.onion, 0.0..=1.0).show_value(false));
            slider.widget_info(|| {
                WidgetInfo::slider(true, f64::from(easel.onion), tr!("Onion skin"))
            });
            slider.on_hover_text(help);
        });
        // The list of angles has a row of its own, as it does not wrap with the other widgets.
        if self.easel.onion > 0.0 {
            rules::along(ui, tr!("neighbors by"), &mut self.easel.onion_along);
        }
    }

    /// Applies a command on the tools or on the display of the tile.
    pub(crate) fn apply(&mut self, command: &PaintCommand) {
        match command {
            PaintCommand::TakeTool(tool) => self.tools.take(*tool),
            PaintCommand::ResizeBrush { is_larger } => self.tools.resize(*is_larger),
            PaintCommand::SwapColors => self.tools.colors.swap(0, 1),
            PaintCommand::ToggleTilt => self.easel.is_flat = !self.easel.is_flat,
            PaintCommand::ToggleCopies => self.easel.shows_copies = !self.easel.shows_copies,
            PaintCommand::ToggleArrows => self.easel.shows_arrows = !self.easel.shows_arrows,
            PaintCommand::FitTile => self.easel.fit(),
            _ => {}
        }
    }

    /// Hint on the actions possible at the pointer; empty while the pointer is not over the tile.
    pub(crate) fn hint(&self) -> &str {
        &self.easel.hint
    }

    /// True while the pointer is over the tile, so that keys are meant for painting.
    pub(crate) fn has_pointer(&self) -> bool {
        self.easel.has_pointer()
    }

    /// Notes that no panel of the workspace is shown.
    pub(crate) fn rest(&mut self) {
        self.easel.leave();
    }

    /// Position on the screen of a place of the tile, given in texels from the tile's upper left
    /// corner; for tests.
    pub fn screen(&self, texel: [f64; 2]) -> Option<Pos2> {
        self.easel.screen(texel)
    }

    /// Rectangle of a sample's cell on the map; for tests.
    pub fn cell(&self, address: Address) -> Option<Rect> {
        self.map.cell(address)
    }

    /// Position of a sample's texel on the sheet; for tests.
    pub fn on_sheet(&self, address: Address, texel: [u32; 2]) -> Option<Pos2> {
        self.sheet.screen(address, texel)
    }
}

impl BackgroundJobs for Painting {
    fn is_busy(&self) -> bool {
        let is_storing = self.exports.is_busy() || self.memory.is_busy();
        is_storing || self.filling.is_busy() || self.preview.is_busy() || self.making.is_busy()
    }

    fn wait(&self) {
        self.filling.wait();
        self.exports.wait();
        self.memory.wait();
        self.preview.wait();
        self.making.wait();
    }
}

/// State of a sample in a few words.
fn told_state(state: SampleState) -> String {
    match state {
        SampleState::Painted => tr!("sample" => "painted").to_owned(),
        SampleState::Filled(rule) => tr!("filled by rule {number}", number = rule + 1),
        SampleState::Empty => tr!("sample" => "empty").to_owned(),
    }
}

/// Sample that is one step from the one at work, by the eye or by the light.
pub(crate) fn stepped(work: &OpenPainting, heading: Heading, is_view: bool) -> Address {
    let (grid, at) = (work.grid(), work.at());
    match is_view {
        true => Address { view: moves::step(grid.view, at.view, heading), ..at },
        false => Address { light: moves::step(grid.light, at.light, heading), ..at },
    }
}
