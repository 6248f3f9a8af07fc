//! Textures of the look as Godot imports them: pictures, each with the settings of its import.
//!
//! A painted surface has layers, and Godot's importer of `Texture2DArray` cuts them from a picture.
//! The package has them as a PNG, one below the other: the smallest file of those that Godot takes,
//! exact, and one that every viewer shows. Blocks of BC7 are decoded there, because the importer
//! would compress its own again.

use chiaro_locale::tr;

use super::super::{ExportFile, refusal};
use crate::diag::Diagnostic;
use crate::hcbtf::{BytePicture, ktx2};

/// Greatest number of pixels of a picture in Godot.
const MOST_PIXELS: u64 = 1 << 28;

/// Ending of a texture of layers, as every package is given it.
const LAYERED: &str = ".ktx2";

/// The files of a look's textures: each picture, and the settings of its import.
///
/// # Errors
/// A painted surface that is too large for Godot.
pub(super) fn files(textures: &[ExportFile]) -> Result<Vec<ExportFile>, Diagnostic> {
    let mut files = Vec::new();
    for texture in textures {
        let (picture, settings) = match texture.name.ends_with(LAYERED) {
            true => layered(texture)?,
            false => (texture.clone(), import(&texture.name, FLAT)),
        };
        files.push(ExportFile::text(format!("{}.import", picture.name), settings));
        files.push(picture);
    }
    Ok(files)
}

/// The name of a texture's picture, and the type that Godot has for the texture.
pub(super) fn picture_of(texture: &str) -> (String, &'static str) {
    match texture.strip_suffix(LAYERED) {
        Some(own) => (format!("{own}.layers.png"), "Texture2DArray"),
        None => (texture.to_owned(), "Texture2D"),
    }
}

/// The picture of a painted surface, and the settings of its import.
fn layered(texture: &ExportFile) -> Result<(ExportFile, String), Diagnostic> {
    let (name, _) = picture_of(&texture.name);
    let layers = ktx2::read(&texture.bytes, &texture.name)?;
    let [width, height] = layers.size;
    let pixels = [width, height, layers.count].into_iter().map(u64::from).product::<u64>();
    if pixels > MOST_PIXELS {
        let message = tr!(
            "a painted surface of the look has {count} million texels, and pictures of Godot have \
             at most {most} million",
            count = pixels / 1_000_000,
            most = MOST_PIXELS / 1_000_000
        );
        return Err(refusal(message, tr!("export it with `--textures compact`")));
    }
    let size = [width, height * layers.count];
    let picture = BytePicture { size, rgba: layers.rgba().into_owned() };
    let bytes = picture.to_png().map_err(|problem| *problem)?;
    let settings = import(&name, LAYERS) + &format!("slices/vertical={}\n", layers.count);
    Ok((ExportFile { name, bytes }, settings))
}

/// Importer of a flat image, its type, and its settings: pixels as they are.
const FLAT: [&str; 3] = [
    "texture",
    "CompressedTexture2D",
    "compress/mode=0\nmipmaps/generate=false\nprocess/fix_alpha_border=false\n\
     process/premult_alpha=false\ndetect_3d/compress_to=0\n",
];

/// The same for layers. They are kept uncompressed (3), which makes them all of one format:
/// lossless ones (0) lose an alpha that is 1 all over, each layer by itself.
const LAYERS: [&str; 3] = [
    "2d_array_texture",
    "CompressedTexture2DArray",
    "compress/mode=3\nmipmaps/generate=false\nslices/horizontal=1\n",
];

/// Settings of the import of a file.
fn import(file: &str, [importer, ty, settings]: [&str; 3]) -> String {
    format!(
        "[remap]\n\nimporter=\"{importer}\"\ntype=\"{ty}\"\n\n[deps]\n\n\
         source_file=\"res://{file}\"\n\n[params]\n\n{settings}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hcbtf::{LayeredTexture, TexelCoding};

    #[test]
    fn layers_lie_below_each_other_in_a_picture() {
        let bytes: Vec<u8> = (0..2 * 3 * 4 * 5).collect();
        let layers = LayeredTexture {
            size: [2, 3],
            count: 5,
            coding: TexelCoding::Rgba8,
            bytes: bytes.clone(),
        };
        let texture = ExportFile { name: "a.b.ktx2".to_owned(), bytes: ktx2::write(&layers) };
        let files = files(&[texture]).expect("a small texture");
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        assert_eq!(names, ["a.b.layers.png.import", "a.b.layers.png"]);
        let settings = String::from_utf8_lossy(&files[0].bytes).into_owned();
        assert!(settings.contains("importer=\"2d_array_texture\""), "{settings}");
        assert!(settings.ends_with("slices/horizontal=1\nslices/vertical=5\n"), "{settings}");
        let picture = image::load_from_memory(&files[1].bytes).expect("a PNG").into_rgba8();
        assert_eq!((picture.dimensions(), picture.into_raw()), ((2, 15), bytes));
    }
}
