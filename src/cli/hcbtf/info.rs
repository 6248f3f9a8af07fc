//! `chiaro hcbtf info`: the content of a file.

use std::path::PathBuf;

use serde_json::{Value as Json, json};

use super::{filled, open};
use crate::diag::Diagnostic;
use crate::document::{Hcbtf, Storage};
use crate::figures::{bytes, count};
use crate::output::Output;
use chiaro_scene::hcbtf::{Device, FilledSamples, Limits, Provenance, needs, needs_at_most, sheet};

/// Arguments of `chiaro hcbtf info`.
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Arguments {
    /// An .hcbtf file
    file: PathBuf,
    /// Answer as JSON, with the origin of every sample
    #[arg(long)]
    json: bool,
}

/// Help with the meaning of the storages' names.
fn help() -> String {
    let storages =
        Storage::ALL.map(|storage| format!("  {:<9}{}\n", storage.word(), storage.about()));
    format!("How the texture that shaders look up may be stored:\n{}", storages.concat())
}

pub(super) async fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let hcbtf = open(&arguments.file, output)?;
    let filled = filled(&hcbtf, &arguments.file, output)?;
    if arguments.json {
        output.json(&as_json(&hcbtf, &filled).await);
    } else {
        output.result(as_text(&hcbtf, &filled).await.trim_end());
    }
    Ok(())
}

/// Device that textures are prepared for: the adapter that Chiaro would draw with, else the limits
/// that WebGPU guarantees.
async fn present() -> Device {
    #[cfg(feature = "gpu")]
    if let Ok(gpu) = chiaro_render::Gpu::headless().await {
        return gpu.holds();
    }
    Device::guaranteed()
}

/// Numbers of samples that are painted, that are empty, and that each rule fills or changes.
struct Counts {
    painted: usize,
    empty: usize,
    by_rule: Vec<usize>,
}

impl Counts {
    fn of(hcbtf: &Hcbtf, filled: &FilledSamples) -> Self {
        let mut counts = Self { painted: 0, empty: 0, by_rule: vec![0; hcbtf.rules.len()] };
        for (_, _, provenance) in filled.iter() {
            match provenance {
                Provenance::Painted => counts.painted += 1,
                Provenance::Empty => counts.empty += 1,
                Provenance::Filled { by, changed_by } => {
                    std::iter::once(by)
                        .chain(changed_by)
                        .for_each(|rule| counts.by_rule[*rule] += 1);
                }
            }
        }
        counts
    }
}

async fn as_text(hcbtf: &Hcbtf, filled: &FilledSamples) -> String {
    let grid = hcbtf.grid;
    let Counts { painted, empty, by_rule } = Counts::of(hcbtf, filled);
    let [width, height] = sheet::size(&grid);
    let mut text = format!(
        "grid     {} x {} texels, {} x {} lights, {} x {} views: {} samples\n\
         tiling   {}\n\
         painted  {painted}\n",
        grid.size[0],
        grid.size[1],
        grid.light.theta,
        grid.light.phi,
        grid.view.theta,
        grid.view.phi,
        grid.sample_count(),
        if hcbtf.is_tiling { "yes" } else { "no" },
    );
    for (index, (rule, count)) in hcbtf.rules.iter().zip(by_rule).enumerate() {
        let verb = if rule.fills() { "fills" } else { "changes" };
        text += &format!("rule {index:<3} {} {verb} {count}\n", rule.word());
    }
    text += &format!(
        "empty    {empty}\n\
         memory   {}, {}\n\
         sheet    {width} x {height}, {}\n",
        count(filled.tiles().len() as u64, "different tile"),
        bytes(filled.bytes()),
        bytes(u64::from(width) * u64::from(height) * 4),
    );
    let device = present().await;
    let most = needs_at_most(&grid);
    for (need, most) in needs(&grid, |address| filled.tile(address)).iter().zip(&most) {
        let [wide, high, layers] = need.size;
        text += &format!(
            "{:<8} {wide} x {high} in {}, {} of at most {}{}: {}\n",
            need.storage.word(),
            count(layers, "layer"),
            bytes(need.bytes()),
            bytes(most.bytes()),
            if need.has_levels { ", with smaller levels" } else { "" },
            device.word(need),
        );
    }
    let Limits { side, layers, has_blocks } = device.limits;
    let blocks = if has_blocks {
        "compressed blocks"
    } else {
        "no compressed blocks: they are decoded, to four times as much"
    };
    text + &format!("device   {}: {side} texels a side, {layers} layers, {blocks}\n", device.name)
}

async fn as_json(hcbtf: &Hcbtf, filled: &FilledSamples) -> Json {
    let Counts { painted, empty, by_rule } = Counts::of(hcbtf, filled);
    let rules = hcbtf
        .rules
        .iter()
        .zip(by_rule)
        .map(|(rule, samples)| json!({ "rule": rule, "samples": samples }));
    let samples = filled.iter().map(|(address, _, provenance)| {
        let (light, view) = (address.light, address.view);
        let tile = filled.tile_index(address);
        match provenance {
            Provenance::Painted => json!({
                "light": light, "view": view, "from": "painted", "tile": tile
            }),
            Provenance::Empty => json!({
                "light": light, "view": view, "from": "empty", "tile": tile
            }),
            Provenance::Filled { by, changed_by } => {
                json!({
                    "light": light, "view": view, "from": "rule", "rule": by,
                    "changed_by": changed_by, "tile": tile
                })
            }
        }
    });
    let device = present().await;
    let stored = needs(&hcbtf.grid, |address| filled.tile(address))
        .into_iter()
        .zip(needs_at_most(&hcbtf.grid));
    let stored = stored.map(|(need, most)| {
        json!({
            "storage": need.storage.word(),
            "smaller_levels": need.has_levels,
            "size": need.size,
            "bytes": need.bytes(),
            "bytes_here": need.bytes_on(device.limits),
            "at_most": most.bytes(),
            "fits": need.fits(device.limits),
            "fits_every_gpu": need.fits(Limits::GUARANTEED),
        })
    });
    json!({
        "device": {
            "name": device.name, "side": device.limits.side, "layers": device.limits.layers,
            "blocks": device.limits.has_blocks
        },
        "textures": stored.collect::<Vec<_>>(),
        "grid": hcbtf.grid,
        "tiling": hcbtf.is_tiling,
        "painted": painted,
        "empty": empty,
        "rules": rules.collect::<Vec<_>>(),
        "tiles": filled.tiles().len(),
        "bytes": filled.bytes(),
        "sheet": sheet::size(&hcbtf.grid),
        "samples": samples.collect::<Vec<_>>(),
    })
}
