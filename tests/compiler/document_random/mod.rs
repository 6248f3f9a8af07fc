//! Random documents are written and read without loss; random edits are undone; random texts never
//! cause a panic.

mod edits;
mod journal;
mod random;
mod round_trips;
mod texts;
