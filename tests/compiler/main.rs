//! Documents, the compiler and the house itself: what needs no GPU.

mod compile;
mod document_format;
mod document_history;
mod document_random;
mod document_read;
mod floors;
mod interp_lanes;
mod math;
#[path = "../support/mod.rs"]
mod support;
mod techniques;
mod words;
