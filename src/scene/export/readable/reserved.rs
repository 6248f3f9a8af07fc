//! Names that a language has for itself.
//!
//! naga knows them and tells nobody. A small module with variables of the names in question is
//! written, and those that come back changed are the language's own.

use std::collections::BTreeSet;

use naga::{
    EntryPoint, Function, LocalVariable, Module, Scalar, ShaderStage, Span, Type, TypeInner,
};

use super::inline::DeclarationLine;
use crate::wgsl::{ValidModule, validate};

/// The names among `asked` that the language has for itself; `write` writes a module in the
/// language. Names that end with a digit are left out: naga changes every one of them.
///
/// # Errors
/// The error of `write`.
pub(super) fn reserved(
    asked: &BTreeSet<String>,
    write: impl FnOnce(&ValidModule) -> Result<String, String>,
) -> Result<BTreeSet<String>, String> {
    let asked: Vec<&String> =
        asked.iter().filter(|name| !name.ends_with(|c: char| c.is_ascii_digit())).collect();
    let module = validate(module_of(&asked)).map_err(|error| error.to_string())?;
    let text = write(&module)?;
    let declared = text.lines().filter_map(DeclarationLine::of).map(|declared| declared.name);
    let written: BTreeSet<&str> = declared.collect();
    Ok(asked.into_iter().filter(|name| !written.contains(name.as_str())).cloned().collect())
}

/// A fragment shader that does nothing, with a variable of each name.
fn module_of(names: &[&String]) -> Module {
    let mut module = Module::default();
    let float = Type { name: None, inner: TypeInner::Scalar(Scalar::F32) };
    let ty = module.types.insert(float, Span::UNDEFINED);
    let mut function = Function::default();
    for &name in names {
        let variable = LocalVariable { name: Some(name.clone()), ty, init: None };
        function.local_variables.append(variable, Span::UNDEFINED);
    }
    module.entry_points.push(EntryPoint {
        name: "fs_main".to_owned(),
        stage: ShaderStage::Fragment,
        early_depth_test: None,
        workgroup_size: [0; 3],
        workgroup_size_overrides: None,
        function,
        mesh_info: None,
        task_payload: None,
        incoming_ray_payload: None,
    });
    module
}

#[cfg(test)]
mod tests {
    use naga::back::glsl;

    use super::*;

    #[test]
    fn naga_tells_the_names_of_glsl() {
        let write = |valid: &ValidModule| {
            let mut text = String::new();
            let options =
                glsl::Options { version: glsl::Version::Desktop(330), ..glsl::Options::default() };
            let pipeline = glsl::PipelineOptions {
                shader_stage: ShaderStage::Fragment,
                entry_point: "fs_main".to_owned(),
                multiview: None,
            };
            let policies = naga::proc::BoundsCheckPolicies::default();
            let (module, info) = (&valid.module, &valid.info);
            glsl::Writer::new(&mut text, module, info, &options, &pipeline, policies)
                .and_then(|mut writer| writer.write())
                .map_err(|error| error.to_string())?;
            Ok(text)
        };
        let asked = ["angle", "half", "distance", "tone_2"].map(str::to_owned).into();
        let wanted: BTreeSet<String> = ["half", "distance"].map(str::to_owned).into();
        assert_eq!(reserved(&asked, write).unwrap(), wanted);
    }
}
