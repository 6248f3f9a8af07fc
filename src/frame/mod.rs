//! From a scene at a time to a frame plan.
