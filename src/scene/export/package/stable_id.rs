//! Ids that engines know things by: the same in every export of a look.

/// The id of a thing called `name` of the look of a stem: 32 hexadecimal digits.
pub(super) fn stable_id(stem: &str, name: &str) -> String {
    // Two rounds of FNV-1a, for 128 bits. Nothing hangs on their quality.
    let hash = |salt: &str| {
        let bytes = salt.bytes().chain(stem.bytes()).chain([0]).chain(name.bytes());
        bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
    };
    format!("{:016x}{:016x}", hash("a"), hash("b"))
}
