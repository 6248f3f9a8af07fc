//! `chiaro hcbtf info`: what a file holds.

use std::path::PathBuf;

use serde_json::{Value as Json, json};

use super::{filled, open};
use crate::cli::output::Output;
use crate::diag::Diagnostic;
use crate::document::Hcbtf;
use crate::hcbtf::{Filled, Provenance, layers_bytes, layers_size, sheet};

/// What `chiaro hcbtf info` is given.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// An .hcbtf file
    file: PathBuf,
    /// As JSON, with where every sample comes from
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments, output: &Output) -> Result<(), Vec<Diagnostic>> {
    let hcbtf = open(&arguments.file, output)?;
    let filled = filled(&hcbtf, &arguments.file)?;
    if arguments.json {
        output.json(&as_json(&hcbtf, &filled));
    } else {
        output.result(as_text(&hcbtf, &filled).trim_end());
    }
    Ok(())
}

/// The texels along a side, and the layers, that every WebGPU device takes.
const GUARANTEED_SIDE: u64 = 8192;
const GUARANTEED_LAYERS: u64 = 256;

/// How many samples are painted and empty, and how many each rule fills or changes.
struct Counts {
    painted: usize,
    empty: usize,
    by_rule: Vec<usize>,
}

impl Counts {
    fn of(hcbtf: &Hcbtf, filled: &Filled) -> Self {
        let mut counts = Self { painted: 0, empty: 0, by_rule: vec![0; hcbtf.rules.len()] };
        for (_, _, provenance) in filled.iter() {
            match provenance {
                Provenance::Painted => counts.painted += 1,
                Provenance::Empty => counts.empty += 1,
                Provenance::Filled { by, changed_by } => {
                    std::iter::once(by).chain(changed_by).for_each(|rule| counts.by_rule[*rule] += 1);
                }
            }
        }
        counts
    }
}

fn as_text(hcbtf: &Hcbtf, filled: &Filled) -> String {
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
    let mib = |bytes: u64| bytes as f64 / f64::from(1 << 20);
    let own = mib(filled.bytes());
    let as_sheet = mib(u64::from(width) * u64::from(height) * 4);
    let [wide, high, layers] = layers_size(&grid, false);
    let [texture, with_levels] = [false, true].map(|has_levels| mib(layers_bytes(&grid, has_levels)));
    let [most_wide, most_high, most_layers] = layers_size(&grid, true);
    let fits = match most_wide.max(most_high) <= GUARANTEED_SIDE && most_layers <= GUARANTEED_LAYERS {
        true => "every GPU that WebGPU runs on".to_owned(),
        false => {
            format!("GPUs that take more than WebGPU guarantees ({GUARANTEED_SIDE} texels, {GUARANTEED_LAYERS} layers)")
        }
    };
    text + &format!(
        "empty    {empty}\n\
         memory   {} different tiles, {own:.2} MiB\n\
         sheet    {width} x {height}, {as_sheet:.2} MiB\n\
         texture  {wide} x {high} in {layers} layers, {texture:.2} MiB; with smaller levels {with_levels:.2} MiB\n\
         fits     {fits}\n",
        filled.tiles().len(),
    )
}

fn as_json(hcbtf: &Hcbtf, filled: &Filled) -> Json {
    let Counts { painted, empty, by_rule } = Counts::of(hcbtf, filled);
    let rules = hcbtf.rules.iter().zip(by_rule).map(|(rule, samples)| json!({ "rule": rule, "samples": samples }));
    let samples = filled.iter().map(|(address, _, provenance)| {
        let (light, view) = (address.light, address.view);
        let tile = filled.tile_index(address);
        match provenance {
            Provenance::Painted => json!({ "light": light, "view": view, "from": "painted", "tile": tile }),
            Provenance::Empty => json!({ "light": light, "view": view, "from": "empty", "tile": tile }),
            Provenance::Filled { by, changed_by } => {
                json!({ "light": light, "view": view, "from": "rule", "rule": by, "changed_by": changed_by, "tile": tile })
            }
        }
    });
    json!({
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
