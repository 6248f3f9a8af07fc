//! What is handed to a driver is bounded.
//!
//! A driver compiles a shader by recursion over values that follow from one another, on a stack
//! that is not ours to size; see [`depth_of_entry_points`]. A look of so many nodes in a row is
//! drawn by the reference, which does not recurse.

use super::CompiledShader;
use crate::wgsl::depth_of_entry_points;

/// The most operations that follow from one another in a shader that is handed to a driver.
///
/// Mesa's software Vulkan (22.3, x86-64) takes up to 150 bytes of stack for each of them: so many
/// take 7.2 MiB, where threads that a program did not size itself, the driver's own among them, have
/// 8 MiB.
pub const MAX_DEPTH: u64 = 50_000;

/// What to do about a shader that is too deep.
pub const SHORTEN: &str =
    "use fewer nodes one after another, or draw with the reference: `chiaro render --on reference`";

/// Why a shader is not handed to a driver, if it is not.
pub fn too_deep(shader: &CompiledShader) -> Option<String> {
    let depth = depth_of_entry_points(&shader.valid.module);
    (depth > MAX_DEPTH).then(|| {
        format!("{depth} operations of this look follow from one another, and a driver is handed at most {MAX_DEPTH}")
    })
}
