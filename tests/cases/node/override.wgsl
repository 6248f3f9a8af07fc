// Ours.
@id(1) override k: f32; fn f(x: f32) -> f32 { return x * k; }