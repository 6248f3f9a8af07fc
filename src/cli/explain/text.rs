//! Report in words, for a terminal.

use std::fmt::Write as _;

use super::super::tier;
use super::report::{DecidingDriver, ExplainReport, LookReport, LoopReport, names};
use crate::compile::TierReason;
use crate::frame::{Effect, EffectCost, EffectKind, EffectState, TierCosts, TierOperations};
use crate::ids::LightId;
use crate::library::Rate;

pub(super) fn tell(report: &ExplainReport, document: &str) -> String {
    let [width, height] = report.size;
    let mut text = format!("{document}, {width}x{height} pixels\n");
    if !report.changes.is_empty() {
        let _ = writeln!(text, "\nChanged by shots\n{}", report.changes_told);
    }
    text += "\nPasses, in order\n";
    for pass in report.effects.iter().filter(|effect| effect.pass.is_some()) {
        let _ =
            writeln!(text, "  {:18} {}\n  {:18} costs {}", pass.what, pass.reason, "", pass.cost);
    }
    for casters in report.effects.iter().filter(|effect| effect.kind == EffectKind::Casters) {
        let Effect { what, reason, cost, .. } = casters;
        let _ = writeln!(text, "\nShadows\n  {what:18} {reason}\n  {:18} costs {cost}", "");
    }
    if !report.dropped.is_empty() {
        text += "\nLeft out\n";
        for dropped in &report.dropped {
            let of = dropped
                .look
                .as_ref()
                .filter(|name| !name.is_empty() && dropped.kind != EffectKind::Look);
            let of = of.map_or_else(String::new, |name| format!(" of \"{name}\""));
            let saved = if dropped.cost == EffectCost::default() {
                String::new()
            } else {
                format!("; saves {}", dropped.cost)
            };
            let _ = writeln!(
                text,
                "  {}{of}: {} ({}{saved})",
                dropped.what,
                dropped.why,
                dropped.proof.label()
            );
        }
    }
    for look in &report.looks {
        text += &tell_look(look, report);
    }
    if report.looks.is_empty() {
        text += "\nNo visible object wears a look.";
    }
    text.trim_end().to_owned()
}

fn tell_look(look: &LookReport, report: &ExplainReport) -> String {
    let name = if look.name.is_empty() {
        "A look".to_owned()
    } else {
        format!("The look \"{}\"", look.name)
    };
    let objects: Vec<String> = look.objects.iter().cloned().collect();
    let mut text = format!("\n{name}, worn by {}\n", names(&objects));
    text += "\n  WGSL modules\n";
    for module in &look.modules {
        let uniform = match module.uniform_bytes {
            0 => "no uniform of its own".to_owned(),
            bytes => format!("{bytes} bytes of uniforms of its own"),
        };
        let _ = writeln!(text, "    {:16} {} lines, {uniform}", module.name, module.lines);
    }
    let _ = writeln!(
        text,
        "    each also reads {} bytes of the view and {} of the object",
        report.view_bytes, report.object_bytes
    );
    text += "\n  Vertex attributes\n";
    for attribute in &look.attributes {
        let _ = writeln!(text, "    {:8} {}  {}", attribute.name, attribute.ty, attribute.why);
    }
    if !look.attributes_not_read.is_empty() {
        let _ = writeln!(text, "    not read: {}", look.attributes_not_read.join(", "));
    }
    if !look.surroundings.is_empty() {
        text += "\n  Surroundings that fragments read\n";
        for reading in &look.surroundings {
            let _ = writeln!(
                text,
                "    {:16} {} ({})",
                reading.word,
                names(&reading.readers),
                reading.what
            );
        }
    }
    text += "\n  Textures\n";
    if look.images.is_empty() {
        text += "    none: no node that reaches the output reads an image or a painted surface\n";
    }
    for image in &look.images {
        let path = if image.path.is_empty() { "(nothing chosen: white)" } else { &image.path };
        let _ = writeln!(text, "    {path}  for `{}`", image.node);
    }
    text + &tell_uniforms(look) + &tell_keys(look) + &tell_nodes(look, report) + &tell_tiers(look)
}

/// Tiers of the nodes, with what the others would cost: those that differ, the dearest first.
fn tell_tiers(look: &LookReport) -> String {
    if look.tiers.is_empty() {
        return String::new();
    }
    let mut text = "\n  Tiers, with operations at each fragment\n".to_owned();
    if look.tiers.iter().any(|node| node.reason != TierReason::Named) {
        let _ = writeln!(text, "    {}", tier::bound_text(look.max_error));
    }
    let (same, mut others): (Vec<&TierCosts>, Vec<&TierCosts>) =
        look.tiers.iter().partition(|node| node.operations.are_same());
    others.sort_by_key(|node| std::cmp::Reverse(node.operations.of(node.tier)));
    let width = others.iter().map(|node| node.node.len()).max().unwrap_or_default().clamp(4, 40);
    if !others.is_empty() {
        let _ = writeln!(
            text,
            "    {:width$}  {:8}  {:>5}  {:>5}  {:>8}  {:>5}",
            "node", "tier", "now", "exact", "balanced", "fast"
        );
    }
    for node in others {
        let TierOperations { exact, balanced, fast } = node.operations;
        let why = match (node.reason, node.balanced_error) {
            (TierReason::Named, _) => "  named".to_owned(),
            (TierReason::Stated, Some(error)) => {
                format!("  balanced is said to differ by {error}")
            }
            (TierReason::Grows, _) => {
                "  what balanced differs by would grow on its way to the picture".to_owned()
            }
            _ => String::new(),
        };
        let _ = writeln!(
            text,
            "    {:width$}  {:8}  {:>5}  {exact:>5}  {balanced:>8}  {fast:>5}{why}",
            node.node,
            tier::word(node.tier),
            node.operations.of(node.tier)
        );
    }
    if !same.is_empty() {
        let _ = writeln!(text, "    {} cost the same in every tier", nodes_text(same.len()));
    }
    let sum = |of: &dyn Fn(&TierCosts) -> u64| look.tiers.iter().map(of).sum::<u64>();
    let now = sum(&|node| node.operations.of(node.tier));
    let exact = sum(&|node| node.operations.exact);
    let _ = writeln!(text, "    {now} operations in all; exact everywhere is {exact}");
    text
}

fn nodes_text(count: usize) -> String {
    format!("{count} {}", if count == 1 { "node" } else { "nodes" })
}

fn tell_uniforms(look: &LookReport) -> String {
    let mut text = "\n  Uniforms, computed by the host in 64 bits\n".to_owned();
    if look.uniforms.is_empty() {
        text += "    none: everything is known when the look is compiled, or at each fragment\n";
    }
    for uniform in &look.uniforms {
        let rate = match uniform.rate {
            Rate::Constant => "once",
            Rate::Frame => "each frame",
            _ => "each object and frame",
        };
        let from = names(&uniform.from);
        let _ = writeln!(
            text,
            "    {}: {}, byte {}, {rate}, from {from}",
            uniform.name, uniform.ty, uniform.offset
        );
    }
    text
}

/// Drivers of direction keys, and the weight of each key; for the first objects, if there are many.
fn tell_keys(look: &LookReport) -> String {
    const MOST: usize = 16;
    if look.keys.is_empty() {
        return String::new();
    }
    let mut text = "\n  Keys, with what decides now\n".to_owned();
    for keys in look.keys.iter().take(MOST) {
        let number = |x: &f64| format!("{x:.4}");
        let now = |by: &DecidingDriver| match by.now.as_slice() {
            [one] => format!(
                "{} is {}{}{}",
                by.what,
                number(one),
                if by.unit.is_empty() { "" } else { " " },
                by.unit
            ),
            all => format!(
                "{} is ({})",
                by.what,
                all.iter().map(number).collect::<Vec<_>>().join(", ")
            ),
        };
        let by = keys.by.iter().map(now).collect::<Vec<_>>().join(", ");
        let weights = keys
            .weights
            .iter()
            .map(|weight| format!("{:.1}%", 100.0 * weight))
            .collect::<Vec<_>>()
            .join(" ");
        let name = if keys.name.is_empty() { "Keys" } else { &keys.name };
        let _ = writeln!(text, "    {name} on `{}`: {by}; weights {weights}", keys.object);
    }
    if look.keys.len() > MOST {
        let _ = writeln!(text, "    and {} more", look.keys.len() - MOST);
    }
    text
}

/// A node with its operations, and the stage that it runs in.
fn with_cost(path: &str, look: &LookReport, report: &ExplainReport) -> String {
    let is_it = |effect: &&Effect| {
        effect.kind == EffectKind::Node
            && effect.node.as_deref() == Some(path)
            && effect.look.as_deref() == Some(&look.name)
            && effect.state != EffectState::Dropped
    };
    match report.effects.iter().find(is_it) {
        Some(effect) => format!("{path} ({})", effect.cost.operations),
        None => path.to_owned(),
    }
}

fn tell_nodes(look: &LookReport, report: &ExplainReport) -> String {
    let nodes = &look.nodes;
    let mut text = format!("\n  Nodes: {} once groups are opened\n", nodes.total);
    let kinds = [
        ("run at each fragment, with their operations", &nodes.fragment),
        ("run on the host before drawing", &nodes.host),
        ("folded into constants when the look was compiled", &nodes.folded),
    ];
    for (what, paths) in kinds.iter().filter(|(_, paths)| !paths.is_empty()) {
        let told: Vec<String> = paths.iter().map(|path| with_cost(path, look, report)).collect();
        let _ = writeln!(text, "    {} {what}: {}", paths.len(), told.join(", "));
    }
    if !nodes.removed.is_empty() {
        let _ =
            writeln!(text, "    {} left out, without changing the picture:", nodes.removed.len());
        for removal in &nodes.removed {
            // Reasons by ranges name their proof themselves.
            let label = Some(removal.proof.label()).filter(|label| !removal.reason.contains(label));
            let saved = EffectCost::operations(removal.operations);
            let saved = (removal.operations > 0).then(|| format!("saves {saved}"));
            let more: Vec<&str> = label.into_iter().chain(saved.as_deref()).collect();
            let more =
                if more.is_empty() { String::new() } else { format!(" ({})", more.join("; ")) };
            let _ = writeln!(text, "      `{}`: {}{more}", removal.path, removal.reason);
        }
    }
    if !nodes.removed_within.is_empty() {
        let count = nodes.removed_within.len();
        let _ = writeln!(text, "    {count} take shorter forms, without changing the picture:");
        for removal in &nodes.removed_within {
            let _ = writeln!(text, "      `{}`: {}", removal.path, removal.reason);
        }
    }
    for LoopReport { lights, nodes, operations } in &nodes.loops {
        let nodes: Vec<String> = nodes.iter().map(|node| format!("`{node}`")).collect();
        let lights: Vec<&str> = lights.iter().map(LightId::as_str).collect();
        let _ = writeln!(
            text,
            "    {} lights in a loop, {} each, joined by {}: {}",
            lights.len(),
            EffectCost::operations(*operations),
            nodes.join(", "),
            lights.join(", ")
        );
    }
    text
}
