//! Outside compilers, by the endings of exported files.

use std::path::Path;

use crate::support::validators::{ShaderStage, glslang, hlsl, slang, spirv_val};

/// The verdict of the compiler that judges files of an ending; `None` for files that none judges,
/// and for WGSL, which Tint is given all at once.
pub(crate) fn verdict(name: &str, bytes: &[u8]) -> Option<Result<(), String>> {
    let text = String::from_utf8_lossy(bytes);
    let ending = Path::new(name).extension()?.to_string_lossy();
    Some(match &*ending {
        "vert" => glslang(&text, ShaderStage::Vertex, &[]),
        "frag" => glslang(&text, ShaderStage::Fragment, &[]),
        "spv" => spirv_val(bytes, "vulkan1.1"),
        "hlsl" => hlsl(&text),
        "slang" => slang(&text),
        _ => return None,
    })
}
