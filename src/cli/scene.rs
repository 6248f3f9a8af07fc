//! Checks of a scene's looks, the same for every subcommand that takes scenes.

use std::collections::BTreeMap;
use std::path::Path;

use crate::compile::check as check_look;
use crate::diag::{Diagnostic, WithWarnings, has_errors};
use crate::document::{LoadedDocument, Look, Object, Scene};
use crate::files::Files as _;
use crate::frame::{Setup, check_exposed_value};
use crate::library::Library;

/// The looks that objects of a scene name, by that name; missing files are left out.
pub(super) fn looks(scene: &Scene, folder: &Path) -> BTreeMap<String, LoadedDocument<Look>> {
    let names = scene.objects.values().flat_map(|object| object.looks.values());
    let mut looks = BTreeMap::new();
    for name in names {
        let path = folder.join(name);
        if crate::files::Disk.has_file(&path) {
            looks.entry(name.clone()).or_insert_with(|| Look::load(&crate::files::Disk, &path));
        }
    }
    looks
}

/// Problems of the values that objects set: those that their looks cannot take, or do not expose.
pub(super) fn value_problems(
    scene: &Scene,
    looks: &BTreeMap<String, LoadedDocument<Look>>,
    library: &Library,
) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let sets_values = |object: &Object, name: &str| {
        !object.values.is_empty() && object.looks.values().any(|worn| worn.as_str() == name)
    };
    for (name, look) in looks {
        if scene.objects.values().any(|object| sets_values(object, name)) {
            found.extend(wrong_values(scene, name, look.value.as_ref(), library));
        }
    }
    found.extend(unknown_values(scene, looks));
    found
}

/// Returns the problems that [`value_problems`] finds in the visible objects of a scene that was
/// opened to be drawn.
///
/// # Errors
/// All problems, if any is an error: the picture would not be what the scene says.
pub(super) fn check_values(
    setup: &Setup,
    library: &Library,
) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let Some(source) = &setup.source else { return Ok(Vec::new()) };
    // Values are cleared and objects not taken out, so that places in the file stay the same.
    let mut scene = setup.scene.clone();
    scene
        .objects
        .values_mut()
        .filter(|object| !object.visible)
        .for_each(|object| object.values.clear());
    if scene.objects.values().all(|object| object.values.is_empty()) {
        return Ok(Vec::new());
    }
    let looks = looks(&scene, &setup.folder);
    let mut found = value_problems(&scene, &looks, library);
    source.locate_all(&mut found);
    if has_errors(&found) { Err(found) } else { Ok(found) }
}

/// Problems of values that an object sets and that its look cannot take.
fn wrong_values(
    scene: &Scene,
    look_name: &str,
    look: Option<&Look>,
    library: &Library,
) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let Some((look, WithWarnings { value: typed, .. })) =
        look.and_then(|look| Some((look, check_look(look, library, None).ok()?)))
    else {
        return found;
    };
    let wears = |object: &Object| object.looks.values().any(|name| name == look_name);
    for (index, (_, object)) in
        scene.objects.iter().enumerate().filter(|(_, (_, object))| wears(object))
    {
        for (name, value) in &object.values {
            let problem = check_exposed_value(look, &typed, name.as_str(), value);
            found.extend(
                problem.map(|problem| problem.json_path(format!("objects[{index}].values.{name}"))),
            );
        }
    }
    found
}

/// Problems of values that an object sets and that none of its looks exposes.
fn unknown_values(
    scene: &Scene,
    looks: &BTreeMap<String, LoadedDocument<Look>>,
) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (index, (id, object)) in scene.objects.iter().enumerate() {
        let worn = object.looks.values().filter_map(|look| looks.get(look)?.value.as_ref());
        let known: Vec<&str> =
            worn.flat_map(|look| &look.exposed).map(|exposed| exposed.name.as_str()).collect();
        for name in object.values.keys().filter(|name| !known.contains(&name.as_str())) {
            let message = format!("object `{id}` sets `{name}`, which none of its looks exposes");
            let problem = Diagnostic::warning("unknown-parameter", message)
                .json_path(format!("objects[{index}].values.{name}"))
                .suggest(name.as_str(), known.iter().copied());
            found.push(problem);
        }
    }
    found
}
