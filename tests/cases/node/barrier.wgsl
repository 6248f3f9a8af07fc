// Ours.
fn f(x: f32) -> f32 { workgroupBarrier(); return x; }