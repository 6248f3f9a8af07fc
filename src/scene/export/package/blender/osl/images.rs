//! Images of the look as functions of the shader.
//!
//! Renderers filter textures each in its own way, so the shader filters them itself, of the four
//! texels around a place. The WGSL calls a function for each image; its text is written here.

use super::super::super::{PackageRequest, refusal};
use crate::diag::Diagnostic;
use crate::document::ColorSpace;
use crate::export::modules::{ExportImage, Feed, ShaderModule};
use crate::library::Type;
use crate::wgsl::identifiers;

/// An image that the shader reads.
#[derive(Clone, Debug)]
pub(super) struct ShaderImage {
    /// Name of the texture in WGSL.
    name: String,
    /// Name of the file beside the shader.
    file: String,
    /// Wrapping, as textures of OSL have it.
    wrap: &'static str,
    is_nearest: bool,
    /// True if texels are decoded into linear light.
    is_decoded: bool,
}

impl ShaderImage {
    /// The images that a module reads.
    ///
    /// # Errors
    /// `not-in-package`: an image that a shader of OSL cannot read, with the nodes that do.
    pub(super) fn all(
        request: &PackageRequest<'_>,
        module: &ShaderModule,
    ) -> Result<Vec<Self>, Diagnostic> {
        let mut images = Vec::new();
        for (bound, feed) in module.bindings.iter().zip(&module.feeds) {
            let Feed::Image { image } = feed else { continue };
            let image = &request.description.images[*image];
            images.push(Self::of(request, &bound.name, image)?);
        }
        Ok(images)
    }

    fn of(
        request: &PackageRequest<'_>,
        name: &str,
        image: &ExportImage,
    ) -> Result<Self, Diagnostic> {
        if image.kind == "hcbtf" {
            let message = "the look reads a painted surface, whose texels no shader of OSL finds";
            return Err(refusal_of_nodes(request, &Type::Hcbtf, message));
        }
        let file = image.file.clone().unwrap_or_default();
        let carried = request.textures.iter().find(|carried| carried.name == file);
        let decoded = carried.and_then(|it| image::load_from_memory(&it.bytes).ok());
        if decoded.is_none_or(|it| it.to_rgba8().pixels().any(|pixel| pixel.0[3] < 255)) {
            let message = "the look reads an image with transparent parts, whose colors textures \
                           of OSL lose";
            return Err(refusal_of_nodes(request, &Type::Image, message));
        }
        let wrap = match image.wrap.as_str() {
            "repeat" => "periodic",
            "mirror" => "mirror",
            _ => "clamp",
        };
        let is_decoded =
            request.look.color_space == ColorSpace::Linear && image.encoding == "color";
        let is_nearest = image.filter == "nearest";
        Ok(Self { name: name.to_owned(), file, wrap, is_nearest, is_decoded })
    }

    /// Name of the function that gives the image's color at a place.
    pub(super) fn function(&self) -> String {
        format!("{}_color", self.name)
    }

    /// The function in WGSL, whose body stands in for another.
    pub(super) fn wgsl(&self) -> String {
        format!(
            "fn {}(uv: vec2f) -> vec4f {{\n    return vec4f(uv, 0.0, 0.0);\n}}",
            self.function()
        )
    }

    /// A text of WGSL that calls the function where it read the texture; `None` where the text
    /// reads the texture in another way.
    pub(super) fn called_in(&self, text: &str) -> Option<String> {
        let name = &self.name;
        let text = text.replace(
            &format!("textureSample({name}, {name}_sampler, "),
            &format!("{}(", self.function()),
        );
        let text = text.replace(
            &format!("textureSample({name}, {name}_sampler,\n"),
            &format!("{}(\n", self.function()),
        );
        let is_read = identifiers(&text).iter().any(|word| word == name);
        (!is_read).then_some(text)
    }

    /// The text of OSL with the function as it is.
    pub(super) fn written_in(&self, text: &str) -> String {
        let head = format!("vector4 {}(vector2 uv)\n", self.function());
        let Some((before, after)) = text.split_once(&head) else { return text.to_owned() };
        let (_, rest) = after.split_once("\n}\n").unwrap_or(("", after));
        format!("{before}{}{rest}", self.osl())
    }

    /// The function in OSL, with what it calls.
    fn osl(&self) -> String {
        let Self { name, file, wrap, .. } = self;
        let texture = name.to_ascii_uppercase();
        let value = match self.is_decoded {
            true => "light_of_shown((vector)found)",
            false => "(vector)found",
        };
        let texel = format!(
            "// An image beside this file.\n\
             #define {texture} \"{file}\"\n\n\
             // A texel of the image, counted from its upper left corner.\n\
             vector4 {name}_texel(float x, float y, int size[2])\n{{\n    \
                 color found = texture({texture}, (x + 0.5) / size[0], (y + 0.5) / size[1],\n\
                 \x20       \"wrap\", \"{wrap}\", \"interp\", \"closest\");\n    \
                 vector texel = {value};\n    \
                 return vector4(texel[0], texel[1], texel[2], 1.0);\n}}\n\n"
        );
        let size =
            format!("    int size[2];\n    gettextureinfo({texture}, \"resolution\", size);\n");
        let function = self.function();
        if self.is_nearest {
            return format!(
                "{texel}// The image's color at a place.\n\
                 vector4 {function}(vector2 uv)\n{{\n{size}    \
                     return {name}_texel(floor(uv.x * size[0]), floor(uv.y * size[1]), size);\n}}\n"
            );
        }
        let row = |name_of_row: &str, y: &str| {
            format!(
                "    vector4 {name_of_row} = mix({name}_texel(left, {y}, size),\n        \
                 {name}_texel(left + 1.0, {y}, size), x - left);\n"
            )
        };
        format!(
            "{texel}// The image's color at a place, of the four texels around.\n\
             vector4 {function}(vector2 uv)\n{{\n{size}    \
                 float x = uv.x * size[0] - 0.5;\n    \
                 float y = uv.y * size[1] - 0.5;\n    \
                 float left = floor(x);\n    \
                 float top = floor(y);\n\
             {}{}    return mix(upper, lower, y - top);\n}}\n",
            row("upper", "top"),
            row("lower", "top + 1.0"),
        )
    }
}

/// The refusal of a look for what some of its nodes take.
fn refusal_of_nodes(request: &PackageRequest<'_>, ty: &Type, message: &str) -> Diagnostic {
    let nodes = request.nodes_that_take(std::slice::from_ref(ty));
    let names: Vec<String> = nodes.iter().map(|name| format!("`{name}`")).collect();
    let who = match &names[..] {
        [] => "a node reads".to_owned(),
        [one] => format!("the node {one} reads"),
        [all @ .., last] => format!("the nodes {} and {last} read", all.join(", ")),
    };
    let hint = format!(
        "{who} it: put nodes without images in their place, or render with the add-on's own \
         `render`"
    );
    refusal(message, &hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_take_the_places_of_textures() {
        let mut image = ShaderImage {
            name: "image_1".to_owned(),
            file: "tone.png".to_owned(),
            wrap: "periodic",
            is_nearest: false,
            is_decoded: false,
        };
        let read = "let a = textureSample(image_1, image_1_sampler, vec2f(t, 0.5));";
        let called = image.called_in(read);
        assert_eq!(called.as_deref(), Some("let a = image_1_color(vec2f(t, 0.5));"));
        assert_eq!(image.called_in("textureDimensions(image_1)"), None);
        let text = "int a;\nvector4 image_1_color(vector2 uv)\n{\n    return uv;\n}\nint b;\n";
        let written = image.written_in(text);
        assert!(written.starts_with("int a;\n// An image") && written.ends_with("\n}\nint b;\n"));
        for part in [
            "#define IMAGE_1 \"tone.png\"",
            "\"wrap\", \"periodic\"",
            "vector texel = (vector)found;",
        ] {
            assert!(written.contains(part), "{part}: {written}");
        }
        (image.is_nearest, image.is_decoded) = (true, true);
        let written = image.written_in(text);
        assert!(written.contains("light_of_shown") && written.contains("floor(uv.y * size[1])"));
    }
}
