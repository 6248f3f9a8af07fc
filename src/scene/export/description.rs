//! The JSON file that describes an exported look: everything that a host needs to draw it.
//!
//! docs/hosts.md says, for whoever has the folder alone, how to draw with it: the steps of a
//! frame, what goes into each binding, and how parameters, lights and keys become the numbers that
//! shaders read. A field that is added or changed here belongs there, too.
//!
//! # Versions
//!
//! `format` counts up where a reader has to change; new fields may come without that.

use serde::Serialize;
use serde_json::{Map, Value, json};

use super::exposed::Parameters;
use super::language::Language;
use super::modules::{Modules, ShaderModule};
use super::reflect::BoundVariable;
use super::{exposed, host};
use crate::compile::{ParamId, TierReason, TypedGraph};
use crate::document::{ColorSpace, DirectionKeys, Look, Tier};
use crate::frame::ViewNumber;
use crate::library::Library;

pub use super::exposed::{ExposedParameter, LightDescription};
pub use super::host::{
    ContextDescription, DriverDescription, HostDescription, MemberDescription, StepDescription,
};
pub use super::language::{
    ClipSpace, LanguageAttribute, LanguageBinding, LanguageEntryPoint, LanguageFile, LanguageModule,
};
pub use super::modules::{DrawnSides, ExportImage, ExportPass, ExportTarget, Feed, PassInput};
pub use super::reflect::{AttributeDescription, BindingType, EntryPoint, LocatedValue, Member};

/// Version of the description's form.
const FORMAT: u32 = 2;

/// The description of an exported look.
#[derive(Clone, Debug, Serialize)]
pub struct Description {
    /// Name of the look.
    pub look: String,
    /// Version of Chiaro.
    pub chiaro: &'static str,
    /// Version of the description's form.
    pub format: u32,
    /// Meaning of the picture's numbers: as shown (sRGB-encoded), or linear light. Straight alpha.
    pub color_space: ColorSpace,
    /// True if every pixel that the look draws has alpha 1, whatever parameters say: it needs no
    /// blending.
    pub opaque: bool,
    /// Tiers of the nodes.
    pub tiers: TierCounts,
    /// Passes to run, in order.
    pub passes: Vec<ExportPass>,
    /// Modules that passes run.
    pub modules: Vec<ModuleDescription>,
    /// Files, names and bindings of the modules in each language, by slug.
    pub languages: Map<String, Value>,
    /// Parameters that may be set.
    pub parameters: Vec<ExposedParameter>,
    /// Lights that the look reads.
    pub lights: Vec<LightDescription>,
    /// Images that the look reads.
    pub images: Vec<ExportImage>,
    /// Direction keys of the look, as documents write them: a key among drivers has its place in
    /// `at`, a number for each driver. Left out where the look has none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub direction_keys: Vec<Value>,
    /// Time keys of the look, as its document has them; left out where it has none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub time_keys: Vec<crate::document::TimeKeys>,
}

/// Number of the look's nodes in each tier, groups opened, of those that have cheaper ones.
#[derive(Clone, Debug, Serialize)]
pub struct TierCounts {
    /// Nodes in the exact tier.
    pub exact: usize,
    /// Nodes in the balanced tier.
    pub balanced: usize,
    /// Nodes in the fast tier.
    pub fast: usize,
    /// Greatest difference from the exact picture, in numbers of a color, that the tiers were
    /// chosen for; left out where the document names the tier of every node.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_error: Option<f64>,
}

impl TierCounts {
    /// Counts the nodes of a look that was checked.
    pub fn of(look: &Look, typed: &TypedGraph) -> Self {
        let nodes = || typed.nodes.iter().filter(|node| node.def.has_cheaper());
        let count = |tier: Tier| nodes().filter(|node| node.tier == tier).count();
        let is_chosen = nodes().any(|node| node.tier_reason != TierReason::Named);
        Self {
            exact: count(Tier::Exact),
            balanced: count(Tier::Balanced),
            fast: count(Tier::Fast),
            max_error: is_chosen.then_some(look.max_error),
        }
    }
}

/// A module, independent of any language.
#[derive(Clone, Debug, Serialize)]
pub struct ModuleDescription {
    /// Name of the module.
    pub name: &'static str,
    /// Purpose of the module.
    pub purpose: &'static str,
    /// Entry points: a vertex and a fragment shader.
    pub entry_points: Vec<EntryPoint>,
    /// Bindings of the module.
    pub bindings: Vec<BindingDescription>,
    /// Program that computes the `Look` uniform; none where the module has no such uniform.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub host: Option<HostDescription>,
}

/// A binding, independent of any language.
#[derive(Clone, Debug, Serialize)]
pub struct BindingDescription {
    /// Name of the binding in WGSL.
    pub name: String,
    /// Kind of the binding for a graphics API.
    pub kind: BindingType,
    /// Type of the binding in WGSL.
    #[serde(rename = "type")]
    pub ty: String,
    /// Resource or values that a host puts into the binding.
    pub feed: Feed,
    /// Size of a uniform buffer, in bytes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<u32>,
    /// Members of a uniform buffer.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<MeaningfulMember>,
}

/// A member with its meaning.
#[derive(Clone, Debug, Serialize)]
pub struct MeaningfulMember {
    /// Layout of the member.
    #[serde(flatten)]
    pub member: Member,
    /// Meaning of the value to write; empty for members of `Look`, which `host` computes.
    #[serde(skip_serializing_if = "str::is_empty")]
    pub meaning: &'static str,
}

/// A language, with the modules in it.
#[derive(Clone, Debug, Serialize)]
pub struct LanguageDescription<'a> {
    /// Name of the language for people.
    pub label: &'static str,
    /// Program that accepts the golden outputs of Chiaro's own tests; none for languages that
    /// nobody has compiled.
    pub verified_by: Option<&'static str>,
    /// Conventions of the API.
    pub clip_space: ClipSpace,
    /// Further hints for a host.
    #[serde(skip_serializing_if = "str::is_empty")]
    pub note: &'static str,
    /// Modules in this language.
    pub modules: Vec<&'a LanguageModule>,
}

/// The description.
pub(super) fn description(
    look: &Look,
    library: &Library,
    typed: &TypedGraph,
    found: &Modules,
    written: &[(&'static Language, LanguageModule)],
) -> Description {
    let parameters = exposed::parameters(look, library, typed, found);
    let modules: Vec<_> =
        found.modules.iter().map(|module| describe_module(module, &parameters.index)).collect();
    let mut lights = exposed::lights(look, found);
    for light in &mut lights {
        light.members = members_of(light, &modules);
    }
    Description {
        look: look.name.clone(),
        chiaro: env!("CARGO_PKG_VERSION"),
        format: FORMAT,
        color_space: look.color_space,
        opaque: found.is_opaque,
        tiers: TierCounts::of(look, typed),
        passes: found.passes.iter().map(|pass| with_sides(pass, found, &parameters)).collect(),
        modules,
        languages: languages(written),
        parameters: parameters.list,
        lights,
        images: found.images.clone(),
        direction_keys: look.direction_keys.iter().map(direction_keys).collect(),
        time_keys: look.time_keys.clone(),
    }
}

/// A pass with the parameter that decides about the sides of its meshes.
fn with_sides(pass: &ExportPass, found: &Modules, parameters: &Parameters) -> ExportPass {
    let cutoff = found.cutoff.filter(|_| pass.draws == "meshes");
    let sides_parameter = cutoff.and_then(|id| parameters.index.get(&id).copied());
    ExportPass { sides_parameter, ..pass.clone() }
}

/// A set of direction keys with every field, each under the name that documents have for it.
fn direction_keys(keys: &DirectionKeys) -> Value {
    let mut described = json!(keys);
    let Some(axes) = keys.by.axes() else { return described };
    let list = described.get_mut("keys").and_then(Value::as_array_mut).into_iter().flatten();
    for (fields, key) in list.filter_map(Value::as_object_mut).zip(&keys.keys) {
        let at = json!(key.direction[..axes.min(key.direction.len())]);
        let others = std::mem::take(fields).into_iter().filter(|(name, _)| name != "direction");
        *fields = std::iter::once(("at".to_owned(), at)).chain(others).collect();
    }
    described
}

fn describe_module(
    module: &ShaderModule,
    parameters: &std::collections::HashMap<ParamId, usize>,
) -> ModuleDescription {
    let binding = |(bound, feed): (&BoundVariable, &Feed)| BindingDescription {
        name: bound.name.clone(),
        kind: bound.kind,
        ty: bound.ty.clone(),
        feed: feed.clone(),
        size: (bound.kind == BindingType::Uniform).then_some(bound.size),
        members: bound.members.iter().map(|member| meaningful(member, feed)).collect(),
    };
    ModuleDescription {
        name: module.name,
        purpose: module.purpose,
        entry_points: module.entry_points.clone(),
        bindings: module.bindings.iter().zip(&module.feeds).map(binding).collect(),
        host: module.host().and_then(|host| host::describe(host, parameters)),
    }
}

fn meaningful(member: &Member, feed: &Feed) -> MeaningfulMember {
    let meaning = match (feed, member.name.as_str()) {
        (Feed::View, "clip_from_world") => {
            "projection times view matrix, for the API's own clip space"
        }
        (Feed::View, "camera_from_world") => {
            "view matrix; camera axes: x right, y up, z toward the viewer"
        }
        (Feed::View, "eye") => {
            "the eye in world space and 1; for parallel projection the direction toward the viewer \
             and 0"
        }
        (Feed::View, "screen") => {
            "1, 1, 0, 0 where the API's `first_row` is top; 1, -1, 0 and the picture's height in \
             pixels where it is bottom"
        }
        (Feed::Object, "world_from_object") => "model matrix",
        (Feed::Object, "world_from_normal") => {
            "inverse transpose of the model matrix's upper left 3x3, for normals"
        }
        (Feed::Object, "id") => "counts objects from 0",
        (Feed::Object, "material") => "counts the materials of the object from 0",
        (Feed::LightLayer, "clip_from_world") => {
            "matrix from world space to the layer, for the API's own clip space; of a directional \
             light parallel along it, to the right and up as `map_axes` in the look's module says; \
             of a lamp a face of a cube about it, +x, -x, +y, -y, +z, -z, with the next axes (of x \
             y and z, of y z and x, of z x and y) to the right and up"
        }
        (Feed::LightLayer, "measure") => {
            "row whose product with a place and 1 is the height toward a directional light, or a \
             lamp's depth along the face's axis"
        }
        (Feed::LightLayer, "is_lamp") => "1 for a lamp, 0 for a directional light",
        (Feed::LightLayer, "layer") => "number of the layer",
        (Feed::LightCaster, "world_from_object") => "model matrix",
        (Feed::LightCaster, "number") => "counts objects from 1",
        (Feed::Numbers, name) => ViewNumber::named(name).map_or("", |number| number.meaning),
        _ => "",
    };
    MeaningfulMember { member: member.clone(), meaning }
}

fn members_of(light: &LightDescription, modules: &[ModuleDescription]) -> Vec<String> {
    let mut members = Vec::new();
    for module in modules {
        let of_module = module.host.iter().flat_map(|host| &host.members);
        let dependent = of_module.filter(|member| member.lights.contains(&light.id));
        members.extend(dependent.map(|member| format!("{}.{}", module.name, member.name)));
    }
    members
}

fn languages(written: &[(&'static Language, LanguageModule)]) -> Map<String, Value> {
    let mut found = Map::new();
    for (language, _) in written {
        let of_language = written
            .iter()
            .filter(|(other, _)| other.slug == language.slug)
            .map(|(_, module)| module);
        let described = LanguageDescription {
            label: language.label,
            verified_by: language.verified_by,
            clip_space: language.clip_space,
            note: language.note,
            modules: of_language.collect(),
        };
        found.insert(language.slug.to_owned(), json!(described));
    }
    found
}
