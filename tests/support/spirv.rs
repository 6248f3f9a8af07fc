//! SPIR-V modules: counting of instructions, and optimization.

use std::collections::HashMap;
use std::process::Command;

/// Number of words before the first instruction of a module.
const HEADER: usize = 5;

const OP_ENTRY_POINT: u32 = 15;
const OP_FUNCTION: u32 = 54;
const OP_FUNCTION_PARAMETER: u32 = 55;
const OP_FUNCTION_END: u32 = 56;
const OP_FUNCTION_CALL: u32 = 57;

/// Instructions of a module: code and operands of each.
fn instructions(words: &[u32]) -> impl Iterator<Item = (u32, &[u32])> {
    let mut rest = words.get(HEADER..).unwrap_or_default();
    std::iter::from_fn(move || {
        let first = *rest.first()?;
        let length = ((first >> 16) as usize).clamp(1, rest.len());
        let (instruction, after) = rest.split_at(length);
        rest = after;
        Some((first & 0xffff, &instruction[1..]))
    })
}

/// Number of instructions of a whole module: functions, types, constants and all that describes
/// them.
pub fn module_instructions(words: &[u32]) -> usize {
    instructions(words).count()
}

/// Number of instructions of a module from its first function on.
pub fn function_instructions(words: &[u32]) -> usize {
    instructions(words).skip_while(|(code, _)| *code != OP_FUNCTION).count()
}

/// Number of instructions of a module's entry point with the called function's in the place of each
/// call: a function that is called twice counts twice, one that is not called counts nothing.
///
/// # Panics
/// Calls before the function that is called, which naga does not write; a module without an entry
/// point.
pub fn inlined_instructions(words: &[u32]) -> usize {
    let mut totals: HashMap<u32, usize> = HashMap::new();
    let (mut entry, mut function, mut total) = (None, 0, 0);
    for (code, operands) in instructions(words) {
        match code {
            OP_ENTRY_POINT => entry = entry.or(Some(operands[1])),
            OP_FUNCTION => (function, total) = (operands[1], 0),
            OP_FUNCTION_PARAMETER => {}
            OP_FUNCTION_CALL => total += totals[&operands[2]],
            OP_FUNCTION_END => {
                totals.insert(function, total);
            }
            _ => total += 1,
        }
    }
    totals[&entry.expect("an entry point")]
}

/// The module that `spirv-opt -O` makes of a module; `None` if it is not installed.
pub fn optimized(words: &[u32]) -> Option<Vec<u32>> {
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
