//! SPIR-V modules: counting of instructions, and optimization.

use std::process::Command;

/// Number of instructions of a SPIR-V module from its first function on.
pub(crate) fn instructions(words: &[u32]) -> usize {
    const OP_FUNCTION: u32 = 54;
    let (mut at, mut count) = (5, 0);
    while let Some(word) = words.get(at) {
        if count > 0 || word & 0xffff == OP_FUNCTION {
            count += 1;
        }
        at += ((word >> 16) as usize).max(1);
    }
    count
}

/// The module that `spirv-opt -O` makes of a module; `None` if it is not installed.
pub(crate) fn optimized(words: &[u32]) -> Option<Vec<u32>> {
    let folder = tempfile::tempdir().ok()?;
    let [before, after] = ["before.spv", "after.spv"].map(|name| folder.path().join(name));
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    std::fs::write(&before, bytes).ok()?;
    let ran =
        Command::new("spirv-opt").arg("-O").arg(&before).arg("-o").arg(&after).status().ok()?;
    let bytes = ran.success().then(|| std::fs::read(after).ok()).flatten()?;
    let word = |bytes: &[u8]| Some(u32::from_le_bytes(bytes.try_into().ok()?));
    bytes.chunks_exact(4).map(word).collect()
}
