// Ours.
fn f(x: f32) -> f32 { var a: array<f32, 10000>; a[u32(x)] = x; return a[1]; }