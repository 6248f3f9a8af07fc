//! Paths of pictures and HCBTFs.

use chiaro_locale::tr;
use eframe::egui::{Id, TextEdit, Ui};

use crate::document::Value;
use crate::frame::MESH_PREFIX;
use crate::geometry::MaterialMap;
use crate::widgets::text::is_typed;

/// Maps of a mesh's own materials, in the order of the menu.
const MESH_MAPS: [MaterialMap; 5] = [
    MaterialMap::BaseColor,
    MaterialMap::Normal,
    MaterialMap::Occlusion,
    MaterialMap::Emissive,
    MaterialMap::MetallicRoughness,
];

/// Name of a map, as artists say it.
fn name_of(map: MaterialMap) -> &'static str {
    match map {
        MaterialMap::BaseColor => tr!("Base color"),
        MaterialMap::Normal => tr!("map" => "Normal"),
        MaterialMap::Occlusion => tr!("Occlusion"),
        MaterialMap::Emissive => tr!("Emissive"),
        MaterialMap::MetallicRoughness => tr!("Roughness and metalness"),
    }
}

/// Shows a menu of the maps that a mesh's own material has. Returns the path of the chosen one.
fn mesh_map(ui: &mut Ui) -> Option<String> {
    let mut chosen = None;
    let menu = ui.menu_button(tr!("Mesh"), |ui| {
        for map in MESH_MAPS {
            if ui.button(name_of(map)).clicked() {
                chosen = Some(format!("{MESH_PREFIX}{}", map.name()));
                ui.close();
            }
        }
    });
    menu.response
        .on_hover_text(tr!("Takes a picture from the material that the mesh's own file has"));
    chosen
}

/// Shows the path of a picture or an HCBTF; an image may be one of the mesh's own, too. Returns the
/// widget's id and the new value where it changed.
pub(crate) fn edit(
    ui: &mut Ui,
    label: Id,
    value: Option<&Value>,
    is_image: bool,
) -> Option<(Id, Value)> {
    let mut text = match value {
        Some(Value::Text(text)) => text.clone(),
        _ => String::new(),
    };
    let chosen = if is_image { mesh_map(ui) } else { None };
    let edit = TextEdit::singleline(&mut text)
        .hint_text(tr!("path beside the look"))
        .desired_width(f32::INFINITY);
    let response = ui.add(edit).labelled_by(label);
    let is_typed = is_typed(ui, &response, &mut text);
    let changed = (is_typed || chosen.is_some()).then_some(response.id);
    if let Some(name) = chosen {
        text = name;
    }
    // A long path does not fit.
    if !text.is_empty() {
        response.on_hover_text(&text);
    }
    changed.map(|id| (id, Value::Text(text)))
}
