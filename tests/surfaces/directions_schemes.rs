//! Differences between the weights of the three schemes of direction keys.
//!
//! `cargo test --test surfaces directions_schemes -- --ignored --nocapture` prints the figures that
//! the documentation gives.

use chiaro::directions::{KeyWeights, Tessellation};
use chiaro::document::KeyScheme;
use glam::DVec3;

/// The generator SplitMix64, so that the sets of keys are the same on every machine and for ever.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let mut number = || self.next() as f64 / u64::MAX as f64 * 2.0 - 1.0;
            let direction = DVec3::new(number(), number(), number());
            if (0.01..=1.0).contains(&direction.length_squared()) {
                return direction.normalize();
            }
        }
    }

    /// A set of 2 to 8 keys, at least 25 degrees apart, as an artist would set them.
    fn keys(&mut self) -> Vec<DVec3> {
        let count = 2 + (self.next() % 7) as usize;
        let mut keys: Vec<DVec3> = Vec::new();
        while keys.len() < count {
            let key = self.direction();
            if keys.iter().all(|other| other.angle_between(key) > 25f64.to_radians()) {
                keys.push(key);
            }
        }
        keys
    }
}

/// The largest difference of any weight over 2,000 directions.
fn difference(a: &KeyWeights, b: &KeyWeights) -> f64 {
    let mut random = Random(7);
    let (mut of_a, mut of_b) = (vec![0.0; a.len()], vec![0.0; b.len()]);
    let mut largest = 0.0f64;
    for _ in 0..2000 {
        let direction = random.direction();
        a.weights_into(direction, &mut of_a);
        b.weights_into(direction, &mut of_b);
        largest = of_a.iter().zip(&of_b).map(|(x, y)| (x - y).abs()).fold(largest, f64::max);
    }
    largest
}

/// Mean and maximum, over 40 random sets of keys, of the largest difference between the weights of
/// two schemes.
fn over_sets(a: impl Fn(&[DVec3]) -> KeyWeights, b: impl Fn(&[DVec3]) -> KeyWeights) -> (f64, f64) {
    let mut random = Random(1);
    let largest: Vec<f64> = (0..40)
        .map(|_| {
            let keys = random.keys();
            difference(&a(&keys), &b(&keys))
        })
        .collect();
    (largest.iter().sum::<f64>() / 40.0, largest.iter().copied().fold(0.0, f64::max))
}

fn closed(scheme: KeyScheme) -> impl Fn(&[DVec3]) -> KeyWeights {
    move |keys| KeyWeights::new(keys, scheme).value
}

fn mesh(level: u32, area_weighted: bool) -> impl Fn(&[DVec3]) -> KeyWeights {
    move |keys| KeyWeights::tessellated(keys, Tessellation { level, area_weighted }).value
}

#[test]
fn the_mesh_converges_toward_the_closed_form_of_its_energy() {
    let (mean_2, _) = over_sets(mesh(2, true), closed(KeyScheme::AppendixB));
    let (mean_3, _) = over_sets(mesh(3, true), closed(KeyScheme::AppendixB));
    let (mean_4, largest_4) = over_sets(mesh(4, true), closed(KeyScheme::AppendixB));
    assert!(mean_3 < mean_2 && mean_4 < mean_3, "{mean_2} {mean_3} {mean_4}");
    assert!(mean_4 < 0.02 && largest_4 < 0.1, "{mean_4} {largest_4}");
}

#[test]
fn the_papers_mesh_is_near_the_closed_form_and_far_from_the_biharmonic() {
    let (near, near_most) = over_sets(mesh(4, false), closed(KeyScheme::AppendixB));
    let (far, _) = over_sets(mesh(4, false), closed(KeyScheme::Biharmonic));
    assert!(near < 0.03 && near_most < 0.2, "{near} {near_most}");
    assert!(far > 4.0 * near, "{far} {near}");
}

#[test]
#[ignore = "prints figures for the documentation; takes seconds"]
#[expect(clippy::print_stdout, reason = "figures for people")]
fn figures() {
    let show =
        |name: &str, (mean, max): (f64, f64)| println!("{name:45} mean {mean:.4}  max {max:.4}");
    show(
        "biharmonic | appendix-b",
        over_sets(closed(KeyScheme::Biharmonic), closed(KeyScheme::AppendixB)),
    );
    for level in 2..=5 {
        for weighted in [false, true] {
            let name = format!("level {level}, area weights {weighted} | appendix-b");
            show(&name, over_sets(mesh(level, weighted), closed(KeyScheme::AppendixB)));
        }
    }
}
