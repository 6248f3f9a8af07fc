//! Waiting for a GPU, which the library leaves to its callers.

/// Waits for a future on the calling thread.
#[expect(clippy::disallowed_methods, reason = "the one place where tests and benches wait")]
pub fn block_on<T>(future: impl Future<Output = T>) -> T {
    pollster::block_on(future)
}
