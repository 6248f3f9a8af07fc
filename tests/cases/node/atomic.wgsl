// Ours.
var<workgroup> a: atomic<u32>; fn f(x: f32) -> f32 { return f32(atomicAdd(&a, 1u)); }