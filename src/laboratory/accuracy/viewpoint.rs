//! Viewpoints that looks are judged from: views, turns of the lights and times, spread evenly.

use crate::frame::Setup;

/// A view, a turn of the lights and a time.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Viewpoint {
    /// Turn of the camera around its target: to the right, then up, in radians.
    pub orbit: [f64; 2],
    /// Turn of the illumination frame: around the vertical, then up, in radians.
    pub lights: [f64; 2],
    /// Time of the scene, in seconds.
    pub time: f64,
}

impl Viewpoint {
    /// Description of the viewpoint for people, in degrees.
    pub fn told(&self) -> String {
        let [turn, rise] = self.orbit.map(f64::to_degrees);
        let [around, up] = self.lights.map(f64::to_degrees);
        format!(
            "camera turned by {turn:.0} and {rise:.0} degrees, lights by {around:.0} and {up:.0}, \
             {} s",
            (self.time * 100.0).round() / 100.0
        )
    }

    /// The setup seen from this viewpoint.
    pub fn of(&self, setup: &Setup) -> Setup {
        let mut setup = setup.clone();
        setup.turn_camera(self.orbit);
        setup.turn_lights(self.lights);
        setup
    }
}

/// `count` viewpoints: the first one as the scene is, the others spread evenly over views, lights
/// and times.
pub fn viewpoints(setup: &Setup, count: usize) -> Vec<Viewpoint> {
    // Multiples of powers of the generalized golden ratio fill a cube evenly (Roberts 2018).
    const STEPS: [f64; 5] =
        [0.856_674_883_7, 0.733_891_856_6, 0.628_706_720_8, 0.538_597_158_5, 0.461_402_658_3];
    let range = &setup.scene.time;
    let viewpoint = |index: usize| {
        let share = |axis: usize| (0.5 + STEPS[axis] * index as f64).fract();
        let turn = |share: f64| std::f64::consts::TAU * share;
        // Elevations are even over the sphere, but spare the poles, from which a look is seldom
        // seen.
        let rise = |share: f64| (1.6 * share - 0.8).asin();
        let time = range.start + share(4) * (range.end - range.start);
        Viewpoint {
            orbit: [turn(share(0)), rise(share(1))],
            lights: [turn(share(2)), rise(share(3))],
            time,
        }
    };
    let first = Viewpoint { orbit: [0.0; 2], lights: [0.0; 2], time: range.start };
    std::iter::once(first).chain((1..count.max(1)).map(viewpoint)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn viewpoints_are_spread() {
        let found = viewpoints(&Setup::default(), 64);
        assert_eq!(found[0].orbit, [0.0; 2]);
        let octants: std::collections::HashSet<_> = found[1..]
            .iter()
            .map(|s| {
                (
                    (s.orbit[0] / std::f64::consts::FRAC_PI_2) as i32,
                    s.orbit[1] > 0.0,
                    s.lights[0] > std::f64::consts::PI,
                )
            })
            .collect();
        assert_eq!(octants.len(), 16);
    }
}
