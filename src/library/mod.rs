//! The library of nodes.
