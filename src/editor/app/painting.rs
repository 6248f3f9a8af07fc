//! Commands about the HCBTF that is being painted.
//! Light that is painted on the picture: `app::fitting`.

use std::path::{Path, PathBuf};

use chiaro_locale::{tr, trn};
use eframe::egui::Ui;

use super::App;
use super::files::PendingAction;
use crate::app::dock::Workspace;
use crate::commands::{FilePurpose, Heading, PaintCommand, PanelId, PictureImport};
use crate::diag::{Diagnostic, WithWarnings};
use crate::document::{Edit, Grid, Hcbtf, HcbtfEdit, Storage};
use crate::frame::UNSAVED_HCBTF;
use crate::hcbtf::exchange::ExchangeFormat;
use crate::painter::{MadePainting, shown, stepped};
use crate::state::painting::home::Home;
use crate::state::painting::look;
use crate::state::painting::work::OpenPainting;
use crate::state::problem_text::sentence;
use crate::state::revision::PaintingNumber;
use crate::state::session::painting::is_painting_shown;

impl App {
    pub(super) fn apply_to_painting(&mut self, ui: &Ui, command: PaintCommand) {
        match command {
            PaintCommand::Edit(change) => {
                self.tell(|session| session.apply_to_painting(change, None));
            }
            PaintCommand::EditHeld(widget, change) => {
                let gesture = self.gesture(ui, widget);
                self.tell(|session| session.apply_to_painting(change, Some(gesture)));
            }
            PaintCommand::GoTo(address) => {
                if let Some(work) = self.session.painting_mut() {
                    work.go_to(address);
                }
            }
            PaintCommand::New { grid, keeps_look } => {
                self.do_or_ask(PendingAction::NewPainting { grid, keeps_look });
            }
            PaintCommand::Open { path, keeps_look } => {
                self.do_or_ask(PendingAction::OpenPainting { path, keeps_look });
            }
            PaintCommand::Divide { grid, lost } => {
                let edit = HcbtfEdit::SetGrid { grid };
                let is_divided =
                    self.attempt(|session| session.apply_to_painting(edit, None)).is_some();
                if lost > 0 && is_divided {
                    self.message = Some(trn!(
                        lost,
                        "{lost} painted sample went with the old grid: Undo brings it back",
                        "{lost} painted samples went with the old grid: Undo brings them back"
                    ));
                }
            }
            PaintCommand::GoBack => self.do_or_ask(PendingAction::ShowPainting),
            PaintCommand::PaintShown => self.paint_shown(),
            PaintCommand::AskGrid { changes } => {
                self.bench.painting.ask_grid(&self.session, changes);
            }
            PaintCommand::AskSynthesis if self.session.painting().is_some() => {
                self.bench.painting.ask_synthesis(&self.session);
            }
            PaintCommand::AskSynthesis => {
                self.message = Some(
                    tr!("Nothing is open to be painted that a tile could be made of").to_owned(),
                );
            }
            PaintCommand::AskBake => self.bench.painting.ask_bake(),
            PaintCommand::Bake { to } => self.bake(to),
            PaintCommand::Begin { hcbtf } => self.do_or_ask(PendingAction::BeginPainting { hcbtf }),
            PaintCommand::AskImport => self.bench.painting.ask_import(),
            PaintCommand::Import { import, from: None } => {
                self.dialogs.ask(FilePurpose::ImportPainting(import), self.session.path());
            }
            PaintCommand::Import { import, from: Some(path) } => {
                self.do_or_ask(PendingAction::ImportPainting { path, import });
            }
            PaintCommand::AskTexture if self.session.painting().is_some() => {
                self.bench.painting.ask_texture();
            }
            PaintCommand::AskTexture => self.tell_nothing_to_export(),
            PaintCommand::Export { form, storage, to } => self.export_painting(form, storage, to),
            PaintCommand::Save => self.save_painting(),
            PaintCommand::SaveAs if self.session.painting().is_some() => {
                self.ask_where_to_save_painting();
            }
            PaintCommand::SaveAs => {}
            PaintCommand::SaveTo(path) => match self.write_painting(&path) {
                Ok(()) => self.go_on_if_safe(),
                Err(problem) => self.ask_again(FilePurpose::SavePainting, &path, &problem),
            },
            PaintCommand::StepView(heading) => self.step_painting(heading, true),
            PaintCommand::StepLight(heading) => self.step_painting(heading, false),
            PaintCommand::ShowStroke(stroke) => {
                if let Some(work) = self.session.painting_mut() {
                    work.set_live(stroke);
                    self.session.painting_changed();
                }
            }
            PaintCommand::Close => self.do_or_ask(PendingAction::ClosePainting),
            PaintCommand::TakeTool(_)
            | PaintCommand::ResizeBrush { .. }
            | PaintCommand::SwapColors
            | PaintCommand::ToggleTilt
            | PaintCommand::ToggleCopies
            | PaintCommand::ToggleArrows
            | PaintCommand::FitTile => self.bench.painting.apply(&command),
        }
    }

    /// Bakes the open look with the settings of the dialog; asks for the file where there is none.
    fn bake(&mut self, to: Option<PathBuf>) {
        let Some(to) = to else {
            self.bench.painting.hold_bake();
            let near = self.session.path().map(|path| path.with_extension("hcbtf"));
            let near = near.unwrap_or_else(|| PathBuf::from("baked.hcbtf"));
            return self.dialogs.ask(FilePurpose::BakeLook, Some(&near));
        };
        let is_painted = self.session.painting().and_then(OpenPainting::path) == Some(to.as_path());
        self.message = match is_painted {
            true => {
                Some(tr!("{file} is open to be painted: bake to another file", file = to.display()))
            }
            false => self.bench.painting.bake(&self.session, to).err(),
        };
    }

    /// Saves the painting to its own file; asks for one where there is none.
    fn save_painting(&mut self) {
        match self.session.painting().map(|work| work.path().map(Path::to_path_buf)) {
            Some(Some(path)) => drop(self.save_painting_as(&path)),
            Some(None) => self.ask_where_to_save_painting(),
            None => {}
        }
    }

    /// Moves on to the sample one step away from the one at work.
    fn step_painting(&mut self, heading: Heading, is_view: bool) {
        if let Some(work) = self.session.painting_mut() {
            work.go_to(stepped(work, heading, is_view));
        }
    }

    /// True if the open look shows the painting, and so stays when another one is painted in its
    /// place.
    pub(super) fn keeps_look(&self) -> bool {
        let path = match &self.pending {
            Some(PendingAction::OpenPainting { path, .. }) => Some(path.as_path()),
            Some(_) => None,
            None => {
                self.session.painting().map(|work| work.path().unwrap_or(Path::new(UNSAVED_HCBTF)))
            }
        };
        path.is_some_and(|path| self.session.shows_painting(path))
    }

    pub(super) fn new_painting(&mut self, grid: Grid, keeps_look: bool) {
        self.begin_painting(OpenPainting::new(grid), keeps_look);
    }

    /// Opens an HCBTF, in a look of its own where the open one does not show it; reports a failure.
    pub(super) fn open_painting(&mut self, path: &Path, keeps_look: bool) {
        let Some(_going) = self.begin_to_read(path) else { return };
        match OpenPainting::open(&**self.session.assets.source(), path) {
            Ok(work) => {
                let stays = keeps_look || self.session.shows_painting(path);
                if self.begin_painting(work, stays) {
                    self.safety.opened(path);
                    self.name_copy_of_example(path);
                }
            }
            Err(problems) => self.safety.could_not_open(path, &problems, &self.session),
        }
    }

    /// Lets the open look show the painting wherever it named the example which the painting is a
    /// copy of, as one step.
    fn name_copy_of_example(&mut self, path: &Path) {
        let Some(work) = self.session.painting().filter(|work| work.example().is_some()) else {
            return;
        };
        let told = tr!("{name}: saving asks where it is to go", name = work.name());
        let name = path.to_string_lossy();
        let edits =
            look::rename(self.session.look(), &self.session.project.catalog, &name, UNSAVED_HCBTF);
        if !edits.is_empty() {
            // An untouched look without a file has nothing to save either, and stays so.
            let is_untouched = self.session.path().is_none() && !self.session.is_look_dirty();
            self.tell(|session| session.apply(Edit::Group { edits }, None));
            if is_untouched {
                self.session.count_as_saved();
            }
        }
        self.message.get_or_insert(told);
    }

    /// Paints the one HCBTF that the open look shows, or shows the choice between several.
    fn paint_shown(&mut self) {
        if is_painting_shown(&self.session) {
            return self.show_painting_panels();
        }
        let mut shown = shown(&self.session);
        match (shown.pop(), shown.is_empty()) {
            (Some(only), true) => {
                self.do_or_ask(PendingAction::OpenPainting { path: only.path, keeps_look: true });
            }
            (Some(_), false) => {
                self.start = None;
                self.dock.open(PanelId::PAINT);
            }
            (None, _) => {
                self.message = Some(tr!("The open look shows nothing that is painted").to_owned());
            }
        }
    }

    /// Shows the painting in the look that it was painted in; where that look is not available, in
    /// a look of its own.
    pub(super) fn go_back_to_painting(&mut self) {
        self.view_before_painting.keep(&self.session);
        let home = self.session.painting().and_then(OpenPainting::home).cloned();
        if !home.is_some_and(|home| self.open_home(&home)) {
            self.begin_bare_look();
        }
        self.safety.look();
        self.show_painting_panels();
    }

    /// Opens a look that showed the painting, with its changes. Returns true if it still does.
    fn open_home(&mut self, home: &Home) -> bool {
        match &home.path {
            Some(path) if path.is_file() => {
                self.safety.want_back(path);
                self.open(path);
            }
            _ if self.safety.take_back_look(&home.look, &mut self.session) => {}
            _ => self.session.start_from(&home.look.to_text(), &home.name()),
        }
        let is_shown = is_painting_shown(&self.session);
        if is_shown && self.session.open_scene().is_none() {
            self.session.view.orbit = home.view.clone();
        }
        is_shown
    }

    /// Begins to make an HCBTF of pictures of other programs.
    pub(super) fn import_painting(&mut self, path: PathBuf, import: PictureImport) {
        self.bench.painting.import(import, path);
    }

    /// Takes an HCBTF that another thread made; reports a failure.
    pub(super) fn take_made(&mut self) {
        match self.bench.painting.made() {
            Some(MadePainting::Imported { from, made }) => self.take_import(&from, made),
            Some(MadePainting::Baked { to, made: Ok(count) }) => {
                let told = trn!(
                    count,
                    "Baked {file}: {count} sample",
                    "Baked {file}: {count} samples",
                    file = to.display()
                );
                self.do_or_ask(PendingAction::OpenPainting { path: to, keeps_look: false });
                self.message = Some(told);
            }
            Some(MadePainting::Baked { to, made: Err(problems) }) => {
                let why = problems
                    .first()
                    .map(|problem| sentence(problem).replace('\n', ": "))
                    .unwrap_or_default();
                self.message = Some(tr!("{file} was not baked: {why}", file = to.display()));
            }
            Some(MadePainting::Tile { .. }) | None => {}
        }
    }

    /// Begins to paint on an HCBTF that was made from the previous one.
    pub(super) fn begin_made(&mut self, hcbtf: &Hcbtf) {
        let [width, height] = hcbtf.grid.size;
        if self.begin_painting(OpenPainting::imported(hcbtf.clone(), Vec::new()), false) {
            self.message =
                Some(tr!("A new painting of {width} x {height} texels; save it to keep it"));
        }
    }

    fn take_import(&mut self, path: &Path, made: Result<WithWarnings<Hcbtf>, Vec<Diagnostic>>) {
        match made {
            Ok(WithWarnings { value: hcbtf, warnings: notes }) => {
                let told = tr!(
                    "{painted} of {all} samples are painted",
                    painted = hcbtf.painted.len(),
                    all = hcbtf.grid.sample_count()
                );
                if self.begin_painting(OpenPainting::imported(hcbtf, notes), false) {
                    self.message = Some(
                        self.message.take().map_or(told.clone(), |note| format!("{told} · {note}")),
                    );
                }
            }
            Err(problems) => {
                let why =
                    problems.first().map(|problem| problem.message.as_str()).unwrap_or_default();
                self.message =
                    Some(tr!("{file} could not be imported: {why}", file = path.display()));
            }
        }
    }

    fn tell_nothing_to_export(&mut self) {
        self.message = Some(tr!("Nothing is open to be painted that could be exported").to_owned());
    }

    fn export_painting(&mut self, form: ExchangeFormat, storage: Storage, to: Option<PathBuf>) {
        let Some(work) = self.session.painting() else { return self.tell_nothing_to_export() };
        let Some(to) = to else {
            let own =
                work.path().map_or_else(|| PathBuf::from(work.suggested()), Path::to_path_buf);
            let stem = own.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let name = match form {
                ExchangeFormat::Folder => format!("{stem}-images"),
                ExchangeFormat::Contact => format!("{stem}-contact.png"),
                ExchangeFormat::Sheet => format!("{stem}-sheet.png"),
                ExchangeFormat::Ktx2 => format!("{stem}.ktx2"),
            };
            return self
                .dialogs
                .ask(FilePurpose::ExportPainting(form, storage), Some(&own.with_file_name(name)));
        };
        self.bench.painting.export(&self.session, form, storage, to);
    }

    /// Begins to paint an HCBTF, if the device can hold it; reports the reason otherwise. Returns
    /// true if painting began.
    fn begin_painting(&mut self, work: OpenPainting, keeps_look: bool) -> bool {
        if let Err(problem) = self.bench.painting.check(work.grid()) {
            let why = sentence(&problem).replace('\n', ": ");
            self.message = Some(tr!("{name} cannot be painted here: {why}", name = work.name()));
            return false;
        }
        let told = work.document.load_problems.first().map(|problem| problem.message.clone());
        self.session.set_painting(Some(work));
        if !keeps_look {
            self.begin_bare_look();
        }
        self.safety.look();
        self.show_painting_panels();
        self.message = told;
        true
    }

    /// Begins a look that shows the painting, and nothing else.
    fn begin_bare_look(&mut self) {
        let Some(work) = self.session.painting() else { return };
        let sheet =
            work.path().map_or_else(|| UNSAVED_HCBTF.to_owned(), |path| path.display().to_string());
        let look = look::default_look(&sheet, &work.kept_name(), work.grid().size);
        self.view_before_painting.keep(&self.session);
        self.session.start_from(&look, "painting");
        self.session.view.orbit.look_at_a_sheet();
    }

    pub(super) fn show_painting_panels(&mut self) {
        self.view_before_painting.is_painted(&self.session);
        self.start = None;
        self.dock.enter(Workspace::Painting);
        self.laid_out_for = Some((self.session.revisions().document, self.painting_number()));
        self.dock.open(PanelId::PAINT);
    }

    /// Shows the painting after work was taken back, if a painting came back. Where nothing else is
    /// open the painting is shown in the look that was left with it, or in one of its own. `before`
    /// is the number of the previous painting.
    pub(super) fn show_painting_taken_back(&mut self, before: Option<PaintingNumber>) {
        let now = self.painting_number();
        if now.is_none() || now == before {
            return;
        }
        let is_new = self.session.path().is_none()
            && !self.session.is_look_dirty()
            && self.session.open_scene().is_none();
        if is_new && self.safety.take_back_look_of_painting(&mut self.session) {
            let painting = self.session.painting().map(OpenPainting::name).unwrap_or_default();
            let told = tr!(
                "{painting} and {look} are as they were, with all their changes",
                look = self.session.name()
            );
            self.message = Some(told);
        } else if is_new {
            self.begin_bare_look();
        }
        if is_painting_shown(&self.session) {
            return self.show_painting_panels();
        }
        self.start = None;
        self.dock.open(PanelId::PAINT);
    }

    /// Number of the painting, different for each one opened.
    pub(super) fn painting_number(&self) -> Option<PaintingNumber> {
        self.session.painting().map(OpenPainting::number)
    }

    pub(super) fn close_painting(&mut self) {
        self.session.give_up_copy();
        self.session.set_painting(None);
        self.safety.look();
    }

    fn ask_where_to_save_painting(&mut self) {
        let Some(work) = self.session.painting() else { return };
        let (own, name) = (work.path().map(Path::to_path_buf), work.suggested());
        let near = || self.session.path().map(|path| path.with_file_name(&name));
        let near = own.or_else(near).unwrap_or_else(|| PathBuf::from(&name));
        self.dialogs.ask(FilePurpose::SavePainting, Some(&near));
    }

    /// Saves the painting to a file, which is its own from then on, and reports a failure. Returns
    /// true if the file is written.
    pub fn save_painting_as(&mut self, path: &Path) -> bool {
        self.write_painting(path).is_ok()
    }

    fn write_painting(&mut self, path: &Path) -> Result<(), Box<Diagnostic>> {
        let saved = self.session.save_painting_as(path);
        self.tell_saved(path, saved)
    }

    /// Saves the painting before a look that shows it. Returns true if there was anything to save;
    /// `None` where it is not saved yet.
    pub(super) fn save_painting_first(&mut self) -> Option<bool> {
        if !self.saves_painting() {
            return Some(false);
        }
        match self.session.painting().and_then(OpenPainting::path).map(Path::to_path_buf) {
            Some(path) => self.save_painting_as(&path).then_some(true),
            None => {
                self.ask_where_to_save_painting();
                None
            }
        }
    }
}
