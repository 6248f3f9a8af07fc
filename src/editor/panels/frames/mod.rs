//! Frames rendered from the window, and jobs of farms: choices, the command line that they are, and
//! how far it is. The program itself does the work, in a process beside the window.

mod choices;
pub(crate) mod document;
mod farm;
mod outputs;
mod progress;

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use chiaro_locale::{text, tr, trn};
use eframe::egui::{Button, RichText, ScrollArea, Ui};

use crate::clock::Clock;
use crate::commands::{Command, FilmCommand, PanelId};
use crate::files::make_folder;
use crate::film::farm::DEFAULT_CHUNK;
use crate::panels::table::{PanelContext, PanelPlace, PanelRow};
use crate::state::runs::{
    CommandLine, FarmChoices, FilmDocument, FrameChoices, FrameProgress, FrameSources, ProgramRun,
    RunEnd, RunLine,
};
use crate::state::session::Session;
use crate::state::worker::BackgroundJobs;
use crate::widgets::text::hint;
use crate::widgets::theme;
use document::{document_of, is_unsaved};
use outputs::OutputMenu;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::FRAMES,
    text!("Render"),
    text!("Frames of what is open, rendered beside the window, and jobs of render farms"),
    PanelPlace::WITH_DOCUMENT.closed(),
    |bench, ui, context| bench.frames.show(ui, context),
)
.with_each_frame(|bench, _, _, _| bench.frames.update())
.with_jobs(|bench| &bench.frames);

/// Frames of the window until a panel that opens has its place.
const FRAMES_TO_SHOW: u8 = 4;

/// Frames that are rendered, or were rendered last.
struct FrameRun {
    run: ProgramRun,
    progress: FrameProgress,
    clock: Clock,
    end: Option<RunEnd>,
    /// Seconds until the end.
    seconds: f64,
    /// Document that is rendered.
    document: PathBuf,
    /// Files that the frames are drawn of.
    sources: FrameSources,
    /// Name of a file that draws other pictures since.
    stale_by: Option<String>,
    /// Folder of the frames, and the file of the first one.
    folder: PathBuf,
    first: PathBuf,
}

/// Job of a farm that is written, or was written last.
struct JobRun {
    run: ProgramRun,
    line: CommandLine,
    messages: Vec<String>,
    end: Option<RunEnd>,
    /// Document that is sent.
    document: PathBuf,
    /// The file of the job, and the word of the farm.
    file: PathBuf,
    farm: &'static str,
    /// Earlier job of that file, put aside until the new one is whole.
    earlier: Option<PathBuf>,
}

impl JobRun {
    /// Drops the earlier job where the new one is whole, and otherwise brings it back.
    fn settle_earlier(&mut self) {
        let Some(earlier) = self.earlier.take() else { return };
        let is_settled = match self.end {
            Some(RunEnd::Done) => fs::remove_file(&earlier),
            _ => fs::rename(&earlier, &self.file),
        };
        if let Err(error) = is_settled {
            let earlier = earlier.display();
            self.messages.push(tr!("warning: the earlier job is {earlier}: {error}"));
        }
    }
}

/// The panel.
pub(crate) struct FrameRenders {
    wake: Arc<dyn Fn() + Send + Sync>,
    choices: FrameChoices,
    outputs: OutputMenu,
    /// Greatest number of frames of a farm's task, of documents that do not say it.
    chunk: u32,
    /// Document that the choices are of.
    of: Option<PathBuf>,
    /// Choices of other documents.
    others: HashMap<PathBuf, FrameChoices>,
    /// Jobs that this window wrote, as they were then.
    written: HashMap<PathBuf, Vec<u8>>,
    frames: Option<FrameRun>,
    job: Option<JobRun>,
    /// Reason why nothing was started.
    problem: Option<String>,
    /// Number of frames of the window for which the choices of a farm are brought into view.
    shows_farm: u8,
    /// True if the next job replaces a file that this window did not write.
    replaces_job: bool,
}

impl BackgroundJobs for FrameRenders {
    fn is_busy(&self) -> bool {
        self.runs().any(ProgramRun::is_going_on)
    }

    fn wait(&self) {
        self.runs().for_each(ProgramRun::wait);
    }
}

impl FrameRenders {
    /// `wake` is called from other threads when a run tells something.
    pub(crate) fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            wake: Arc::new(wake),
            choices: FrameChoices::default(),
            outputs: OutputMenu::default(),
            chunk: DEFAULT_CHUNK,
            of: None,
            others: HashMap::new(),
            written: HashMap::new(),
            frames: None,
            job: None,
            problem: None,
            shows_farm: 0,
            replaces_job: false,
        }
    }

    fn runs(&self) -> impl Iterator<Item = &ProgramRun> {
        let frames = self.frames.iter().map(|frames| &frames.run);
        frames.chain(self.job.iter().map(|job| &job.run))
    }

    /// Sets the folder of the frames: from the document's where it is below that.
    pub(crate) fn set_folder(&mut self, session: &Session, folder: &Path) {
        let own = document_of(session).ok().map(|document| document.folder());
        let below = own.and_then(|own| folder.strip_prefix(own).ok().map(Path::to_path_buf));
        let folder = below.unwrap_or_else(|| folder.to_path_buf());
        self.choices.folder = folder.to_string_lossy().into_owned();
    }

    /// Folder that a dialog for the frames' folder begins at.
    pub(crate) fn folder(&self, session: &Session) -> Option<PathBuf> {
        Some(self.choices.folder_of(&document_of(session).ok()?))
    }

    /// Brings the choices of a farm into view when the panel is shown next.
    pub(crate) fn show_farm(&mut self) {
        self.shows_farm = FRAMES_TO_SHOW;
    }

    /// Frames and jobs that are being made, each in a sentence on what a stop leaves of them.
    pub(crate) fn going_on(&self) -> Vec<String> {
        let frames = self.frames.as_ref().filter(|frames| frames.run.is_going_on());
        let frames = frames.map(|frames| {
            let [whole, all] = frames.progress.count();
            let name = frames.document.file_name().unwrap_or_default().to_string_lossy();
            tr!("{whole} of {all} frames of {name} are whole. They stay, and the next run goes on \
                 there.")
        });
        let job = self.job.as_ref().filter(|job| job.run.is_going_on());
        let job = job.map(|job| {
            let name = job.file.file_name().unwrap_or_default().to_string_lossy();
            tr!("The job {name} is not written yet.")
        });
        frames.into_iter().chain(job).collect()
    }

    /// Asks the program to stop rendering.
    pub(crate) fn stop(&self) {
        self.runs().for_each(ProgramRun::stop);
    }

    /// Renders the frames, by the program of this file.
    pub(crate) fn render(&mut self, context: PanelContext<'_>, program: &Path) {
        self.problem = self.start_frames(context, program).err();
    }

    /// Writes the job of a farm, by the program of this file.
    pub(crate) fn write_job(&mut self, context: PanelContext<'_>, program: &Path) {
        self.problem = self.start_job(context, program).err();
    }

    fn start_frames(&mut self, context: PanelContext<'_>, program: &Path) -> Result<(), String> {
        let document = document_of(context.session)?;
        let asked = self.choices.files(&document)?;
        let mut line = self.choices.render(&document, view_of(context))?;
        let folder = self.make_folder(&document)?;
        let files = context.session.assets.source();
        let sources = FrameSources::of(context.session.drawn_files(), &**files);
        line.words.push("--json".to_owned());
        let wake = self.wake.clone();
        let run = ProgramRun::start(program, &line, move || wake())?;
        let first = asked.first().map(|(_, file)| document.folder().join(file));
        self.frames = Some(FrameRun {
            run,
            progress: FrameProgress::of(asked),
            clock: Clock::start(),
            end: None,
            seconds: 0.0,
            document: document.path,
            sources,
            stale_by: None,
            first: first.unwrap_or_else(|| folder.clone()),
            folder,
        });
        Ok(())
    }

    fn start_job(&mut self, context: PanelContext<'_>, program: &Path) -> Result<(), String> {
        let document = document_of(context.session)?;
        let farm = self.farm_of(context, &document);
        let files = context.session.drawn_files();
        let line = self.choices.job(&document, view_of(context), (&farm, &files))?;
        self.make_folder(&document)?;
        let file = document.folder().join(farm.job(&document.stem()));
        let is_ours = self.written.get(&file).is_some_and(|own| is_text_of(&file, own));
        let earlier = match is_ours || std::mem::take(&mut self.replaces_job) {
            true => put_aside(&file)?,
            false => None,
        };
        let wake = self.wake.clone();
        let run = ProgramRun::start(program, &line, move || wake())?;
        self.job = Some(JobRun {
            run,
            line,
            messages: Vec::new(),
            end: None,
            document: document.path,
            file,
            farm: farm.to,
            earlier,
        });
        Ok(())
    }

    /// The farm of the settings, and the tasks of the document.
    fn farm_of(&self, context: PanelContext<'_>, document: &FilmDocument) -> FarmChoices {
        let farm = context.safety.settings.farm.as_deref();
        FarmChoices::of(farm, document.chunk.unwrap_or(self.chunk))
    }

    /// Makes the folder of the frames, which the program expects.
    fn make_folder(&self, document: &FilmDocument) -> Result<PathBuf, String> {
        let folder = self.choices.folder_of(document);
        make_folder(&folder).map_err(|problem| problem.message)?;
        Ok(folder)
    }

    /// Takes what the runs have told.
    fn update(&mut self) -> Vec<Command> {
        let mut out = Vec::new();
        if let Some(frames) = self.frames.as_mut().filter(|frames| frames.end.is_none()) {
            frames.run.lines().into_iter().for_each(|line| frames.progress.take(line));
            frames.end = frames.run.end();
            frames.seconds = frames.clock.seconds();
            if frames.end == Some(RunEnd::Failed) {
                frames.progress.fail();
            }
            out.extend(frames.end.map(|end| Command::Tell(frames.told(end))));
        }
        if let Some(job) = self.job.as_mut().filter(|job| job.end.is_none()) {
            let text = |line| match line {
                RunLine::Result(text) | RunLine::Message(text) => text,
            };
            job.messages.extend(job.run.lines().into_iter().map(text));
            job.end = job.run.end();
            if job.end.is_some() {
                job.settle_earlier();
            }
            if job.end == Some(RunEnd::Done)
                && let Ok(text) = fs::read(&job.file)
            {
                self.written.insert(job.file.clone(), text);
            }
            let file = job.file.display();
            out.extend(job.end.map(|end| match end {
                RunEnd::Done => Command::Tell(tr!("The job is {file}")),
                _ => Command::Tell(
                    tr!("The job is not written: the panel Render tells why").to_owned(),
                ),
            }));
        }
        out
    }

    fn show(&mut self, ui: &mut Ui, context: PanelContext<'_>) -> Vec<Command> {
        let mut out = Vec::new();
        let session = context.session;
        let document = match document_of(session) {
            Ok(document) => document,
            Err(reason) => {
                hint(ui, reason);
                if ui.button(tr!("Save")).clicked() {
                    out.push(Command::Save);
                }
                return out;
            }
        };
        if self.of.as_ref() != Some(&document.path) {
            let own = self.others.remove(&document.path);
            let own = own.unwrap_or_else(|| FrameChoices::of(&document, &self.choices));
            let before = std::mem::replace(&mut self.choices, own);
            self.others.extend(self.of.replace(document.path.clone()).map(|of| (of, before)));
        }
        ScrollArea::vertical().auto_shrink([false, false]).id_salt("frames").show(ui, |ui| {
            ui.set_max_width(ui.available_width() - 8.0);
            subject(ui, session, &document, &mut out);
            // What is done first stands first: choices are seldom changed.
            self.render_row(ui, context, &document, &mut out);
            if let Some(problem) = &self.problem {
                ui.label(RichText::new(problem).color(theme::of(ui).error));
            }
            // What is done for another document is shown until its end.
            let is_shown =
                |frames: &&FrameRun| frames.end.is_none() || frames.document == document.path;
            if let Some(frames) = self.frames.as_mut().filter(|frames| is_shown(&&**frames)) {
                frames.find_stale(session);
                progress::show(ui, frames, session, &mut out);
            }
            ui.add_space(4.0);
            let outputs = &mut self.outputs;
            choices::show(ui, &mut self.choices, outputs, context, &document, &mut out);
            if let Ok(line) = self.choices.render(&document, view_of(context)) {
                command_text(ui, &line, tr!("Copy the command that renders"), &mut out);
            }
            ui.separator();
            self.farm_part(ui, context, &document, &mut out);
        });
        out
    }

    /// Shows the button that renders, or the reason why nothing can be rendered.
    fn render_row(
        &self,
        ui: &mut Ui,
        context: PanelContext<'_>,
        document: &FilmDocument,
        out: &mut Vec<Command>,
    ) {
        let is_going_on = self.frames.as_ref().is_some_and(|frames| frames.end.is_none());
        let line = self.choices.render(document, view_of(context));
        let count = self.choices.list(document).map_or(0, |list| list.frames().len());
        ui.horizontal(|ui| {
            if is_going_on {
                let help =
                    tr!("Ends it; frames that are whole stay, and the next run goes on there");
                if ui.button(tr!("Stop")).on_hover_text(help).clicked() {
                    out.push(Command::Film(FilmCommand::StopFrames));
                }
                return;
            }
            let text = trn!(count, "Render {count} frame", "Render {count} frames");
            let text = RichText::new(text).strong();
            let button = ui.add_enabled(line.is_ok(), Button::new(text));
            let help =
                tr!("Beside the window, which stays free. Frames of a run before that are whole \
                     and the same are kept");
            if button.on_hover_text(help).clicked() {
                out.push(Command::Film(FilmCommand::Render));
            }
        });
        if let Err(reason) = &line {
            ui.label(RichText::new(reason).color(theme::of(ui).error));
        }
    }
}

impl FrameRun {
    /// Finds out whether the frames are of what the files were before.
    fn find_stale(&mut self, session: &Session) {
        let changed = self.sources.changed(&**session.assets.source());
        let name =
            |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        self.stale_by = changed.map(name);
    }

    /// The end in words.
    fn told(&self, end: RunEnd) -> String {
        let [whole, all] = self.progress.count();
        let folder = self.folder.display();
        match end {
            RunEnd::Done => trn!(
                whole,
                "{whole} frame is whole, in {folder}",
                "{whole} frames are whole, in {folder}"
            ),
            RunEnd::Stopped => tr!("Stopped: {whole} of {all} frames are whole, in {folder}"),
            RunEnd::Failed => match self.progress.failed().next() {
                Some((frame, _)) => tr!("Frame {frame} failed: the panel Render tells why"),
                None => tr!("Rendering failed: the panel Render tells why").to_owned(),
            },
        }
    }
}

/// True if a file holds just this text.
fn is_text_of(file: &Path, text: &[u8]) -> bool {
    fs::read(file).is_ok_and(|found| found == text)
}

/// Puts a file aside, for another one in its place; `None` where there is none.
///
/// # Errors
/// The reason why it cannot be moved, as a sentence.
fn put_aside(file: &Path) -> Result<Option<PathBuf>, String> {
    let aside = file.with_added_extension("before");
    match fs::rename(file, &aside) {
        Ok(()) => Ok(Some(aside)),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(tr!("{file} cannot be replaced: {error}", file = file.display())),
    }
}

/// The view of the window, as the settings have it.
fn view_of<'s>(context: PanelContext<'s>) -> Option<&'s crate::state::display::DisplayChoice> {
    context.safety.settings.display.as_ref()
}

/// Shows which file is rendered, and that unsaved changes are not.
fn subject(ui: &mut Ui, session: &Session, document: &FilmDocument, out: &mut Vec<Command>) {
    let colors = theme::of(ui);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(document.name()).strong())
            .on_hover_text(document.path.display().to_string());
        ui.label(RichText::new(tr!("as it is on the disk")).color(colors.dim));
    });
    if is_unsaved(session) {
        ui.horizontal_wrapped(|ui| {
            let text = tr!("What you changed is not saved, and not in the frames.");
            ui.label(RichText::new(text).color(colors.warning));
            let save = ui.small_button(tr!("Save now")).on_hover_text(tr!("Saves what is open"));
            if save.clicked() {
                out.push(Command::Save);
            }
        });
    }
    ui.add_space(2.0);
}

/// Shows a command line, with a button that copies it.
pub(crate) fn command_text(ui: &mut Ui, line: &CommandLine, label: &str, out: &mut Vec<Command>) {
    use eframe::egui::{Label, Role, WidgetInfo};
    ui.horizontal_top(|ui| {
        let copy = ui.small_button(tr!("Copy"));
        copy.widget_info(|| WidgetInfo::labeled(Role::Button, true, label));
        let help = tr!("Copies the command that does the same in a terminal");
        if copy.on_hover_text(help).clicked() {
            out.push(Command::Copy(line.text_from_anywhere()));
        }
        let text = RichText::new(line.text()).monospace().small().color(theme::of(ui).dim);
        ui.add(Label::new(text).wrap()).on_hover_text(line.text_from_anywhere());
    });
}
