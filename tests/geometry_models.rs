//! Real meshes, where they are at hand.

use std::collections::HashMap;
use std::path::PathBuf;

use chiaro::geometry::{Imported, load};

fn model(name: &str) -> Option<Imported> {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let path = ["../shared/models", "../../shared/models"].map(|folder| root.join(folder).join(name));
    let path = path.into_iter().find(|path| path.exists())?;
    Some(load(&path).unwrap_or_else(|problems| panic!("{name}: {}", problems[0])))
}

#[test]
fn measure() {
    for name in ["spot", "suzanne", "teapot", "stanford-bunny", "nefertiti", "rocker-arm"] {
        let Some(Imported { mesh, notes }) = model(&format!("{name}.obj")) else { return };
        let mut at: HashMap<[u32; 3], u32> = HashMap::new();
        for p in &mesh.positions {
            *at.entry(p.map(f32::to_bits)).or_default() += 1;
        }
        let split = at.values().filter(|&&n| n > 1).count();
        println!(
            "{name}: {} vertices, {} triangles, {} places, {split} split, {:?}",
            mesh.positions.len(),
            mesh.triangle_count(),
            at.len(),
            mesh.bounds()
        );
        for note in notes {
            println!("  {note}");
        }
    }
}
