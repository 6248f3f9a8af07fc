//! Memory that an HCBTF takes: shown before its rules run, and before one of another grid is made.

use std::sync::{Arc, Weak};

use chiaro_locale::tr;
use eframe::egui::{CollapsingHeader, Grid as Table, RichText, Ui};

use crate::document::{Grid, Storage};
use crate::figures::bytes;
use crate::hcbtf::{
    Device, FilledSamples, Limits, Need, filled_at_most, layers_bytes, needs, needs_at_most,
};
use crate::state::painting::work::OpenPainting;
use crate::state::worker::Worker;
use crate::widgets::theme;

/// Measured memory: the grid, the bytes of all tiles, and the need of each storage.
pub(super) type MemoryFigures = (Grid, u64, Vec<Need>);

/// Memory taken, as far as measured, and the device's limits.
pub(super) struct Memory {
    pub(super) device: Device,
    /// Worker that measures the storages: all tiles are compared, which takes longer than a frame.
    worker: Worker<Arc<FilledSamples>, MemoryFigures>,
    asked: Weak<FilledSamples>,
    known: Option<MemoryFigures>,
}

impl Memory {
    /// `wake` is called from another thread when a measurement is done.
    pub(super) fn new(device: Device, wake: impl Fn() + Send + 'static) -> Self {
        let measure = |filled: Arc<FilledSamples>| {
            let needs = needs(&filled.grid(), |address| filled.tile(address));
            (filled.grid(), filled.bytes(), needs)
        };
        Self {
            device,
            worker: Worker::new("measuring", wake, measure),
            asked: Weak::new(),
            known: None,
        }
    }

    /// Memory that the samples take, once measured; requests the measurement where it is missing.
    pub(super) fn measured(&mut self, work: &OpenPainting) -> Option<&MemoryFigures> {
        self.known = self.worker.answers().pop().or(self.known.take());
        let filled = work.filled().filter(|_| !work.is_live());
        if let Some(filled) = filled.filter(|filled| self.asked.as_ptr() != Arc::as_ptr(filled)) {
            self.asked = Arc::downgrade(filled);
            let filled = filled.clone();
            self.worker.request(|_| filled);
        }
        self.known.as_ref().filter(|(of, ..)| of == work.grid())
    }

    /// Shows the memory that the samples take, in a collapsible section.
    pub(super) fn show(&mut self, ui: &mut Ui, work: &OpenPainting) {
        let grid = *work.grid();
        let title =
            tr!("Memory: up to {size} on the GPU", size = bytes(layers_bytes(&grid, false)));
        let section = CollapsingHeader::new(title).id_salt("memory").show(ui, |ui| {
            let known = self.measured(work).cloned();
            table(
                ui,
                &grid,
                known.as_ref().map(|(_, bytes, needs)| (*bytes, needs.as_slice())),
                &self.device,
            );
        });
        section
            .header_response
            .on_hover_text(tr!("When the rules have run: {memory}", memory = in_short(&grid)));
    }

    pub(super) fn is_busy(&self) -> bool {
        self.worker.is_busy()
    }

    pub(super) fn wait(&self) {
        self.worker.wait();
    }
}

/// Memory that a grid takes, in a few words.
pub(super) fn in_short(grid: &Grid) -> String {
    let most = needs_at_most(grid);
    let compact = most
        .iter()
        .find(|need| need.storage == Storage::Compact && !need.has_levels)
        .map_or(0, Need::bytes);
    let (raw, gpu) = (bytes(filled_at_most(grid)), bytes(layers_bytes(grid, false)));
    let compact = bytes(compact);
    tr!("{raw} filled, {gpu} on the GPU, compact at most {compact}")
}

/// Shows a table of the memory that a grid takes at most in each storage, of that taken `now` where
/// known, and of whether the device holds it.
pub(super) fn table(ui: &mut Ui, grid: &Grid, now: Option<(u64, &[Need])>, device: &Device) {
    let dim = theme::of(ui).dim;
    Table::new("storages").num_columns(4).spacing([10.0, 2.0]).show(ui, |ui| {
        let current = if now.is_some() { tr!("now") } else { "" };
        for head in ["", current, tr!("memory" => "at most"), ""] {
            ui.label(RichText::new(head).color(dim).small());
        }
        ui.end_row();
        let mut row = |name: &str, help: &str, now: Option<u64>, most: u64, fit: Fit| {
            ui.label(name).on_hover_text(help);
            ui.label(now.map(bytes).unwrap_or_default());
            ui.label(bytes(most));
            let (short, color) = match fit.is_in {
                true => (tr!("fits"), theme::of(ui).dim),
                false => (tr!("too large"), theme::of(ui).error),
            };
            ui.label(RichText::new(short).color(color)).on_hover_text(fit.help);
            ui.end_row();
        };
        let help = tr!("All samples as they are filled, four bytes a texel; equal ones count once");
        row(
            tr!("Filled samples, raw"),
            help,
            now.map(|(bytes, _)| bytes),
            filled_at_most(grid),
            Fit { is_in: true, help: tr!("held in main memory") },
        );
        for (index, most) in needs_at_most(grid).iter().enumerate() {
            let need = now.and_then(|(_, needs)| needs.get(index));
            let (name, help) = told(most);
            row(
                name,
                help,
                need.map(|need| need.bytes_on(device.limits)),
                most.bytes_on(device.limits),
                Fit::of(need.unwrap_or(most), device),
            );
        }
    });
    for storage in Storage::ALL {
        let text = format!("{}: {}", storage.label(), storage.about());
        ui.label(RichText::new(text).color(dim).small());
    }
    let painted = bytes(layers_bytes(grid, false));
    let text =
        tr!("While it is painted it is quick, with a layer for each view: {painted} on the GPU");
    ui.label(RichText::new(text).color(dim).small());
    let Limits { side, layers, has_blocks } = device.limits;
    let gpu = &device.name;
    let text = if has_blocks {
        tr!("{gpu}: textures of up to {side} texels a side and {layers} layers")
    } else {
        tr!("{gpu}: textures of up to {side} texels a side and {layers} layers; blocks are \
             decoded, to four times as much")
    };
    ui.label(RichText::new(text).color(dim).small());
}

/// Fit of a storage into the device.
struct Fit {
    is_in: bool,
    help: &'static str,
}

impl Fit {
    fn of(need: &Need, device: &Device) -> Self {
        let help = match (need.fits(device.limits), need.fits(Limits::GUARANTEED)) {
            (true, true) => tr!("fits every GPU"),
            (true, false) => tr!("fits this one, not every GPU"),
            (false, _) => tr!("does not fit"),
        };
        Self { is_in: need.fits(device.limits), help }
    }
}

fn told(need: &Need) -> (&'static str, &'static str) {
    match (need.storage, need.has_levels) {
        (Storage::Quick, false) => {
            (tr!("Quick"), tr!("As crisp lookups read it; equal views share a layer"))
        }
        (Storage::Quick, true) => (
            tr!("Quick with levels"),
            tr!("The same with smaller levels of the tile, as smooth lookups read it"),
        ),
        (Storage::Blocks, false) => (
            tr!("Blocks"),
            tr!("Every tile that differs once, compressed to a byte a texel; colors are off by a \
                 little"),
        ),
        (Storage::Blocks, true) => (
            tr!("Blocks with levels"),
            tr!("The same with smaller levels of the tile, for smooth lookups"),
        ),
        (Storage::Compact, false) => {
            (tr!("Compact"), tr!("Every tile that differs once, with palettes, for crisp lookups"))
        }
        (Storage::Compact, true) => (
            tr!("Compact with levels"),
            tr!("The same with smaller levels of the tile, for smooth lookups"),
        ),
    }
}
