// Ours.
fn f(x: f32) -> f32 { var y = x; while (y < 9.0) { y += g(y); } return y; }
fn g(x: f32) -> f32 { var y = x; while (y > 0.5) { y *= 0.9; } return y; }