//! What is handed to a driver is bounded.
//!
//! A driver compiles a shader by recursion over values that follow from one another; see
//! [`depth_of_entry_points`]. So a renderer hands a shader over with as much stack as that takes,
//! and one that is deeper still not at all: the reference draws such looks without recursion.

use super::CompiledShader;
use crate::wgsl::depth_of_entry_points;

/// The most operations that follow from one another in a shader that is handed to a driver.
///
/// Software Vulkan compiles machine code on threads of its own, which have 8 MiB of stack. A chain
/// of 5,000 nodes, every fourth of them a sine, has 67,485 such operations, takes between 2 and 3
/// MiB there, and 40 s; one of 6,000 mixes has 132,010 and takes less than 2 MiB.
pub const MAX_DEPTH: u64 = 160_000;

/// Bytes of stack for each operation that follows from another, above the 150 that Mesa's software
/// Vulkan takes (22.3, x86-64; 67,485 operations of a mixed chain took 3.3 MiB, 20,000 of a chain
/// of nothing but differences and absolute values 3 MiB).
const STACK_PER_OPERATION: usize = 256;

/// What to do about a shader that is too deep.
pub const SHORTEN: &str =
    "use fewer nodes one after another, or draw with the reference: `chiaro render --on reference`";

/// The bytes of stack that a driver is given to compile a shader.
///
/// # Errors
/// Why it is not handed over at all.
pub fn stack_of(shader: &CompiledShader) -> Result<usize, String> {
    let depth = depth_within_bound(shader)?;
    Ok(usize::try_from(depth).unwrap_or_default() * STACK_PER_OPERATION)
}

/// Why a shader is not handed to a driver, if it is not.
pub fn too_deep(shader: &CompiledShader) -> Option<String> {
    depth_within_bound(shader).err()
}

fn depth_within_bound(shader: &CompiledShader) -> Result<u64, String> {
    let depth = depth_of_entry_points(&shader.valid.module);
    if depth <= MAX_DEPTH {
        return Ok(depth);
    }
    Err(format!(
        "{depth} operations of this look follow from one another, and a driver is handed at most \
         {MAX_DEPTH}"
    ))
}
