//! Cards of the programs that a look can be exported to: what each needs of this look, what it
//! would refuse and what the folder would weigh, tried out in the background; a click exports.

use std::sync::Arc;

use chiaro_locale::{text, tr, trn};
use eframe::egui;
use eframe::egui::{Align, Button, ComboBox, Layout, RichText, ScrollArea, Ui, vec2};

use super::table::{PanelPlace, PanelRow, Presence};
use crate::commands::{Command, PanelId};
use crate::diag::Diagnostic;
use crate::document::{ColorSpace, Storage};
use crate::export::package::{LookNeeds, PACKAGES, Package, PackageScene, export_package};
use crate::export::{self, ExportOptions};
use crate::fields::passes::{self, OutputPass};
use crate::frame::Assets;
use crate::library::{Library, PassId};
use crate::state::session::Session;
use crate::state::snapshot::{RenderSnapshot, Stamp};
use crate::state::worker::{BackgroundJobs, Worker};
use crate::widgets::text::hint;
use crate::widgets::theme;

pub(super) const PANEL: PanelRow = PanelRow::new(
    PanelId::EXPORT,
    text!("Export"),
    text!("The look for other programs and for pages: what each needs, refuses and weighs"),
    PanelPlace::BELOW_GRAPH,
    |bench, ui, context| bench.export.show(ui, context.session),
)
.with_each_frame(|bench, _, session, presence| {
    bench.export.update(session, presence);
    Vec::new()
})
.with_jobs(|bench| &bench.export);

/// Least width of a card, in points.
const CARD: f32 = 250.0;
/// Height of a card, in points.
const HEIGHT: f32 = 138.0;
/// Gap between cards, in points.
const GAP: f32 = 10.0;

/// A look to be tried.
struct TrialRequest {
    snapshot: RenderSnapshot,
    asked: TrialSubject,
}

/// Subject of a trial: a look as it was, and choices of the export.
#[derive(Clone, PartialEq)]
struct TrialSubject {
    stamp: Stamp,
    options: ExportOptions,
}

/// Answers of the packages to a look.
struct Trial {
    asked: TrialSubject,
    needs: Result<LookNeeds, Vec<Diagnostic>>,
    /// By package, in the order of [`PACKAGES`].
    packages: Vec<PackageTrial>,
    /// Nodes that are exported in another tier and values without room, in words.
    changed: Vec<String>,
}

/// Answer of a package to a look.
enum PackageTrial {
    /// Number of files, and their bytes.
    Takes { files: usize, bytes: usize },
    /// The reason, and what helps.
    Refuses(String, Vec<String>),
}

/// The panel, and the last trial.
pub(crate) struct ExportCards {
    worker: Worker<TrialRequest, Trial>,
    done: Option<Trial>,
    asked: Option<TrialSubject>,
    options: ExportOptions,
}

impl BackgroundJobs for ExportCards {
    fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    fn wait(&self) {
        self.worker.wait();
    }
}

impl ExportCards {
    /// `wake` is called from another thread when a trial is done.
    pub(crate) fn new(wake: impl Fn() + Send + 'static) -> Self {
        let worker = Worker::new("try exports", wake, |request: TrialRequest| run(request));
        let options = ExportOptions { takes_carried_tiers: true, ..ExportOptions::default() };
        Self { worker, done: None, asked: None, options }
    }

    /// Choices of the export, as the panel shows them.
    pub(crate) fn options(&self) -> ExportOptions {
        self.options
    }

    /// Subject of a trial of the look as it is now. A turn of the view or a later moment changes
    /// nothing of an export.
    fn current(&self, session: &Session) -> TrialSubject {
        TrialSubject { stamp: session.stamp().without_view(), options: self.options }
    }

    /// Takes a finished trial, and asks for one of the look as it is while the panel is seen.
    fn update(&mut self, session: &Session, presence: Presence) {
        if let Some(done) = self.worker.answers().pop() {
            self.done = Some(done);
        }
        let asked = self.current(session);
        if presence != Presence::Seen || self.asked.as_ref() == Some(&asked) {
            return;
        }
        self.asked = Some(asked.clone());
        let snapshot = session.snapshot_of(Arc::new(session.look().clone())).alone();
        self.worker.request(|_| TrialRequest { snapshot, asked });
    }

    fn show(&mut self, ui: &mut Ui, session: &Session) -> Vec<Command> {
        let mut commands = Vec::new();
        let is_current = self.done.as_ref().is_some_and(|done| done.asked == self.current(session));
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            self.head(ui, is_current);
            self.choices(ui);
            let width = ui.available_width();
            let columns = ((width + GAP) / (CARD + GAP)).floor().max(1.0);
            let card = vec2(((width + GAP) / columns - GAP).floor(), HEIGHT);
            ui.spacing_mut().item_spacing = vec2(GAP, GAP);
            ui.horizontal_wrapped(|ui| {
                for (index, package) in PACKAGES.iter().copied().enumerate() {
                    let trial = self.done.as_ref().and_then(|done| done.packages.get(index));
                    ui.allocate_ui_with_layout(card, Layout::top_down(Align::Min), |ui| {
                        show_card(ui, card, package, trial, &mut commands);
                    });
                }
            });
            ui.add_space(4.0);
            languages(ui, session.look().color_space, &mut commands);
            ui.add_space(4.0);
            named_passes(ui, session, &mut commands);
        });
        commands
    }

    /// Needs of the look, in a line or two.
    fn head(&self, ui: &mut Ui, is_current: bool) {
        let Some(done) = &self.done else {
            hint(ui, tr!("Trying what the look needs ..."));
            return;
        };
        let needs = match &done.needs {
            Ok(needs) => told(needs),
            Err(problems) => problems.first().map_or_else(String::new, |it| it.message.clone()),
        };
        let ink = if is_current { theme::of(ui).text } else { theme::of(ui).dim };
        ui.label(RichText::new(needs).color(ink));
        for changed in &done.changed {
            ui.label(RichText::new(changed).color(theme::of(ui).warning).size(theme::SMALL_TEXT));
        }
    }

    /// Choices of the export.
    fn choices(&mut self, ui: &mut Ui) {
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut self.options.is_live, tr!("Every value")).on_hover_text(tr!(
                "Every value can be set where the look arrives, not only those that you exposed: \
                 each with its range, default and help. The shader is slower. For a look that is \
                 still being tuned; without it for what is delivered"
            ));
            let needs = self.done.as_ref().and_then(|done| done.needs.as_ref().ok());
            if needs.is_none_or(|needs| needs.painted_surfaces == 0) {
                return;
            }
            ui.add_space(GAP);
            let label = ui.label(tr!("Painted surfaces"));
            let name = |storage: Option<Storage>| storage.map_or(tr!("as it fits"), Storage::label);
            let combo = ComboBox::from_id_salt("storage")
                .selected_text(name(self.options.storage))
                .show_ui(ui, |ui| {
                    let all = std::iter::once(None).chain(Storage::ALL.map(Some));
                    for storage in all {
                        let about = match storage {
                            Some(storage) => {
                                format!("{}\n--textures {}", storage.about(), storage.word())
                            }
                            None => tr!("packages have them compact where a node says quick; \
                                     languages as the nodes say")
                            .to_owned(),
                        };
                        ui.selectable_value(&mut self.options.storage, storage, name(storage))
                            .on_hover_text(about);
                    }
                });
            combo.response.labelled_by(label.id);
        });
    }
}

/// The needs of a look as a sentence.
fn told(needs: &LookNeeds) -> String {
    let LookNeeds { lights, parameters, keys, images, painted_surfaces: surfaces, passes, .. } =
        needs;
    let some = |count: usize, text: String| (count > 0).then_some(text);
    let title = |name: &&'static str| PassId::from_slug(name).map_or(*name, PassId::title);
    let passes: Vec<&str> = passes.iter().map(title).collect();
    let parts = [
        some(*lights, trn!(*lights, "{lights} light", "{lights} lights")),
        some(
            *parameters,
            trn!(*parameters, "{parameters} exposed value", "{parameters} exposed values"),
        ),
        some(*keys, trn!(*keys, "{keys} set of keys", "{keys} sets of keys")),
        some(*images, trn!(*images, "{images} image", "{images} images")),
        some(
            *surfaces,
            trn!(*surfaces, "{surfaces} painted surface", "{surfaces} painted surfaces"),
        ),
        some(passes.len(), tr!("passes before it: {passes}", passes = passes.join(", "))),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    if parts.is_empty() {
        return tr!("This look needs a mesh and nothing else").to_owned();
    }
    tr!("This look has {parts}", parts = parts.join(" · "))
}

fn show_card(
    ui: &mut Ui,
    size: egui::Vec2,
    package: &Package,
    trial: Option<&PackageTrial>,
    commands: &mut Vec<Command>,
) {
    let colors = theme::of(ui);
    let frame = egui::Frame::new().fill(colors.node).corner_radius(6.0).inner_margin(12.0);
    frame.show(ui, |ui| {
        ui.set_min_size(size - vec2(24.0, 24.0));
        ui.set_max_size(size - vec2(24.0, 24.0));
        ui.spacing_mut().item_spacing.y = 6.0;
        let run_with = match package.run_with {
            Some(program) => tr!("Run with {program}"),
            None => tr!("The program itself was not run").to_owned(),
        };
        ui.label(RichText::new(package.label.tr()).strong().size(15.0)).on_hover_text(run_with);
        ui.label(RichText::new(package.help.tr()).color(colors.dim).size(theme::SMALL_TEXT + 1.0));
        let is_taken = match trial {
            None => {
                ui.label(RichText::new(tr!("Trying ...")).color(colors.dim));
                true
            }
            Some(PackageTrial::Takes { files, bytes }) => {
                let weight = weight(*bytes);
                ui.label(trn!(*files, "{files} file · {weight}", "{files} files · {weight}"));
                true
            }
            Some(PackageTrial::Refuses(reason, hints)) => {
                let text = RichText::new(tr!("Not this look: {reason}")).color(colors.warning);
                let label = egui::Label::new(text).truncate();
                ui.add(label).on_hover_text(format!("{reason}\n{}", hints.join("\n")));
                if let Some(hint) = hints.first() {
                    let text = RichText::new(hint).color(colors.dim).size(theme::SMALL_TEXT + 1.0);
                    ui.add(egui::Label::new(text).truncate()).on_hover_text(hint);
                }
                false
            }
        };
        ui.with_layout(Layout::bottom_up(Align::Min), |ui| {
            let text = match package.opens {
                Some(_) => tr!("Export and open..."),
                None => tr!("Export..."),
            };
            let button = ui.add_enabled(is_taken, Button::new(text));
            button.widget_info(|| {
                let name = tr!("Export for {program}", program = package.label);
                egui::WidgetInfo::labeled(egui::Role::Button, is_taken, name)
            });
            let help =
                tr!("Writes a folder that runs where it arrives: --to {slug}", slug = package.slug);
            if button.on_hover_text(help).clicked() {
                commands.push(Command::ExportLook(package.slug, None));
            }
        });
    });
}

/// Sentence on what a program does with the colors of a look.
fn encoding(space: ColorSpace) -> &'static str {
    match space {
        ColorSpace::Display => {
            tr!("The colors are as shown (sRGB), and layers blend as such: write them into a \
                 target that does not encode, with no tone mapping after it. The folders above do \
                 so")
        }
        ColorSpace::Linear => {
            tr!("The colors are linear light: write them into a target that encodes them or holds \
                 light, with no tone mapping after it. The folders above do so")
        }
    }
}

/// Buttons for the languages alone, of a look whose colors are of this space.
fn languages(ui: &mut Ui, space: ColorSpace, commands: &mut Vec<Command>) {
    let text = tr!("Or the shaders alone, with LOOK.json, for programs of your own:");
    ui.label(RichText::new(text).color(theme::of(ui).dim));
    let small = RichText::new(encoding(space)).color(theme::of(ui).dim).size(theme::SMALL_TEXT);
    ui.label(small);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(6.0, 6.0);
        for language in export::LANGUAGES {
            let button = ui.add(Button::new(language.short_label).small());
            let help =
                tr!("Writes the look as {language} into a folder", language = language.label);
            if button.on_hover_text(help).clicked() {
                commands.push(Command::ExportLook(language.slug, None));
            }
        }
    });
}

/// Outputs that the look names as passes, with the command that writes them.
fn named_passes(ui: &mut Ui, session: &Session, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing = vec2(6.0, 4.0);
    let aovs = &session.look().aovs;
    if aovs.is_empty() {
        let text =
            tr!("No output of this look is named as a pass (AOV) for film. A right click on an \
                 output of the graph names it");
        return hint(ui, text);
    }
    ui.label(RichText::new(tr!("Passes (AOVs) that the look names")).strong()).on_hover_text(tr!(
        "Each is a layer of an EXR, and costs nothing in pictures that nobody asks for it"
    ));
    for aov in aovs {
        ui.horizontal(|ui| {
            let title = passes::title_of(session, &aov.from);
            let show = ui.link(aov.name.as_str()).on_hover_text(tr!("Shows the node"));
            if show.clicked() {
                commands.push(Command::Show(aov.from.node.clone()));
            }
            ui.label(RichText::new(tr!("from {title}")).color(theme::of(ui).dim));
            let remove = ui.small_button("×").on_hover_text(tr!("Takes the name away"));
            remove.widget_info(|| {
                let name = tr!("Remove the pass {name}", name = aov.name);
                egui::WidgetInfo::labeled(egui::Role::Button, true, name)
            });
            if remove.clicked() {
                let edit = OutputPass::of(session, &aov.from).named("");
                commands.extend(edit.ok().flatten().map(Command::Edit));
            }
        });
    }
    ui.horizontal_wrapped(|ui| {
        let document = session.path().and_then(|path| path.file_name());
        let document = document.map_or("LOOK.json".into(), |name| name.to_string_lossy());
        let command = format!("chiaro render {document} -o picture.exr --aov named");
        ui.label(RichText::new(&command).monospace().color(theme::of(ui).dim));
        let help =
            tr!("Copies the command that writes them beside the picture; --aov NAME asks for one");
        if ui.small_button(tr!("Copy")).on_hover_text(help).clicked() {
            commands.push(Command::Copy(command));
        }
    });
}

/// Bytes in words.
fn weight(bytes: usize) -> String {
    match bytes {
        0..1_000 => trn!(bytes, "{bytes} byte", "{bytes} bytes"),
        1_000..1_000_000 => format!("{} kB", bytes / 1_000),
        _ => format!("{:.1} MB", bytes as f64 / 1e6),
    }
}

fn run(request: TrialRequest) -> Trial {
    let TrialRequest { snapshot, asked } = request;
    let (mut look, mut library) = ((*snapshot.look).clone(), (*snapshot.library).clone());
    let mut assets = Assets::default();
    let prepared = asked.options.apply(&mut look, &mut library, true);
    let prepared = prepared.and_then(|changed| Ok((changed, snapshot.setup(&mut assets)?.value)));
    let (changed, mut setup) = match prepared {
        Ok(prepared) => prepared,
        Err(problems) => {
            let packages = PACKAGES.iter().map(|_| refusal(&problems)).collect();
            return Trial { asked, needs: Err(problems), packages, changed: Vec::new() };
        }
    };
    let changed = changed.iter().map(|problem| problem.message.clone()).collect();
    let needs = LookNeeds::of(&look, &library);
    setup.looks[0].look = look;
    let mut taken = |package: &Package| try_package(package, &setup, &library, &mut assets);
    let packages = PACKAGES.iter().map(|package| taken(package)).collect();
    Trial { asked, needs, packages, changed }
}

fn try_package(
    package: &Package,
    setup: &crate::frame::Setup,
    library: &Library,
    assets: &mut Assets,
) -> PackageTrial {
    let Some(scene) = PackageScene::of(setup) else {
        return PackageTrial::Refuses(tr!("there is no mesh to show it on").to_owned(), Vec::new());
    };
    let worn = &setup.looks[0];
    let place = (worn.folder.as_path(), assets);
    match export_package(&worn.look, library, "look", package, &scene, place) {
        Ok(exported) => PackageTrial::Takes {
            files: exported.value.len(),
            bytes: exported.value.iter().map(|file| file.bytes.len()).sum(),
        },
        Err(problems) => refusal(&problems),
    }
}

fn refusal(problems: &[Diagnostic]) -> PackageTrial {
    let first = problems.iter().find(|problem| problem.is_error()).or(problems.first());
    match first {
        Some(problem) => PackageTrial::Refuses(problem.message.clone(), problem.hints.clone()),
        None => PackageTrial::Refuses(tr!("it cannot be exported").to_owned(), Vec::new()),
    }
}
