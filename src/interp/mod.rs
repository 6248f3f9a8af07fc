//! An interpreter over naga IR, in f64 or f32.
