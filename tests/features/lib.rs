//! Nothing but its dependencies. Cargo gives a crate from elsewhere the features that all selected
//! packages ask for together; a part of Chiaro that is selected beside this one meets the crates as
//! the whole workspace has them, so that they are not checked once more.
