//! Random documents are written and read without loss; random edits are undone; random texts never panic.

mod edits;
mod random;
mod round_trips;
mod texts;
