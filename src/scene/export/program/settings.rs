//! Settings: the parameters and lights of a look as the program takes them.

use std::collections::BTreeSet;

use chiaro_locale::tr;

use super::super::exposed::Parameters;
use super::super::modules::Modules;
use super::literal::is_numeric;
use super::{identifier, problem};
use crate::compile::{HostStep, ParamId};
use crate::diag::Diagnostic;
use crate::document::{Driver, KeyDirection, Light, LightKind, LightSpace, Look, Target};
use crate::ids::{LightId, PortName};
use crate::interp::Value;
use crate::library::{Context, Type};

/// A parameter of the program.
#[derive(Clone, Debug)]
pub(in super::super) struct ParameterSetting {
    /// Member of the settings.
    pub(in super::super) member: String,
    /// Name under which the artist exposed the value; `None` for one that only keys move.
    pub(in super::super) name: Option<PortName>,
    /// Index in the description's list of parameters.
    pub(in super::super) index: usize,
    /// Index among the compiled look's values.
    pub(in super::super) id: ParamId,
    pub(in super::super) ty: Type,
    /// Value where none is set.
    pub(in super::super) default: Value,
}

/// A light of the program.
#[derive(Clone, Debug)]
pub(in super::super) struct LightSetting {
    /// Member of the settings.
    pub(in super::super) member: String,
    pub(in super::super) id: LightId,
    pub(in super::super) light: Light,
}

impl LightSetting {
    /// Name of the constant of the light's kind.
    pub(super) fn kind(&self) -> &'static str {
        match self.light.kind {
            LightKind::Directional => "DIRECTIONAL_LIGHT",
            LightKind::Point => "POINT_LIGHT",
            LightKind::Spot => "SPOT_LIGHT",
        }
    }

    /// The light in the world, of the settings' member.
    pub(super) fn in_world(&self) -> String {
        let frame = match self.light.space {
            LightSpace::Illumination => "LightFrame(around.illumination, vec3f())",
            LightSpace::World => "LightFrame(mat3x3f(1, 0, 0, 0, 1, 0, 0, 0, 1), vec3f())",
            LightSpace::Camera => "LightFrame(transpose(around.camera_from_world), vec3f())",
            LightSpace::Object => "LightFrame(around.object_axes, around.object_middle)",
        };
        format!("light_in_world(settings.{}, {frame}, {})", self.member, self.kind())
    }
}

/// All settings.
#[derive(Clone, Debug, Default)]
pub(super) struct Settings {
    pub(super) parameters: Vec<ParameterSetting>,
    pub(super) lights: Vec<LightSetting>,
}

impl Settings {
    pub(super) fn of(
        look: &Look,
        modules: &Modules,
        parameters: &Parameters,
    ) -> Result<Self, Diagnostic> {
        let hosts = modules.modules.iter().filter_map(|module| module.host());
        let steps: Vec<&HostStep> = hosts.flat_map(|host| &host.source.steps).collect();
        let mut found = Self::default();
        let mut taken: Vec<String> = Vec::new();
        for step in &steps {
            let HostStep::Param { id, ty, value } = step else { continue };
            if !is_numeric(ty) || found.parameter(*id, ty).is_some() {
                continue;
            }
            let Some(&index) = parameters.index.get(id) else { continue };
            let parameter = &parameters.list[index];
            let wanted = match &parameter.name {
                Some(name) => name.to_string(),
                None => parameter.target.clone(),
            };
            let names: Vec<&str> = taken.iter().map(String::as_str).collect();
            let member = identifier(&wanted, &names);
            taken.push(member.clone());
            found.parameters.push(ParameterSetting {
                member,
                name: parameter.name.clone(),
                index,
                id: *id,
                ty: ty.clone(),
                default: value.clone(),
            });
        }
        let mut ids: BTreeSet<&LightId> = BTreeSet::new();
        for step in &steps {
            if let HostStep::Context(_, Some(light)) = step {
                ids.insert(light);
            }
        }
        for keys in &look.direction_keys {
            match &keys.by {
                KeyDirection::Light(light) => drop(ids.insert(light)),
                KeyDirection::Drivers(drivers) => {
                    ids.extend(drivers.iter().filter_map(Driver::light));
                }
                KeyDirection::View => {}
            }
        }
        for (id, light) in look.lights.iter().filter(|(id, _)| ids.contains(id)) {
            let names: Vec<&str> = taken.iter().map(String::as_str).collect();
            let member = identifier(&format!("{id}_light"), &names);
            taken.push(member.clone());
            found.lights.push(LightSetting { member, id: id.clone(), light: light.clone() });
        }
        for step in steps {
            if let HostStep::Context(context, Some(light)) = step
                && found.light(light).is_none()
            {
                let word = context.word();
                return Err(problem(tr!("there is no light `{light}` to give `{word}`")));
            }
        }
        Ok(found)
    }

    pub(super) fn parameter(&self, id: ParamId, ty: &Type) -> Option<&ParameterSetting> {
        self.parameters.iter().find(|it| it.id == id && it.ty == *ty)
    }

    /// The settings of an input, one for each type that it is taken as.
    pub(super) fn of_param(&self, id: ParamId) -> impl Iterator<Item = &ParameterSetting> {
        self.parameters.iter().filter(move |it| it.id == id)
    }

    pub(super) fn light(&self, id: &LightId) -> Option<&LightSetting> {
        self.lights.iter().find(|it| it.id == *id)
    }

    /// Member of a light's field that a target names, with the field.
    pub(super) fn light_field(&self, target: &Target) -> Option<(String, &LightSetting)> {
        let Target::Light { light, field } = target else { return None };
        let found = self.light(light)?;
        Some((format!("{}.{field}", found.member), found))
    }

    /// The struct.
    pub(super) fn wgsl(&self) -> String {
        let mut members = String::new();
        for setting in &self.parameters {
            members += &format!("    {}: {},\n", setting.member, setting.ty.wgsl());
        }
        for light in &self.lights {
            members += &format!("    {}: LightSettings,\n", light.member);
        }
        if members.is_empty() {
            members = "    nothing: f32,\n".to_owned();
        }
        format!("/// Values that may be set.\nstruct Settings {{\n{members}}}\n\n")
    }
}

/// The expression of a surrounding that is none of a light's.
pub(super) fn surrounding(context: Context) -> Result<&'static str, Diagnostic> {
    Ok(match context.word() {
        "camera_from_world" => "around.camera_from_world",
        "object_id" => "around.object_id",
        "time" => "around.time",
        "frame" => "around.frame",
        "viewport" => "around.viewport",
        word => return Err(problem(tr!("the surrounding `{word}` is unknown"))),
    })
}

/// The expression of a light's value, where `light` is the light in the world.
pub(super) fn light_value(
    context: Context,
    light: &str,
    kind: LightKind,
) -> Result<String, Diagnostic> {
    let is_directional = kind == LightKind::Directional;
    Ok(match context.word() {
        word @ ("light.direction"
        | "light.own_direction"
        | "light.position"
        | "light.aim"
        | "light.color"
        | "light.intensity"
        | "light.cone"
        | "light.own_from_world"
        | "light.shadow_map") => format!("{light}.{}", word.trim_start_matches("light.")),
        "light.fading" => format!("vec2f({light}.half_distance, {light}.range)"),
        "light.source" if is_directional => format!("vec4f({light}.direction, 0.0)"),
        "light.source" => format!("vec4f({light}.position, 1.0)"),
        "light.casters" => "-2.0".to_owned(),
        word => return Err(problem(tr!("`{word}` of a light is unknown"))),
    })
}
