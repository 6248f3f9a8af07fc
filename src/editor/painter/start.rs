//! Start page of the panel, shown while the open look shows no painting that is open.

use std::path::PathBuf;

use chiaro_locale::{tr, trn};
use eframe::egui::{Button, Response, RichText, ScrollArea, Ui};

use super::memory;
use crate::commands::{Command, GridPreset, PaintCommand};
use crate::examples::PREFIX;
use crate::frame::UNSAVED_HCBTF;
use crate::state::painting::look::sheets;
use crate::state::painting::work::OpenPainting;
use crate::state::scene::real;
use crate::state::session::Session;
use crate::widgets::theme;

/// Largest number of HCBTFs offered here; more are opened from the inspector.
const MOST_SHEETS: usize = 4;

/// Shows the ways to begin: the HCBTFs of the open look, the open painting, or a new one.
pub(super) fn show(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    ScrollArea::vertical().auto_shrink([false, false]).id_salt("begin to paint").show(ui, |ui| {
        ui.vertical_centered(|ui| {
            ui.set_max_width(ui.available_width().min(460.0));
            ui.add_space(ui.available_height() * 0.06);
            of_look(ui, session, out);
            anew(ui, out);
        });
    });
}

fn wide(ui: &mut Ui, label: &str) -> Response {
    ui.add_sized([ui.available_width().min(400.0), 30.0], Button::new(label).truncate())
}

/// HCBTF that the open look shows, and that is not open to be painted.
pub(crate) struct ShownPainting {
    /// Label of the button that opens the HCBTF.
    pub(crate) label: String,
    pub(crate) help: &'static str,
    pub(crate) path: PathBuf,
    /// Name of the HCBTF for people.
    pub(crate) name: String,
}

/// HCBTFs that the open look shows and that are not open.
pub(crate) fn shown(session: &Session) -> Vec<ShownPainting> {
    let mut names = sheets(session.look(), &session.project.catalog);
    names.retain(|name| !name.is_empty() && name != UNSAVED_HCBTF);
    names.sort();
    names.dedup();
    let open = session.painting().and_then(OpenPainting::path).map(real);
    let all = names.into_iter().map(|named| {
        let path = PathBuf::from(&named);
        if named.starts_with(PREFIX) {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let help = tr!(
                "Opens a copy of the example that this look shows; the example itself stays as it \
                 is"
            );
            return ShownPainting { label: tr!("Paint a copy of {name}"), help, path, name };
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let help = tr!("Opens what this look shows to be painted");
        ShownPainting {
            label: tr!("Paint {name}"),
            help,
            path: session.look.folder().join(named),
            name,
        }
    });
    all.filter(|shown| open.as_ref().is_none_or(|open| real(&shown.path) != *open))
        .take(MOST_SHEETS)
        .collect()
}

/// Short text for the other panels: the HCBTFs that the look shows, and where to open them.
pub(super) fn in_short(session: &Session) -> String {
    let shown = shown(session);
    let names: Vec<_> = shown.iter().map(|shown| shown.name.as_str()).collect();
    match (names.as_slice(), session.painting()) {
        ([], None) => {
            tr!("The open look shows nothing that is painted: the menu Paint begins something")
                .to_owned()
        }
        ([], Some(work)) => {
            tr!(
                "The open look shows nothing that is painted: the menu Paint goes back to {name}",
                name = work.name()
            )
        }
        (names, _) => {
            trn!(
                count = names.len(),
                "The open look shows {names}, which is not open to be painted: the menu Paint \
                 does that",
                "The open look shows {names}, which are not open to be painted: the menu Paint \
                 does that",
                names = listed(names)
            )
        }
    }
}

/// List of names, as written in a sentence.
fn listed(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [first @ .., last] => tr!("{names} and {last}", names = first.join(", ")),
    }
}

/// Shows the HCBTFs of the open look, and the open painting that the look does not show.
fn of_look(ui: &mut Ui, session: &Session, out: &mut Vec<Command>) {
    let shown = shown(session);
    let names: Vec<_> = shown.iter().map(|shown| shown.name.as_str()).collect();
    let dim = theme::of(ui).dim;
    if let Some(work) = session.painting() {
        ui.heading(match names.is_empty() {
            true => tr!("The open look shows no painting").to_owned(),
            false => tr!("The open look shows {names}", names = listed(&names)),
        });
        ui.add_space(4.0);
        let name = work.name();
        let place = work
            .home()
            .map(|home| tr!("It was painted in {look}.", look = home.name()))
            .unwrap_or_default();
        let text = match work.is_dirty() {
            true => tr!("{name} is still open, not saved yet, and this look does not show it."),
            false => tr!("{name} is still open, and this look does not show it."),
        };
        ui.label(RichText::new(format!("{text} {place}").trim_end()).color(dim));
        ui.add_space(8.0);
        let help = match work.home() {
            Some(_) => tr!("Shows it in the look that it was painted in, and goes on painting it"),
            None => tr!("Shows it in a look of its own, and goes on painting it"),
        };
        if wide(ui, &tr!("Back to {name}")).on_hover_text(help).clicked() {
            out.push(Command::Paint(PaintCommand::GoBack));
        }
        ui.add_space(4.0);
    } else if names.is_empty() {
        ui.label(RichText::new(tr!("The open look has no painting.")).color(dim));
        ui.add_space(8.0);
    } else {
        ui.heading(tr!("The open look shows {names}", names = listed(&names)));
        ui.add_space(4.0);
    }
    let is_any = !shown.is_empty() || session.painting().is_some();
    for ShownPainting { label, help, path, .. } in shown {
        if wide(ui, &label).on_hover_text(help).clicked() {
            out.push(Command::Paint(PaintCommand::Open { path, keeps_look: true }));
        }
    }
    if is_any {
        ui.add_space(12.0);
    }
}

/// Shows the buttons for a new painting, in a look of its own.
fn anew(ui: &mut Ui, out: &mut Vec<Command>) {
    ui.heading(tr!("Paint a surface"));
    ui.add_space(4.0);
    let text = tr!(
        "A painted surface is a tile that you paint as it looks under one light and from one side, \
         then under another: it shows what you painted, and rules fill in the rest. A new one has \
         a look of its own. (Papers call it an HCBTF.)"
    );
    ui.label(RichText::new(text).color(theme::of(ui).dim));
    ui.add_space(12.0);
    for preset in GridPreset::ALL {
        let grid = preset.grid();
        let label = tr!(
            "{name}: {width} x {height} texels, {lights} lights x {views} views",
            name = preset.label(),
            width = grid.size[0],
            height = grid.size[1],
            lights = grid.light.distinct_count(),
            views = grid.view.distinct_count()
        );
        let button = wide(ui, &label);
        if button.on_hover_text(format!("{}: {}", preset.help(), memory::in_short(&grid))).clicked()
        {
            out.push(Command::Paint(PaintCommand::New { grid, keeps_look: false }));
        }
    }
    let other = wide(ui, tr!("Another grid..."));
    if other
        .on_hover_text(tr!("Any number of texels, lights and views, and what they take in memory"))
        .clicked()
    {
        out.push(Command::Paint(PaintCommand::AskGrid { changes: false }));
    }
    ui.add_space(8.0);
    if wide(ui, tr!("Open an .hcbtf file...")).clicked() {
        out.push(Command::Open(None));
    }
    let help = tr!(
        "Images that were painted in other programs: a folder of them, a contact sheet, a sheet of \
         the thesis"
    );
    let import = wide(ui, tr!("Import painted pictures..."));
    if import.on_hover_text(help).clicked() {
        out.push(Command::Paint(PaintCommand::AskImport));
    }
    let help = tr!(
        "Paints every sample as the open look shows it: a dear look becomes a quick one, or one to \
         paint on"
    );
    let bake = wide(ui, tr!("Bake this look onto a tile..."));
    if bake.on_hover_text(help).clicked() {
        out.push(Command::Paint(PaintCommand::AskBake));
    }
}
