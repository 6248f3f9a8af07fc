//! The look that a bare HCBTF is seen in: a lookup with one light, over gray where nothing is
//! painted.

use serde_json::json;

use crate::catalog::Catalog;
use crate::document::{Edit, GraphId, Look, Value};
use crate::library::Type;
use crate::state::orbit::{Orbit, PLANE};

/// Text of the default look on an HCBTF named `name`, whose tiles have `size` texels and keep their
/// shape in the look.
pub(crate) fn default_look(sheet: &str, name: &str, size: [u32; 2]) -> String {
    let [width, height] = size.map(|side| f64::from(side.max(1)));
    let shorter = width.min(height);
    // Number of tiles along each side of the square, two along a tile's longer side.
    let scale = [2.0 * height / shorter, 2.0 * width / shorter];
    let look = json!({
        "name": name,
        "lights": {"key": {"name": "Key light", "direction": [-0.45, 0.55, 0.7]}},
        "nodes": [
            {"id": "light", "kind": "light", "at": [0, 120], "values": {"light": "key"}},
            {"id": "painting", "kind": "hcbtf_lookup", "at": [260, 0], "name": "Painting",
             "values": {
                 "sheet": sheet, "lookup": "texels", "scale": scale, "unlit": [0.05, 0.05, 0.07, 1]
             }},
            {
                "id": "base", "kind": "base", "at": [260, -140],
                "values": {"color": [0.36, 0.36, 0.38]}
            },
            {"id": "over", "kind": "blend", "at": [520, 0], "values": {"mode": "alpha"}},
            {"id": "output", "kind": "output", "at": [780, 0]}
        ],
        "wires": [
            {"from": "light", "to": "painting.light"},
            {"from": "base", "to": "over.below"},
            {"from": "painting", "to": "over.color"},
            {"from": "over", "to": "output.color"}
        ]
    });
    serde_json::to_string_pretty(&look).unwrap_or_default()
}

/// True if the picture shows a flat square that lies.
pub(crate) fn lies_flat(view: &Orbit) -> bool {
    view.mesh == PLANE && view.z_is_up
}

/// Names of the HCBTFs that a look uses, its groups included.
pub(crate) fn sheets(look: &Look, catalog: &Catalog) -> Vec<String> {
    let mut found = Vec::new();
    each_sheet(look, catalog, |_, _, _, name| found.push(name.to_owned()));
    found
}

/// Edits by which a look names the HCBTF `to` wherever it names `from`.
pub(crate) fn rename(look: &Look, catalog: &Catalog, from: &str, to: &str) -> Vec<Edit> {
    let mut edits = Vec::new();
    each_sheet(look, catalog, |graph, id, port, name| {
        if name == from {
            let value = Value::Text(to.to_owned());
            edits.push(Edit::SetValue {
                graph: graph.clone(),
                id: id.clone(),
                port: port.clone(),
                value,
                index: None,
            });
        }
    });
    edits
}

/// The look with the HCBTF named `to` wherever it was named `from`; `None` where that is
/// impossible.
pub(crate) fn renamed(look: &Look, catalog: &Catalog, from: &str, to: &str) -> Option<Look> {
    let mut named = look.clone();
    for edit in rename(look, catalog, from, to) {
        named.apply(edit).ok()?;
    }
    Some(named)
}

/// Rewrites an edit of the past so that it names the HCBTF `to` wherever it names `from`.
pub(crate) fn rename_in(edit: &mut Edit, from: &str, to: &str) {
    let quoted = |name: &str| serde_json::to_string(name).unwrap_or_default();
    let text = serde_json::to_string(edit).unwrap_or_default();
    // Quotes within longer texts are escaped: a match is a whole name.
    let from = quoted(from);
    if text.contains(&from)
        && let Ok(renamed) = serde_json::from_str(&text.replace(&from, &quoted(to)))
    {
        *edit = renamed;
    }
}

/// Calls `tell` for every HCBTF input that has a name: with graph, node, input and name.
fn each_sheet(
    look: &Look,
    catalog: &Catalog,
    mut tell: impl FnMut(&GraphId, &crate::ids::NodeId, &crate::ids::PortName, &str),
) {
    let inner = look
        .definitions
        .iter()
        .map(|(id, definition)| (GraphId::Definition(id.clone()), &definition.graph));
    for (graph, nodes) in std::iter::once((GraphId::Look, &look.graph)).chain(inner) {
        for (id, node) in &nodes.nodes {
            let Some(kind) = catalog.of(node) else { continue };
            for port in kind.inputs.iter().filter(|port| port.ty == Type::Hcbtf) {
                if let Some(Value::Text(name)) = node.values.get(&port.name) {
                    tell(&graph, id, &port.name, name);
                }
            }
        }
    }
}
