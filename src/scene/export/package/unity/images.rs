//! Images of the look as textures of a material.
//!
//! A flat image is a texture of its own, whose import settings say how it is sampled. A painted
//! surface is many layers, which Unity imports no file of: its KTX2 file comes as bytes, of which
//! the component makes an array of textures.

use std::fmt::Write as _;

use chiaro_locale::tr;

use super::parameters::{ComponentField, free_name, quoted};
use super::source::SourceImage;
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use crate::export::ExportFile;
use crate::export::description::ExportImage;
use crate::export::package::PackageRequest;
use crate::export::package::stable_id::stable_id;

/// The function of a component that reads a painted surface.
const LAYERS: &str = include_str!("Layers.cs");

/// An image of the look in the package.
#[derive(Clone, Debug)]
pub(super) struct UnityImage<'a> {
    /// Name of the property, such as `_tone_air`.
    pub(super) property: &'a str,
    /// Name of the component's field, such as `toneAir`.
    pub(super) field: String,
    /// File of the package; none where the image could not be read.
    pub(super) file: Option<String>,
    /// The image and how it is sampled.
    image: &'a ExportImage,
    /// True for a painted surface.
    is_painted: bool,
}

/// The images, in the order of the look's bindings. No field is called as one of `fields` is.
pub(super) fn images<'a>(
    request: &PackageRequest<'a>,
    images: &'a [SourceImage],
    fields: &[ComponentField],
) -> Vec<UnityImage<'a>> {
    let mut found: Vec<UnityImage<'a>> = Vec::new();
    for image in images {
        let Some(described) = request.description.images.get(image.image) else { continue };
        let is_taken = |name: &str| {
            fields.iter().any(|field| field.name == name)
                || found.iter().any(|other| other.field == name)
        };
        let field = free_name(image.texture.trim_start_matches('_'), is_taken, request);
        let file = described.file.as_ref().map(|file| {
            if image.is_painted {
                return format!("{file}.bytes");
            }
            // A texture is sampled in one way: another needs a file of its own.
            let differs = |other: &UnityImage<'_>| {
                other.image.file == described.file
                    && settings_of(other.image) != settings_of(described)
            };
            match found.iter().filter(|other| differs(other)).count() {
                0 => file.clone(),
                count => numbered(file, count + 1),
            }
        });
        found.push(UnityImage {
            property: &image.texture,
            field,
            file,
            image: described,
            is_painted: image.is_painted,
        });
    }
    found
}

/// Settings that a texture's import decides.
fn settings_of(image: &ExportImage) -> [&str; 3] {
    [&image.wrap, &image.filter, &image.encoding]
}

/// `rim.stroke-2.png` of `rim.stroke.png`.
fn numbered(file: &str, number: usize) -> String {
    let (stem, ending) = file.rsplit_once('.').unwrap_or((file, "png"));
    format!("{stem}-{number}.{ending}")
}

/// Files of the images with their import settings.
pub(super) fn files(request: &PackageRequest<'_>, images: &[UnityImage<'_>]) -> Vec<ExportFile> {
    let mut files: Vec<ExportFile> = Vec::new();
    for image in images {
        let (Some(name), Some(own)) = (&image.file, &image.image.file) else { continue };
        let texture = request.textures.iter().find(|texture| texture.name == *own);
        let Some(texture) = texture.filter(|_| files.iter().all(|file| file.name != *name)) else {
            continue;
        };
        files.push(ExportFile { name: name.clone(), bytes: texture.bytes.clone() });
        if !image.is_painted {
            files.push(import(request, image, name));
        }
    }
    files
}

/// Import settings of a flat image: one level, without compression, sampled as the look asks.
fn import(request: &PackageRequest<'_>, image: &UnityImage<'_>, name: &str) -> ExportFile {
    let wrap = match image.image.wrap.as_str() {
        "repeat" => 0,
        "mirror" => 2,
        _ => 1,
    };
    let filter = i32::from(image.image.filter != "nearest");
    let is_linear = request.look.color_space == ColorSpace::Linear;
    let is_decoded = i32::from(is_linear && image.image.encoding == "color");
    let text = format!(
        "fileFormatVersion: 2\nguid: {}\nTextureImporter:\n  serializedVersion: 13\n  \
         mipmaps:\n    enableMipMap: 0\n    sRGBTexture: {is_decoded}\n  isReadable: 0\n  \
         textureSettings:\n    \
         serializedVersion: 2\n    filterMode: {filter}\n    aniso: 0\n    mipBias: 0\n    \
         wrapU: {wrap}\n    wrapV: {wrap}\n    wrapW: {wrap}\n  nPOTScale: 0\n  alphaUsage: 1\n  \
         alphaIsTransparency: 0\n  textureType: 0\n  textureShape: 1\n  maxTextureSize: 16384\n  \
         textureCompression: 0\n  platformSettings:\n  - serializedVersion: 4\n    \
         buildTarget: DefaultTexturePlatform\n    maxTextureSize: 16384\n    \
         textureFormat: -1\n    textureCompression: 0\n",
        stable_id(request.stem, name)
    );
    ExportFile::text(format!("{name}.meta"), text)
}

/// The component's file by which Unity knows it, with what a new component has in its fields.
pub(super) fn component_meta(stem: &str, name: &str, images: &[UnityImage<'_>]) -> ExportFile {
    let mut text = format!(
        "fileFormatVersion: 2\nguid: {}\nMonoImporter:\n  externalObjects: {{}}\n  \
         serializedVersion: 2\n  defaultReferences:\n",
        stable_id(stem, name)
    );
    for (field, reference) in references(stem, images) {
        let _ = writeln!(text, "  - {field}: {reference}");
    }
    text += "  executionOrder: 0\n  icon: {instanceID: 0}\n";
    ExportFile::text(format!("{name}.meta"), text)
}

/// Fields of the component that name files of the package: the field, and the file as Unity's own
/// files name it.
pub(super) fn references(stem: &str, images: &[UnityImage<'_>]) -> Vec<(String, String)> {
    // Numbers of the main object of each kind of file.
    let reference =
        |id: u32, file: &str| format!("{{fileID: {id}, guid: {}, type: 3}}", stable_id(stem, file));
    let mut found = vec![("shader".to_owned(), reference(4_800_000, &format!("{stem}.shader")))];
    for image in images {
        let Some(file) = &image.file else { continue };
        let id = if image.is_painted { 4_900_000 } else { 2_800_000 };
        found.push((image.field.clone(), reference(id, file)));
    }
    found
}

/// The shader's properties of the images.
pub(super) fn properties(images: &[UnityImage<'_>]) -> String {
    let line = |image: &UnityImage<'_>| {
        let (kind, none) = if image.is_painted { ("2DArray", "") } else { ("2D", "white") };
        format!(
            "        [NoScaleOffset] {} ({}, {kind}) = \"{none}\" {{}}\n",
            image.property,
            quoted(&super::plain(&image.image.path))
        )
    };
    images.iter().map(line).collect()
}

/// The component's fields of the images.
pub(super) fn fields(images: &[UnityImage<'_>]) -> String {
    let mut text = String::new();
    for (index, image) in images.iter().enumerate() {
        if index == 0 {
            text += "        [Header(\"Images\")]\n";
        }
        let path = &image.image.path;
        let (ty, help) = if image.is_painted {
            ("TextAsset", format!("The painted surface, `{path}` in the look."))
        } else {
            ("Texture", format!("The image `{path}` of the look; any other may take its place."))
        };
        let _ = write!(
            text,
            "        [Tooltip({})]\n        public {ty} {};\n\n",
            quoted(&help),
            image.field
        );
    }
    text
}

/// The statements that give the material its images.
pub(super) fn set(images: &[UnityImage<'_>]) -> String {
    let line = |image: &UnityImage<'_>| {
        let value =
            if image.is_painted { format!("Layers({})", image.field) } else { image.field.clone() };
        format!("            material.SetTexture(\"{}\", {value});\n", image.property)
    };
    images.iter().map(line).collect()
}

/// The function that reads painted surfaces, where there are some.
pub(super) fn layers(images: &[UnityImage<'_>]) -> String {
    let Some(image) = images.iter().find(|image| image.is_painted) else { return String::new() };
    let filter = if image.image.filter == "nearest" { "Point" } else { "Bilinear" };
    LAYERS.replace("{{filter}}", filter)
}

/// Text before the look's functions: a function that turns places in images around.
const FROM_BELOW: &str = "/// A place in an image of Unity, whose rows run up.
float2 from_below(float2 place)
{
    return float2(place.x, 1.0 - place.y);
}

";

/// The text with places in flat images from their lower left corner, where Unity's begin. Layers of
/// a painted surface lie as they are.
pub(super) fn from_below(text: &str) -> Result<String, Diagnostic> {
    let mut result = String::with_capacity(text.len());
    let mut rest = text;
    let mut is_called = false;
    while let Some(at) = [".Sample(", ".SampleGrad("].iter().filter_map(|it| rest.find(it)).min() {
        let open = at + rest[at..].find('(').unwrap_or_default() + 1;
        let lost =
            || Diagnostic::error("export-failed", tr!("an image is read in an unknown form"));
        let first = argument(&rest[open..]).ok_or_else(lost)?;
        let start = open + first.len() + 1;
        let place = argument(&rest[start..]).ok_or_else(lost)?;
        result += &rest[..start];
        result.push(' ');
        match turned(place.trim()) {
            Some(turned) => result += &turned,
            None => {
                is_called = true;
                let _ = write!(result, "from_below({})", place.trim());
            }
        }
        rest = &rest[start + place.len()..];
    }
    result += rest;
    if !is_called {
        return Ok(result);
    }
    // Before the first function and its comment.
    let function = result.find("\n{\n").map(|at| result[..at].rfind("\n\n").unwrap_or_default());
    let at = function.map_or(0, |at| at + 2);
    result.insert_str(at, FROM_BELOW);
    Ok(result)
}

/// The first argument of a list, up to its comma or the end of the list.
fn argument(list: &str) -> Option<&str> {
    let mut depth = 0_usize;
    for (at, c) in list.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ',' | ')' if depth == 0 => return Some(&list[..at]),
            ')' | ']' => depth = depth.checked_sub(1)?,
            _ => {}
        }
    }
    None
}

/// `float2(x, y)` of `float2(x, 1.0 - y)`; `None` for places of another form.
fn turned(place: &str) -> Option<String> {
    let list = place.strip_prefix("float2(")?;
    let x = argument(list)?;
    let rest = list.get(x.len() + 1..)?;
    let y = argument(rest)?;
    let is_whole = rest.get(y.len()..) == Some(")");
    let y = y.trim().strip_prefix("1.0 - ")?;
    let is_name = y.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '.');
    (is_whole && is_name).then(|| format!("float2({}, {y})", x.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_from_below() {
        let text = "/// Look.\nfloat4 f()\n{\n    a.Sample(s, float2(x.u, 1.0 - x.v)) + \
                    a.SampleGrad(s,\n        g(b, c), gx, gy) + sheet.SampleLevel(s, p, 0.0);\n}\n";
        let found = from_below(&format!("float x;\n\n{text}")).expect("a text");
        assert!(found.contains("a.Sample(s, float2(x.u, x.v)) + "), "{found}");
        assert!(found.contains("a.SampleGrad(s, from_below(g(b, c)), gx, gy)"), "{found}");
        assert!(found.contains("sheet.SampleLevel(s, p, 0.0)"), "{found}");
        assert!(found.starts_with(&format!("float x;\n\n{FROM_BELOW}/// Look.\n")), "{found}");
        assert_eq!(turned("float2(x, 1.0 - a + b)"), None);
    }

    #[test]
    fn files_are_numbered_before_their_ending() {
        assert_eq!(numbered("rim.stroke.png", 2), "rim.stroke-2.png");
    }
}
