//! Images of the look as textures of a material.
//!
//! A flat image is imported as it is. A painted surface is an array of textures, of which Unreal
//! imports DDS files. The material has a texture for each as a parameter; a Custom node hands them
//! to the look as arguments, for its functions have no variables of that kind.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use chiaro_locale::tr;

use super::pieces::HlslDeclaration;
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use crate::export::ExportFile;
use crate::export::description::ExportImage;
use crate::export::package::unity::source::SourceImage;
use crate::export::package::{PackageRequest, refusal};

/// An image of the look in the package.
#[derive(Clone, Debug)]
pub(super) struct UnrealImage<'a> {
    /// Name of the texture in the look, of the input of the node and of the parameter.
    pub(super) texture: String,
    /// Name of the sampler, which Unreal makes of the input's name.
    pub(super) sampler: String,
    /// File of the package.
    pub(super) file: String,
    /// True for the layers of a painted surface.
    pub(super) is_painted: bool,
    /// The image and how it is sampled.
    image: &'a ExportImage,
}

/// The images, in the order of the look's bindings.
///
/// # Errors
/// - `not-in-package`: an image that could not be read, or that is sampled in two ways.
pub(super) fn images<'a>(
    request: &PackageRequest<'a>,
    images: &[SourceImage],
) -> Result<Vec<UnrealImage<'a>>, Diagnostic> {
    let mut found: Vec<UnrealImage<'a>> = Vec::new();
    for image in images {
        let Some(described) = request.description.images.get(image.image) else { continue };
        let Some(file) = &described.file else {
            return Err(refusal(
                tr!("the image `{image}` cannot be read", image = described.path),
                tr!("put the file where the look says, and export again"),
            ));
        };
        let file = match file.strip_suffix(".ktx2") {
            Some(stem) => format!("{stem}.dds"),
            None => file.clone(),
        };
        let ways = |image: &ExportImage| {
            [image.wrap.clone(), image.filter.clone(), image.encoding.clone()]
        };
        if found.iter().any(|it| it.file == file && ways(it.image) != ways(described)) {
            return Err(refusal(
                tr!("the image `{image}` is sampled in two ways", image = described.path),
                tr!("give one of its nodes a copy of the file"),
            ));
        }
        found.push(UnrealImage {
            texture: image.texture.clone(),
            sampler: image.sampler.clone(),
            file,
            is_painted: image.is_painted,
            image: described,
        });
    }
    Ok(found)
}

impl UnrealImage<'_> {
    /// Name of the asset that Unreal makes of the file.
    pub(super) fn asset(&self) -> String {
        let stem = self.file.rsplit_once('.').map_or(self.file.as_str(), |(stem, _)| stem);
        stem.chars().map(|c| if c.is_alphanumeric() || c == '-' { c } else { '_' }).collect()
    }

    /// Class of the asset.
    pub(super) fn asset_class(&self) -> &'static str {
        if self.is_painted { "Texture2DArray" } else { "Texture2D" }
    }

    /// True if colors are decoded to linear light as they are read.
    pub(super) fn is_decoded(&self, space: ColorSpace) -> bool {
        !self.is_painted && space == ColorSpace::Linear && self.image.encoding == "color"
    }

    /// Parameters of functions: the texture and its sampler.
    pub(super) fn heads(&self) -> [String; 2] {
        [
            format!("{}<float4> {}", self.asset_class(), self.texture),
            format!("SamplerState {}", self.sampler),
        ]
    }
}

/// Files of the images.
pub(super) fn files(request: &PackageRequest<'_>, images: &[UnrealImage<'_>]) -> Vec<ExportFile> {
    let mut files: Vec<ExportFile> = Vec::new();
    for image in images {
        let own = image.image.file.as_deref().unwrap_or_default();
        let Some(texture) = request.textures.iter().find(|texture| texture.name == own) else {
            continue;
        };
        if files.iter().any(|file| file.name == image.file) {
            continue;
        }
        let bytes =
            if image.is_painted { dds(&texture.bytes) } else { Some(texture.bytes.clone()) };
        files.extend(bytes.map(|bytes| ExportFile { name: image.file.clone(), bytes }));
    }
    files
}

/// A DDS file of the layers of a KTX2 file, RGBA of 8 bits with one level; `None` for another form.
fn dds(ktx2: &[u8]) -> Option<Vec<u8>> {
    let word = |at: usize| {
        let bytes = ktx2.get(at..at + 4)?.try_into().ok()?;
        Some(u32::from_le_bytes(bytes))
    };
    let (width, height, layers) = (word(20)?, word(24)?, word(32)?.max(1));
    let (start, size) = (word(80)? as usize, word(88)? as usize);
    let texels = ktx2.get(start..start.checked_add(size)?)?;
    let mut words = [0_u32; 37];
    words[0] = u32::from_le_bytes(*b"DDS ");
    // The header's size, and flags: size, row length and pixel format are given.
    words[1..6].copy_from_slice(&[124, 0x100f, height, width, 4 * width]);
    // Depth and number of levels.
    words[6..8].copy_from_slice(&[1, 1]);
    // The pixel format says that another header follows.
    words[19..22].copy_from_slice(&[32, 4, u32::from_le_bytes(*b"DX10")]);
    words[27] = 0x1000;
    // R8G8B8A8_UNORM, of two dimensions, an array, alpha straight.
    words[32..37].copy_from_slice(&[28, 3, 0, layers, 1]);
    let header = words.iter().flat_map(|word| word.to_le_bytes());
    Some(header.chain(texels.iter().copied()).collect())
}

/// Steps that bring images in, for the text of one screen; empty without images.
pub(super) fn steps(images: &[UnrealImage<'_>], space: ColorSpace) -> String {
    if images.is_empty() {
        return String::new();
    }
    let mut text = "The look reads images. Before the material is pasted, import them into the \
                    folder *Content/Chiaro*,\nwhere its parameters find them, and set in their \
                    details *Compression*:\n*VectorDisplacementmap*, *Mip Gen Settings*: \
                    *NoMipmaps*, and:\n\n| file | sRGB | Filter | Tiling |\n\
                    | --- | --- | --- | --- |\n"
        .to_owned();
    let mut files = BTreeSet::new();
    for image in images.iter().filter(|image| files.insert(image.file.clone())) {
        let decoded = if image.is_decoded(space) { "on" } else { "off" };
        let filter = if image.image.filter == "nearest" { "Nearest" } else { "Bi-linear" };
        let wrap = match image.image.wrap.as_str() {
            "repeat" => "Wrap",
            "mirror" => "Mirror",
            _ => "Clamp",
        };
        let _ = writeln!(text, "| `{}` | {decoded} | {filter} | {wrap} |", image.file);
    }
    text + "\n"
}

/// Gives images to the functions that read them, and to those that call these, as parameters; their
/// declarations go. Names of the functions.
pub(super) fn handed_on(
    declarations: &mut Vec<HlslDeclaration>,
    images: &[UnrealImage<'_>],
) -> BTreeSet<String> {
    let names: BTreeSet<&str> =
        images.iter().flat_map(|image| [image.texture.as_str(), image.sampler.as_str()]).collect();
    declarations.retain(|it| !names.contains(it.name.as_str()));
    let mut readers: BTreeSet<String> = BTreeSet::new();
    loop {
        let reads = |it: &&HlslDeclaration| {
            let code = it.text.lines().filter(|line| !line.trim_start().starts_with("//"));
            let mut words =
                code.flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'));
            words.any(|word| names.contains(word) || readers.contains(word))
        };
        let now: BTreeSet<String> =
            declarations.iter().filter(reads).map(|it| it.name.clone()).collect();
        if now == readers {
            break;
        }
        readers = now;
    }
    let heads: Vec<String> = images.iter().flat_map(UnrealImage::heads).collect();
    let values = arguments(images);
    for declaration in declarations.iter_mut().filter(|it| readers.contains(&it.name)) {
        let mut text = declaration.text.clone();
        for reader in &readers {
            let is_own = *reader == declaration.name;
            text = with_arguments(&text, reader, if is_own { &heads } else { &values });
        }
        declaration.text = text;
    }
    readers
}

/// Arguments of a call: the textures and their samplers.
pub(super) fn arguments(images: &[UnrealImage<'_>]) -> Vec<String> {
    images.iter().flat_map(|image| [image.texture.clone(), image.sampler.clone()]).collect()
}

/// The text with more arguments at the end of each list of a function.
fn with_arguments(text: &str, function: &str, more: &[String]) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(&format!("{function}(")) {
        let open = at + function.len() + 1;
        let is_whole = !rest[..at].ends_with(is_part);
        result += &rest[..open];
        rest = &rest[open..];
        if !is_whole {
            continue;
        }
        let mut depth = 0_usize;
        let end = rest.find(|c: char| {
            depth += usize::from(c == '(');
            let is_end = c == ')' && depth == 0;
            depth = depth.saturating_sub(usize::from(c == ')'));
            is_end
        });
        let end = end.unwrap_or(rest.len());
        result += &rest[..end];
        for one in more {
            let line = result.rsplit('\n').next().unwrap_or_default();
            let indent = line.len() - line.trim_start().len();
            // A line that goes on is four places further in.
            let by = if line.contains(function) { indent + 4 } else { indent };
            let is_long = line.len() + one.len() > 96;
            let _ = match is_long {
                true => write!(result, ",\n{:by$}{one}", ""),
                false => write!(result, ", {one}"),
            };
        }
        rest = &rest[end..];
    }
    result + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_get_arguments() {
        let text = "float4 shade(Surface surface)\n{\n    return g(shade(h(a), b)) + ashade(c);\n}";
        let found = with_arguments(text, "shade", &["x".to_owned(), "y".to_owned()]);
        assert_eq!(
            found,
            "float4 shade(Surface surface, x, y)\n{\n    return g(shade(h(a), b, x, y)) + \
             ashade(c);\n}"
        );
    }

    #[test]
    fn layers_of_ktx2_become_those_of_dds() {
        let mut ktx2 = vec![0_u8; 104 + 2 * 8];
        for (at, word) in [(20, 2_u32), (24, 1), (32, 2), (80, 104), (88, 16)] {
            ktx2[at..at + 4].copy_from_slice(&word.to_le_bytes());
        }
        ktx2[104] = 9;
        let found = dds(&ktx2).expect("layers");
        assert_eq!((found.len(), &found[..4], found[148]), (148 + 16, &b"DDS "[..], 9));
        assert_eq!((found[12], found[16], found[128], found[140]), (1, 2, 28, 2));
        assert_eq!(dds(&ktx2[..100]), None);
    }
}
