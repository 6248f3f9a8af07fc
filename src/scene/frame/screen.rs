//! The modules of passes over the whole picture, ready to be run, with the resource of each
//! binding.

use chiaro_locale::tr;

use super::camera::View;
use super::plan::FramePlan;
use crate::diag::Diagnostic;
use crate::document::SceneOutlines;
use crate::library::{PassId, PassInput, PassWork};
use crate::wgsl::{self, ValidModule};

/// The module of a pass over the whole picture.
#[derive(Debug)]
pub struct ScreenModule {
    /// Source of the module, in WGSL.
    pub text: String,
    /// The module as naga validated it.
    pub valid: ValidModule,
    /// Bindings, all in group 0.
    pub bindings: Vec<ScreenBinding>,
}

/// A binding of a pass's module.
#[derive(Clone, Debug)]
pub struct ScreenBinding {
    /// Number of the binding.
    pub binding: u32,
    /// Resource of the binding.
    pub holds: ScreenResource,
}

/// Resource of a binding of a pass's module.
#[derive(Clone, Debug)]
pub enum ScreenResource {
    /// A result of an earlier pass.
    Image(PassImage),
    /// The numbers of the view that the module's uniform asks for, in the order of its members.
    Numbers(Vec<&'static ViewNumber>),
}

/// Number of the view that the uniform of a pass over the picture may ask for, by the name of a
/// member.
#[derive(Debug)]
pub struct ViewNumber {
    /// Name of the member.
    pub name: &'static str,
    /// Description for hosts that run an exported pass.
    pub meaning: &'static str,
    /// Value for images whose first row is at the top.
    value: fn(&ScreenState<'_>) -> f64,
}

/// State that the numbers of passes over the picture are made from.
struct ScreenState<'a> {
    view: &'a View,
    /// Samples a pixel of the picture.
    samples: u32,
    ink: Ink,
}

/// Lines over the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ink {
    /// Straight RGBA in display colors.
    pub color: [f64; 4],
    /// Widths in pixels: of silhouettes, creases, borders of objects, of materials and of ids.
    pub widths: [f64; 5],
}

impl Ink {
    /// The lines of a scene in a picture of so many rows; `None` where it draws none.
    pub fn of(outlines: &SceneOutlines, height: u32) -> Option<Self> {
        let pixels = 0.001 * f64::from(height);
        let widths = outlines.widths().map(|width| width * pixels);
        outlines.are_drawn().then_some(Self { color: outlines.color, widths })
    }
}

/// All numbers of the view that passes over the picture may ask for.
const VIEW_NUMBERS: &[ViewNumber] = &[
    ViewNumber {
        name: "pixel",
        meaning: "a pixel's size in scene units: at depth 1 for perspective, at every depth for \
                  parallel projection",
        value: |state| state.view.pixel_size(),
    },
    ViewNumber {
        name: "perspective",
        meaning: "1 for perspective, 0 for parallel projection",
        value: |state| f64::from(u8::from(state.view.is_perspective)),
    },
    ViewNumber {
        name: "viewport_height",
        meaning: "in pixels",
        value: |state| f64::from(state.view.viewport[1]),
    },
    ViewNumber {
        name: "rows_up",
        meaning: "1 where the API's `first_row` is bottom, 0 where it is top",
        value: |_| 0.0,
    },
    ViewNumber {
        name: "samples",
        meaning: "samples a pixel of the picture",
        value: |state| f64::from(state.samples),
    },
    ViewNumber {
        name: "ink_red",
        meaning: "of the color of lines",
        value: |state| state.ink.color[0],
    },
    ViewNumber {
        name: "ink_green",
        meaning: "of the color of lines",
        value: |state| state.ink.color[1],
    },
    ViewNumber {
        name: "ink_blue",
        meaning: "of the color of lines",
        value: |state| state.ink.color[2],
    },
    ViewNumber {
        name: "ink_alpha",
        meaning: "of the color of lines",
        value: |state| state.ink.color[3],
    },
    ViewNumber {
        name: "silhouette_width",
        meaning: "in pixels",
        value: |state| state.ink.widths[0],
    },
    ViewNumber { name: "crease_width", meaning: "in pixels", value: |state| state.ink.widths[1] },
    ViewNumber { name: "border_width", meaning: "in pixels", value: |state| state.ink.widths[2] },
    ViewNumber {
        name: "material_border_width",
        meaning: "in pixels",
        value: |state| state.ink.widths[3],
    },
    ViewNumber {
        name: "id_border_width",
        meaning: "in pixels",
        value: |state| state.ink.widths[4],
    },
];

impl ViewNumber {
    /// The number that a member of this name asks for.
    pub fn named(name: &str) -> Option<&'static Self> {
        VIEW_NUMBERS.iter().find(|number| number.name == name)
    }
}

impl FramePlan {
    /// Values of numbers that a pass over the picture asks for, for images whose first row is at
    /// the top.
    pub fn numbers(&self, wanted: &[&ViewNumber]) -> Vec<f64> {
        let ink = self.ink.unwrap_or_default();
        let state = ScreenState { view: &self.view, samples: self.samples, ink };
        wanted.iter().map(|number| (number.value)(&state)).collect()
    }
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
                let numbers = view_numbers(&valid.module, variable.ty);
                ScreenResource::Numbers(numbers.map_err(wrong)?)
            } else {
                let input = pass.row().reads.iter().find(|input| input.binding == name);
                let image = input.and_then(PassImage::read);
                ScreenResource::Image(image.ok_or_else(|| {
                    wrong(tr!(
                        "the row of `{pass}` does not say what `{name}` is",
                        pass = pass.row().slug
                    ))
                })?)
            };
            bindings.push(ScreenBinding { binding: at.binding, holds });
        }
        Ok(Some(Self { text, valid, bindings }))
    }
}

/// The numbers that the members of a uniform's struct ask for.
fn view_numbers(
    module: &naga::Module,
    ty: naga::Handle<naga::Type>,
) -> Result<Vec<&'static ViewNumber>, String> {
    let naga::TypeInner::Struct { members, .. } = &module.types[ty].inner else {
        return Err(tr!("its uniform is no struct").to_owned());
    };
    let number = |(index, member): (usize, &naga::StructMember)| {
        let name = member.name.as_deref().unwrap_or_default();
        let is_number = module.types[member.ty].inner == naga::TypeInner::Scalar(naga::Scalar::F32)
            && member.offset as usize == 4 * index;
        if !is_number {
            return Err(tr!("`{name}` is no f32 right after the member before it"));
        }
        ViewNumber::named(name).ok_or_else(|| tr!("no number of the view is `{name}`"))
    };
    members.iter().enumerate().map(number).collect()
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
        files.extend(PassId::all().filter_map(|pass| match pass.row().work {
            PassWork::Lights { shader } => Some(shader),
            _ => None,
        }));
        for (path, _) in wgsl::PASSES {
            let name = path.rsplit('/').next().and_then(|file| file.strip_suffix(".wgsl"));
            assert!(name.is_some_and(|name| files.contains(&name)), "no row runs {path}");
        }
    }
}
