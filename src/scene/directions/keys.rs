//! Set of distinct unit directions, made from directions as an artist gives them.

use chiaro_locale::tr;
use glam::DVec3;

use crate::diag::{Diagnostic, WithWarnings};

/// Angle below which keys are merged, in radians: raw weights grow like 1 over their distance, to
/// -2e3 here.
pub const MERGE_ANGLE: f64 = 1e-4;

/// Distance below which keys of drivers are merged, as a share of the extent of the keys along an
/// axis.
pub(super) const MERGE_PLACES: f64 = 1e-6;

/// Angle below which keys are warned of, because they split the sphere by a sharp edge; 5 degrees,
/// in radians.
pub const CLOSE_ANGLE: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// Greatest number of keys in a set; the solve takes the cube of the count, a query its square.
/// Later keys have weight 0.
pub const MAX_KEYS: usize = 512;

/// The group of a key that has no weight.
pub(super) const NO_GROUP: u32 = u32::MAX;

/// Distinct unit directions, each shared by a group of keys.
#[derive(Clone, Debug, Default)]
pub(super) struct KeySet {
    /// Direction of each group: that of its first key. Groups are in order of first keys, so group
    /// `g` begins at or after key `g`.
    pub(super) centers: Vec<DVec3>,
    /// Number of keys in each group.
    pub(super) sizes: Vec<u32>,
    /// Group of each key, or [`NO_GROUP`].
    pub(super) group_of: Vec<u32>,
    /// First key of each group.
    first_keys: Vec<usize>,
}

impl KeySet {
    /// Normalises and merges directions, and reports every key that is merged or has no weight.
    pub(super) fn gather(directions: &[DVec3]) -> WithWarnings<Self> {
        let mut set = Self::default();
        let mut diagnostics = Vec::new();
        for (key, &direction) in directions.iter().enumerate() {
            let group =
                if key < MAX_KEYS { set.place(key, direction, &mut diagnostics) } else { NO_GROUP };
            set.group_of.push(group);
        }
        if directions.len() > MAX_KEYS {
            let problem = tr!(
                "there are {count} direction keys, more than the {MAX_KEYS} that fit",
                count = directions.len()
            );
            diagnostics.push(
                Diagnostic::error("too-many-keys", problem)
                    .hint(tr!("those past the limit have no weight")),
            );
        }
        WithWarnings::new(set, diagnostics)
    }

    /// Result as of `gather`, of points instead of directions: any finite numbers.
    pub(super) fn gather_places(places: &[DVec3]) -> WithWarnings<Self> {
        let mut set = Self::default();
        let mut diagnostics = Vec::new();
        for (key, &place) in places.iter().enumerate() {
            let near = |center: &DVec3| center.distance(place) < MERGE_PLACES;
            let group = match set.centers.iter().position(near) {
                _ if key >= MAX_KEYS || !place.is_finite() => NO_GROUP,
                Some(group) => {
                    diagnostics.push(
                        merged(key, set.first_keys[group]).json_path(format!("keys[{key}].at")),
                    );
                    set.sizes[group] += 1;
                    group as u32
                }
                None => set.add(key, place),
            };
            set.group_of.push(group);
        }
        if places.len() > MAX_KEYS {
            let problem = tr!(
                "there are {count} keys in a set, more than the {MAX_KEYS} that fit",
                count = places.len()
            );
            diagnostics.push(
                Diagnostic::error("too-many-keys", problem)
                    .hint(tr!("those past the limit have no weight")),
            );
        }
        WithWarnings::new(set, diagnostics)
    }

    /// The group of a new key, found or made.
    fn place(&mut self, key: usize, direction: DVec3, diagnostics: &mut Vec<Diagnostic>) -> u32 {
        let Some(direction) = unit(direction) else {
            diagnostics.push(without_direction(key, direction));
            return NO_GROUP;
        };
        let Some((group, angle)) = self.nearest(direction) else { return self.add(key, direction) };
        let other = self.first_keys[group];
        if angle < MERGE_ANGLE {
            diagnostics.push(merged(key, other));
            self.sizes[group] += 1;
            return group as u32;
        }
        if angle < CLOSE_ANGLE {
            diagnostics.push(close(key, other, angle));
        }
        self.add(key, direction)
    }

    fn add(&mut self, key: usize, direction: DVec3) -> u32 {
        self.centers.push(direction);
        self.sizes.push(1);
        self.first_keys.push(key);
        self.centers.len() as u32 - 1
    }

    /// The group nearest to a unit direction, and the angle between.
    pub(super) fn nearest(&self, direction: DVec3) -> Option<(usize, f64)> {
        let squared = |center: &DVec3| (direction - *center).length_squared();
        let nearest =
            self.centers.iter().map(squared).enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.map(|(group, squared)| (group, angle_of_chord(squared.sqrt())))
    }

    /// The two groups that are nearest to each other, by their first keys, and the angle between.
    pub(super) fn closest_pair(&self) -> Option<(usize, usize, f64)> {
        let mut closest: Option<(usize, usize, f64)> = None;
        for (i, a) in self.centers.iter().enumerate() {
            for (j, b) in self.centers[..i].iter().enumerate() {
                let chord = (*a - *b).length();
                if closest.is_none_or(|(_, _, least)| chord < least) {
                    closest = Some((j, i, chord));
                }
            }
        }
        closest.map(|(j, i, chord)| (self.first_keys[j], self.first_keys[i], angle_of_chord(chord)))
    }
}

/// The angle between unit vectors `chord` apart, in radians; exact for small angles, where an arc
/// cosine is not.
pub(super) fn angle_of_chord(chord: f64) -> f64 {
    2.0 * (0.5 * chord).min(1.0).asin()
}

/// The unit vector along `direction`, however long or short; `None` for zero and for values that
/// are not finite.
pub(super) fn unit(direction: DVec3) -> Option<DVec3> {
    let largest = direction.abs().max_element();
    // Division by the largest component first, so that squares neither overflow nor vanish.
    (direction.is_finite() && largest > 0.0).then(|| (direction / largest).normalize())
}

fn path(key: usize) -> String {
    format!("keys[{key}].direction")
}

fn without_direction(key: usize, direction: DVec3) -> Diagnostic {
    let why = if direction.is_finite() { tr!("its length is 0") } else { tr!("it is not finite") };
    Diagnostic::error("key-without-direction", tr!("`keys[{key}]` points nowhere: {why}"))
        .json_path(path(key))
        .hint(tr!("give it three numbers that are not all 0; until then its weight is 0"))
}

fn merged(key: usize, other: usize) -> Diagnostic {
    let problem =
        tr!("`keys[{key}]` stands where `keys[{other}]` does, so they share one weight equally");
    Diagnostic::warning("merged-keys", problem)
        .json_path(path(key))
        .hint(tr!("move one of them, or delete it"))
}

fn close(key: usize, other: usize, angle: f64) -> Diagnostic {
    let degrees = angle.to_degrees();
    let problem = tr!("`keys[{key}]` and `keys[{other}]` are only {degrees:.2} degrees apart");
    Diagnostic::warning("close-keys", problem).json_path(path(key)).hint(tr!(
        "keys this close split the sphere by a sharp edge; move them 5 degrees apart, or \
               delete one"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn codes(diagnostics: &[Diagnostic]) -> Vec<&'static str> {
        diagnostics.iter().map(|d| d.code).collect()
    }

    #[test]
    fn any_length_has_a_direction() {
        for length in [1e-310, 1e-200, 1.0, 1e200, 1e308] {
            assert!(
                (unit(DVec3::new(1.0, -1.0, 0.0) * length).unwrap().length() - 1.0).abs() < 1e-15,
                "{length:e}"
            );
        }
        assert_eq!(unit(DVec3::ZERO), None);
        assert_eq!(unit(DVec3::new(1.0, f64::NAN, 0.0)), None);
        assert_eq!(unit(DVec3::new(1.0, 0.0, f64::INFINITY)), None);
    }

    #[test]
    fn every_odd_key_is_reported() {
        let near = |angle: f64| DVec3::new(angle.cos(), angle.sin(), 0.0);
        let keys =
            [DVec3::X, DVec3::ZERO, DVec3::X * 7.0, near(1e-6), near(0.05), DVec3::NAN, DVec3::Z];
        let (set, diagnostics) = KeySet::gather(&keys).into_parts();
        assert_eq!(set.group_of, [0, NO_GROUP, 0, 0, 1, NO_GROUP, 2]);
        assert_eq!(set.sizes, [3, 1, 1]);
        let wanted = [
            "key-without-direction",
            "merged-keys",
            "merged-keys",
            "close-keys",
            "key-without-direction",
        ];
        assert_eq!(codes(&diagnostics), wanted);
        assert!(diagnostics[3].message.contains("2.86 degrees"), "{}", diagnostics[3]);
        assert_eq!(set.closest_pair().map(|(a, b, _)| (a, b)), Some((0, 4)));
    }

    #[test]
    fn the_count_is_bounded() {
        let (set, diagnostics) = KeySet::gather(&vec![DVec3::Y; MAX_KEYS + 5]).into_parts();
        assert_eq!(set.centers.len(), 1);
        assert_eq!(set.group_of[MAX_KEYS..], [NO_GROUP; 5]);
        assert_eq!(codes(&diagnostics).last(), Some(&"too-many-keys"));
    }
}
