//! Every node, look and lookup over its whole domain, GPU against the f64 reference.

mod hcbtf_lookup;
mod ledger;
mod looks;
mod nodes;
#[path = "../support/mod.rs"]
mod support;
mod worst;
