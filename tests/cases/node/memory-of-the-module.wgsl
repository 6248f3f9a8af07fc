// Ours.
var<private> a: array<f32, 50000000>; fn f(x: f32) -> f32 { return a[u32(x)]; }