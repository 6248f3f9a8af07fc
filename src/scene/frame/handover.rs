//! Bound of the shaders that are handed to a driver.
//!
//! A driver compiles a shader by recursion over values that follow from one another; see
//! [`depth_of_entry_points`]. So a renderer hands a shader over with as much stack as its depth
//! takes, and does not hand over a shader that is deeper still: the reference draws such looks
//! without recursion.

use chiaro_locale::{Text, text, tr};

use super::CompiledShader;
use crate::wgsl::depth_of_entry_points;

/// Greatest depth of a shader that is handed to a driver, in operations that follow from one
/// another.
///
/// Software Vulkan compiles machine code on threads of its own, which have 8 MiB of stack. A chain
/// of 5,000 nodes, every fourth of them a sine, has 67,485 such operations, takes between 2 and 3
/// MiB there, and 40 s; one of 6,000 mixes has 132,010 and takes less than 2 MiB.
pub const MAX_DEPTH: u64 = 160_000;

/// Stack for each operation of a shader's depth, in bytes; above the 150 that Mesa's software
/// Vulkan takes (22.3, x86-64; 67,485 operations of a mixed chain took 3.3 MiB, 20,000 of a chain
/// of nothing but differences and absolute values 3 MiB).
const STACK_PER_OPERATION: usize = 256;

/// Hint for a shader that is too deep.
pub const SHORTEN: Text = text!(
    "use fewer nodes one after another, or draw with the reference: `chiaro render --on reference`"
);

/// The stack that a driver is given to compile a shader, in bytes.
///
/// # Errors
/// The reason why the shader is not handed over at all.
pub fn stack_of(shader: &CompiledShader) -> Result<usize, String> {
    let depth = depth_within_bound(shader)?;
    Ok(usize::try_from(depth).unwrap_or_default() * STACK_PER_OPERATION)
}

/// The reason why a shader is not handed to a driver; `None` if it is.
pub fn too_deep(shader: &CompiledShader) -> Option<String> {
    depth_within_bound(shader).err()
}

fn depth_within_bound(shader: &CompiledShader) -> Result<u64, String> {
    let depth = depth_of_entry_points(&shader.valid.module);
    if depth <= MAX_DEPTH {
        return Ok(depth);
    }
    Err(tr!(
        "{depth} operations of this look follow from one another, and a driver is handed at most \
         {MAX_DEPTH}"
    ))
}
