//! Helpers of the test programs that draw: looks and nodes evaluated on the GPU and in the
//! reference, and scenes made for a test. All of `chiaro-test-support` is reexported.

pub use chiaro_test_support::*;

pub mod eval;
pub mod examples;
pub mod front;
pub mod halved;
pub mod handwritten;
pub mod held;
pub mod stacks;
