//! The look that a bare HCBTF is seen in: a lookup with one light, over grey where nothing is
//! painted.

use std::path::Path;
use std::sync::Arc;

use glam::{DQuat, DVec3};
use serde_json::json;

use super::work::OpenPainting;
use crate::catalog::Catalog;
use crate::document::{Edit, GraphId, Look, Value};
use crate::frame::{SetupLook, UNSAVED_HCBTF};
use crate::library::Type;
use crate::state::orbit::{Orbit, PLANE};
use crate::state::scene::{folder_of, real};
use crate::state::session::Session;

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

/// The picture's view with camera and light turned to the sample at work, over a flat square that
/// lies; `None` in a scene, which has its own objects.
pub(crate) fn from_here(session: &Session, work: &OpenPainting) -> Option<Orbit> {
    let mut view = session.view.orbit.clone();
    let (_, light) = session.look().lights.first().filter(|_| session.stage().is_none())?;
    if !lies_flat(&view) {
        view = Orbit { mesh: PLANE.to_owned(), z_is_up: true, ..Orbit::default() };
    }
    // The square lies in the world with u along x, v along -z and the normal along y.
    let world = |vector: DVec3| DVec3::new(vector.x, vector.z, -vector.y);
    let (grid, at) = (work.grid(), work.at());
    let eye = world(grid.view.vector(at.view));
    view.upright = DQuat::IDENTITY;
    view.pitch = eye.y.clamp(-1.0, 1.0).asin();
    view.yaw = if at.view.theta == 0 { 0.0 } else { eye.x.atan2(eye.z) };
    let shines_from = DVec3::from(light.direction).try_normalize()?;
    view.illumination = DQuat::from_rotation_arc(shines_from, world(grid.light.vector(at.light)));
    Some(view)
}

/// True if the picture shows a flat square that lies.
pub(crate) fn lies_flat(view: &Orbit) -> bool {
    view.mesh == PLANE && view.z_is_up
}

/// True if the open look, or any look of the open scene, shows the painting.
pub(crate) fn shows(session: &Session) -> bool {
    let Some(work) = session.painting() else { return false };
    let path = work.path().unwrap_or(Path::new(UNSAVED_HCBTF));
    let names_it = |look: &Arc<SetupLook>| {
        let names = sheets(&look.look, &session.project.catalog);
        names.iter().any(|name| !name.is_empty() && real(&look.folder.join(name)) == real(path))
    };
    session.shows_painting(path)
        || session.stage().is_some_and(|stage| stage.other_looks().any(names_it))
}

/// True if `look`, of the file `path` or of none, shows the painting.
pub(crate) fn shows_in(session: &Session, look: &Look, path: Option<&Path>) -> bool {
    let Some(work) = session.painting() else { return false };
    let names = sheets(look, &session.project.catalog);
    match work.path() {
        None => path.is_none() && names.iter().any(|name| name == UNSAVED_HCBTF),
        Some(painted) => {
            let folder = path.map(folder_of).unwrap_or_default();
            names.iter().any(|name| !name.is_empty() && real(&folder.join(name)) == real(painted))
        }
    }
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
