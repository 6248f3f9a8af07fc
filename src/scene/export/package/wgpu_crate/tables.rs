//! The look's tables: passes with their bindings and outputs, and images.

use std::collections::BTreeSet;

use super::super::PackageRequest;
use super::super::rust::{Parameters, PassTable, Template};
use crate::document::ColorSpace;
use crate::export::description::DrawnSides;

/// Sources of the tables.
pub(super) struct Tables<'a> {
    passes: PassTable<'a>,
}

/// Feature of the crate `image` that reads a file; `None` for files that crates do not read.
pub(super) fn image_feature(file: &str) -> Option<&'static str> {
    match file.rsplit('.').next()?.to_ascii_lowercase().as_str() {
        "png" => Some("png"),
        "jpg" | "jpeg" => Some("jpeg"),
        _ => None,
    }
}

impl<'a> Tables<'a> {
    pub(super) fn of(request: &PackageRequest<'a>) -> Self {
        Self { passes: PassTable::of(request, |_| true) }
    }

    /// Fills templates with the tables, and opens the sections that they need.
    pub(super) fn fill(
        &self,
        template: &mut Template,
        request: &PackageRequest<'_>,
        parameters: &Parameters<'_>,
    ) {
        self.passes.fill(template, request, template.has("look"));
        template.place("settings_mut", if template.has("shadows") { "mut " } else { "" });
        let drawn = "(buffers.cloned().collect(), (indices, all))";
        let is_option = template.has("screen");
        template.place(
            "draw_mesh",
            if is_option { format!("Some({drawn})") } else { drawn.to_owned() },
        );
        let cuts = self.cuts(request, parameters);
        template.section("cuts", cuts.is_some());
        template.place("cuts", cuts.unwrap_or_default());
        let reads_size = ["passes", "look", "numbers"].iter().any(|name| template.has(name));
        template.place("size", if reads_size { "size" } else { "_size" });
        self.fill_images(template, request);
    }

    /// The condition under which backs are seen through what a look cuts away.
    fn cuts(&self, request: &PackageRequest<'_>, parameters: &Parameters<'_>) -> Option<String> {
        let pass = self.passes.passes().last()?;
        let member = pass.sides_parameter.and_then(|it| parameters.member_of(request, it));
        match member {
            Some(member) => Some(format!("self.parameters.{member} > 0.0")),
            None => (pass.sides == Some(DrawnSides::Both)).then(|| "true".to_owned()),
        }
    }

    fn fill_images(&self, template: &mut Template, request: &PackageRequest<'_>) {
        let images = &request.description.images;
        let is_layered = |file: &str| file.ends_with(".ktx2");
        let files: Vec<&str> = images.iter().filter_map(|image| image.file.as_deref()).collect();
        template.section("images", !files.is_empty());
        template.section("flat", files.iter().any(|file| !is_layered(file)));
        template.section("layered", files.iter().any(|file| is_layered(file)));
        let features: BTreeSet<_> = files.iter().filter_map(|file| image_feature(file)).collect();
        let features: Vec<String> = features.iter().map(|it| format!("{it:?}")).collect();
        template.place("image_features", features.join(", "));
        let (flat, layered) = (template.has("flat"), template.has("layered"));
        template.place(
            "read",
            match (flat, layered) {
                (true, true) => "read(device, image)",
                (false, _) => "read_layers(device, image)",
                (true, false) => "read_flat(image)",
            },
        );
        template.place(
            "dimension",
            if layered { "IMAGES[image].dimension" } else { "wgpu::TextureViewDimension::D2" },
        );
        // The image's number is read where a dimension depends on it.
        template.place("image_number", if layered { "image" } else { "_" });
        let has_images = template.has("images");
        template.place("and_uploads", if has_images { ", and uploads its images" } else { "" });
        template
            .place("image_errors", if has_images { "; an image that cannot be read" } else { "" });
        template.place("doc_queue_argument", if has_images { "queue, " } else { "" });
        template.place("example_queue", if has_images { "&queue, " } else { "" });
        let is_linear = request.description.color_space == ColorSpace::Linear;
        template.place("image_count", images.len().to_string());
        let mut lines = Vec::new();
        for image in images {
            let Some(file) = &image.file else { continue };
            lines.push("Image {".to_owned());
            lines.push(format!("    file: {file:?},"));
            lines.push(format!("    bytes: include_bytes!(\"images/{file}\"),"));
            if flat {
                let is_decoded = is_linear && image.encoding == "color" && !is_layered(file);
                let format = if is_decoded { "Rgba8UnormSrgb" } else { "Rgba8Unorm" };
                lines.push(format!("    format: wgpu::TextureFormat::{format},"));
            }
            if layered {
                let dimension = if is_layered(file) { "D2Array" } else { "D2" };
                lines.push(format!("    dimension: wgpu::TextureViewDimension::{dimension},"));
            }
            let wrap = match image.wrap.as_str() {
                "clamp" => "ClampToEdge",
                "mirror" => "MirrorRepeat",
                _ => "Repeat",
            };
            lines.push(format!("    wrap: wgpu::AddressMode::{wrap},"));
            let filter = if image.filter == "nearest" { "Nearest" } else { "Linear" };
            lines.push(format!("    filter: wgpu::FilterMode::{filter},"));
            lines.push("},".to_owned());
        }
        template.lines("images", lines);
    }
}
