//! Weights of keys on the sphere of directions.
