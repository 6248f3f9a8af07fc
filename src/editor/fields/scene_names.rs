//! Names of a scene's values, in words: what has the value, and what it is.

use chiaro_locale::{Text, text, tr};

use crate::state::reading::spoken;

/// Words of a scene's fields, for people.
const WORDS: [(&str, Text); 17] = [
    ("camera", text!("scene" => "Camera")),
    ("eye", text!("scene" => "Eye")),
    ("target", text!("scene" => "Target")),
    ("fov", text!("scene" => "Fov")),
    ("height", text!("scene" => "Height")),
    ("translate", text!("scene" => "Place")),
    ("rotate", text!("scene" => "Turn")),
    ("scale", text!("scene" => "Scale")),
    ("visible", text!("scene" => "Visible")),
    ("intensity", text!("scene" => "Intensity")),
    ("exposure", text!("scene" => "Exposure")),
    ("tint", text!("scene" => "Tint")),
    ("backdrop", text!("scene" => "Backdrop")),
    ("mesh", text!("scene" => "Mesh")),
    ("up", text!("scene" => "Up")),
    ("color", text!("scene" => "Color")),
    ("outlines", text!("scene" => "Outlines")),
];

/// Owner and name of a value of the scene, by its address.
pub(crate) fn of(target: &str) -> [String; 2] {
    let word = |name: &str| match WORDS.iter().find(|(known, _)| *known == name) {
        Some((_, text)) => text.tr().to_owned(),
        None => spoken(name),
    };
    let Some((first, rest)) = target.split_once('.') else {
        return [tr!("scene" => "Scene").to_owned(), word(target)];
    };
    match (first, rest.split_once('.')) {
        ("objects" | "light_groups" | "lights", Some((id, field))) => {
            let field = field.trim_start_matches("values.").trim_start_matches("transform.");
            [id.to_owned(), word(field)]
        }
        _ => [word(first), word(rest)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_the_scene_have_names() {
        let said = |target: &str| of(target).join(": ");
        assert_eq!(said("camera.eye"), "Camera: Eye");
        assert_eq!(said("backdrop"), "Scene: Backdrop");
        assert_eq!(said("lights.sun.intensity"), "sun: Intensity");
        assert_eq!(said("objects.hob.transform.translate"), "hob: Place");
        assert_eq!(said("objects.hob.transform.rotate"), "hob: Turn");
        assert_eq!(said("objects.hob.transform.scale"), "hob: Scale");
        assert_eq!(said("objects.hob.values.rim_width"), "hob: Rim width");
        assert!(said("light_groups.dusk.exposure").starts_with("dusk: "));
    }
}
