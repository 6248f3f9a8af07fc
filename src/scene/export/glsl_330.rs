//! GLSL 3.30, for OpenGL 3.3.

use naga::back::glsl::Version;

use super::glsl;
use super::language::{ClipSpace, Language, stages};

pub(super) const LANGUAGE: Language = Language {
    slug: "glsl-330",
    label: "GLSL 3.30",
    short_label: "GLSL 3.30",
    api: "OpenGL 3.3",
    texts: stages!("330"),
    verified_by: Some("glslangValidator"),
    clip_space: ClipSpace::OPENGL,
    note: "Bind blocks and samplers by name: glUniformBlockBinding, glUniform1i.",
    write: |request| glsl::write(request, Version::Desktop(330), "330"),
};
