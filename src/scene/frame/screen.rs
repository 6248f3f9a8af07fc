//! The modules of passes over the whole picture, ready to be run, with the resource of each
//! binding.

use crate::diag::Diagnostic;
use crate::library::{PassId, PassInput, PassWork};
use crate::wgsl::{self, Valid};

/// The module of a pass over the whole picture.
#[derive(Debug)]
pub struct ScreenModule {
    /// Source of the module, in WGSL.
    pub text: String,
    /// The module as naga validated it.
    pub valid: Valid,
    /// Bindings, all in group 0.
    pub bindings: Vec<ScreenBinding>,
}

/// A binding of a pass's module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScreenBinding {
    /// Number of the binding.
    pub binding: u32,
    /// Resource of the binding.
    pub holds: ScreenResource,
}

/// Resource of a binding of a pass's module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScreenResource {
    /// A result of an earlier pass.
    Image(PassImage),
    /// The numbers of the view, in order: [`View::screen_numbers`](super::View::screen_numbers).
    View,
}

/// A result of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PassImage {
    /// The pass.
    pub pass: PassId,
    /// Index of the result among the pass's outputs.
    pub output: usize,
}

impl PassImage {
    /// The image that a row names as an input of its pass.
    pub fn read(input: &PassInput) -> Option<Self> {
        let pass = PassId::from_slug(input.pass)?;
        Some(Self { pass, output: pass.row().output(input.output)? })
    }

    /// All images that a pass makes.
    pub fn written(pass: PassId) -> impl Iterator<Item = Self> {
        (0..pass.row().writes.len()).map(move |output| Self { pass, output })
    }
}

impl ScreenModule {
    /// The module of a pass; `None` for a pass that draws meshes.
    ///
    /// # Errors
    /// Where this build lacks the file, or where the file reads what its row does not say.
    pub fn of(pass: PassId) -> Result<Option<Self>, Vec<Diagnostic>> {
        let PassWork::Screen { shader, constants, .. } = pass.row().work else { return Ok(None) };
        let text = wgsl::pass(shader, constants)?.text;
        let wrong = |message: String| {
            vec![Diagnostic::error("internal-invalid-wgsl", format!("{shader}: {message}"))]
        };
        let valid = wgsl::parse(&text).map_err(|error| wrong(error.to_string()))?;
        let mut bindings = Vec::new();
        for (_, variable) in valid.module.global_variables.iter() {
            let Some(at) = &variable.binding else { continue };
            let name = variable.name.as_deref().unwrap_or_default();
            let holds = if variable.space == naga::AddressSpace::Uniform {
                ScreenResource::View
            } else {
                let input = pass.row().reads.iter().find(|input| input.binding == name);
                let image = input.and_then(PassImage::read);
                ScreenResource::Image(image.ok_or_else(|| {
                    wrong(format!("the row of `{}` does not say what `{name}` is", pass.row().slug))
                })?)
            };
            bindings.push(ScreenBinding { binding: at.binding, holds });
        }
        Ok(Some(Self { text, valid, bindings }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_what_its_row_says() {
        let mut files: Vec<&str> = Vec::new();
        for pass in PassId::all().filter(|pass| pass.is_screen()) {
            let module = ScreenModule::of(pass).unwrap_or_else(|problems| panic!("{problems:?}"));
            let module = module.expect("it draws over the picture");
            let point = &module.valid.module.entry_points;
            let fragment = point.iter().find(|point| point.stage == naga::ShaderStage::Fragment);
            let result = fragment.and_then(|point| point.function.result.as_ref());
            let ty = result.map(|result| &module.valid.module.types[result.ty].inner);
            let size = match ty {
                Some(naga::TypeInner::Scalar(_)) => vec![1],
                Some(naga::TypeInner::Vector { size, .. }) => vec![*size as usize],
                Some(naga::TypeInner::Struct { members, .. }) => members
                    .iter()
                    .map(|member| match module.valid.module.types[member.ty].inner {
                        naga::TypeInner::Vector { size, .. } => size as usize,
                        _ => 1,
                    })
                    .collect(),
                _ => Vec::new(),
            };
            let written = pass.row().writes.iter().map(|output| output.format.channels());
            assert_eq!(size, written.collect::<Vec<_>>(), "{pass:?}");
            if let PassWork::Screen { shader, .. } = pass.row().work {
                files.push(shader);
            }
        }
        for (path, _) in wgsl::PASSES {
            let name = path.rsplit('/').next().and_then(|file| file.strip_suffix(".wgsl"));
            assert!(name.is_some_and(|name| files.contains(&name)), "no row runs {path}");
        }
    }
}
