//! GLSL ES 3.00, for OpenGL ES 3.0 and WebGL2.

use naga::back::glsl::Version;

use super::glsl;
use super::language::{ClipSpace, Language, stages};

pub(super) const LANGUAGE: Language = Language {
    slug: "glsl-es300",
    label: "GLSL ES 3.00",
    short_label: "GLSL ES 3.00",
    api: "WebGL 2",
    texts: stages!("es300"),
    verified_by: Some("glslangValidator"),
    clip_space: ClipSpace::OPENGL,
    note: "Bind blocks and samplers by name: glUniformBlockBinding, glUniform1i. Passes that draw \
           normals and curvature need EXT_color_buffer_float.",
    write: |request| {
        glsl::write(request, Version::Embedded { version: 300, is_webgl: false }, "es300")
    },
};
