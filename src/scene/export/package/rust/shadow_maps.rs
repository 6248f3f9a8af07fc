//! Shadow maps of crates: which lights have them.

use std::collections::BTreeSet;

use super::super::PackageRequest;
use super::{Template, member, wide};
use crate::document::{LightKind, LightSpace};

/// The module that places lights in shadow maps.
pub(in super::super) const SHADOW_MAPS: &str = include_str!("template/shadow_maps.rs.in");

/// Fills the template of the module, and opens the sections of looks that read shadow maps.
pub(in super::super) fn fill_shadow_maps(template: &mut Template, request: &PackageRequest<'_>) {
    let described = &request.description.lights;
    let asks = |id: &crate::ids::LightId| {
        let mut lights = described.iter();
        lights.any(|light| light.id == *id && light.fields.contains("light.shadow_map"))
    };
    let lights = request.work.lights.iter().filter(|light| asks(&light.id));
    let (mut spaces, mut places) = (BTreeSet::new(), Vec::new());
    let mut kinds = BTreeSet::new();
    for light in lights {
        let (name, frame) = match light.light.space {
            LightSpace::Illumination => ("illumination", ["around.illumination", "[0.0; 3]"]),
            LightSpace::World => ("world", [IDENTITY, "[0.0; 3]"]),
            LightSpace::Camera => {
                ("camera", ["math::transposed(&around.camera_from_world)", "[0.0; 3]"])
            }
            LightSpace::Object => ("object", ["around.object_axes", "around.object_middle"]),
        };
        let [axes, origin] = frame;
        spaces.insert(format!("let {name} = frame({axes}, {origin});"));
        let kind = if light.light.kind == LightKind::Directional { "sun" } else { "lamp" };
        kinds.insert(kind);
        let own = format!("settings.{}", member(&light.member));
        let start = format!("{own}.shadow_map =");
        let value = format!("self.{kind}({own}, {name});");
        let in_one = wide(&start, " ", &value, 8);
        places.extend(in_one.unwrap_or_else(|| vec![start, format!("    {value}")]));
    }
    template.section("shadows", !places.is_empty());
    let reads_around = spaces.iter().any(|line| line.contains("around."));
    template.place("around", if reads_around { "around" } else { "_around" });
    template.section("sun_shadows", kinds.contains("sun"));
    template.section("lamp_shadows", kinds.contains("lamp"));
    template.lines("shadow_lights", spaces.into_iter().chain(places).collect());
}

/// Axes of the world.
const IDENTITY: &str = "[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]";
