//! GLSL 4.50, for OpenGL 4.5.

use naga::back::glsl::Version;

use super::glsl;
use super::language::{ClipSpace, Language, stages};

pub(super) const LANGUAGE: Language = Language {
    slug: "glsl-450",
    label: "GLSL 4.50",
    short_label: "GLSL 4.50",
    api: "OpenGL 4.5",
    texts: stages!("450"),
    verified_by: Some("glslangValidator"),
    clip_space: ClipSpace::OPENGL,
    note: "For OpenGL 4.5, not for Vulkan: bindings have no sets, and depth runs from -1 to 1. For \
           Vulkan export spirv.",
    write: |request| glsl::write(request, Version::Desktop(450), "450"),
};
