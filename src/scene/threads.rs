//! Threads that compile, draw or run looks. A look may be deep, and the compilers of drivers
//! recurse over it, so these threads get a larger stack.

use std::thread::Builder;

/// Stack of a thread that works on looks, in bytes. Pages that are never touched cost addresses and
/// no memory.
///
/// Measured: a chain of 5,000 nodes takes the compiler of software Vulkan beyond the 2 MiB that
/// threads have by themselves.
pub const STACK: usize = 64 << 20;

/// Builder of a thread of this name, with stack for looks.
pub fn builder(name: &str) -> Builder {
    Builder::new().name(name.to_owned()).stack_size(STACK)
}

/// Number of threads that work at once here; 1 where the system does not say.
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

/// Gives the threads of rayon's pool the same stack. To be called before any work is spread over
/// the pool.
pub fn prepare_pool() {
    // A pool that exists already stays as it is.
    let _ = rayon::ThreadPoolBuilder::new().stack_size(STACK).build_global();
}

/// Does work on a thread with stack for looks, and waits for it; on the calling thread where the
/// system can start none.
#[expect(
    clippy::disallowed_methods,
    reason = "one of the places that start threads: the program's own main work"
)]
pub fn with_room<T: Send>(work: impl Fn() -> T + Sync) -> T {
    let done = std::thread::scope(|scope| {
        let thread = builder("main").spawn_scoped(scope, &work).ok()?;
        Some(thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    });
    done.unwrap_or_else(work)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A recursion that uses more stack than a thread has by default.
    fn deep(left: u32) -> u32 {
        let room = std::hint::black_box([1_u8; 1024]);
        if left == 0 { 0 } else { deep(left - 1) + u32::from(room[left as usize % room.len()]) }
    }

    #[test]
    fn work_has_room() {
        assert_eq!(with_room(|| deep(20_000)), 20_000);
    }
}
