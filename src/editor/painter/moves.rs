//! Steps between the directions of a light or a view, and their names.

use chiaro_locale::tr;

use crate::commands::Heading;
use crate::document::{Direction, Directions};

/// Direction one step away: left and right go around the normal, down goes toward the horizon, up
/// toward the normal. At the normal, which has no steps around it, left and right lead off to their
/// own side of the hemisphere.
pub(super) fn step(directions: Directions, from: Direction, way: Heading) -> Direction {
    let Direction { theta, phi } = from.canonical();
    let steps = directions.phi.max(1);
    let off = |turn: f64| Direction {
        theta: 1.min(directions.theta.max(1) - 1),
        phi: (turn * f64::from(steps)).round() as u32 % steps,
    };
    let next = match way {
        Heading::Left if theta > 0 => Direction { theta, phi: (phi + steps - 1) % steps },
        Heading::Right if theta > 0 => Direction { theta, phi: (phi + 1) % steps },
        // The turn is measured from v, which points up, toward u, which points right.
        Heading::Right => off(0.25),
        Heading::Left => off(0.75),
        Heading::Up => Direction { theta: theta.saturating_sub(1), phi },
        Heading::Down => Direction { theta: (theta + 1).min(directions.theta.max(1) - 1), phi },
    };
    next.canonical()
}

/// Name of a direction for people: the angle from the normal, and the angle around it, in degrees.
pub(super) fn name(directions: Directions, direction: Direction) -> String {
    let [theta, phi] = directions.angles(direction.canonical()).map(f64::to_degrees);
    match direction.theta {
        0 => tr!("straight above").to_owned(),
        _ => tr!("{theta:.0}° down, {phi:.0}° around"),
    }
}

/// Direction whose place on the hemisphere, seen from above, is nearest: u to the right, v up, the
/// horizon at 1.
pub(super) fn nearest(directions: Directions, place: glam::DVec2) -> Direction {
    let rings = directions.theta.max(2) - 1;
    let theta =
        ((place.length() * f64::from(rings)).round() as u32).min(directions.theta.max(1) - 1);
    let turn = place.x.atan2(place.y) / std::f64::consts::TAU;
    let steps = directions.phi.max(1);
    let phi = (turn.rem_euclid(1.0) * f64::from(steps)).round() as u32 % steps;
    Direction { theta, phi }.canonical()
}

/// Place of a direction on the hemisphere seen from above: u to the right, v up, the horizon at 1.
pub(super) fn place(directions: Directions, direction: Direction) -> glam::DVec2 {
    let [theta, phi] = directions.angles(direction.canonical());
    glam::DVec2::new(phi.sin(), phi.cos()) * theta / std::f64::consts::FRAC_PI_2
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIRECTIONS: Directions = Directions { theta: 6, phi: 10 };

    #[test]
    fn steps_go_around_and_down() {
        let at = |theta, phi| Direction { theta, phi };
        assert_eq!(step(DIRECTIONS, at(2, 0), Heading::Left), at(2, 9));
        assert_eq!(step(DIRECTIONS, at(2, 9), Heading::Right), at(2, 0));
        assert_eq!(step(DIRECTIONS, at(5, 3), Heading::Down), at(5, 3));
        assert_eq!(step(DIRECTIONS, at(1, 3), Heading::Up), at(0, 0));
    }

    #[test]
    fn left_and_right_lead_off_the_normal_to_their_own_side() {
        let to = |way| place(DIRECTIONS, step(DIRECTIONS, Direction::default(), way));
        assert!(to(Heading::Right).x > 0.1 && to(Heading::Left).x < -0.1);
        assert_eq!(step(DIRECTIONS, Direction::default(), Heading::Up), Direction::default());
        for way in [Heading::Left, Heading::Right, Heading::Down] {
            assert_eq!(
                step(Directions { theta: 1, phi: 1 }, Direction::default(), way),
                Direction::default()
            );
            assert_eq!(
                step(Directions { theta: 2, phi: 1 }, Direction::default(), way),
                Direction { theta: 1, phi: 0 }
            );
        }
    }

    #[test]
    fn every_direction_is_nearest_to_its_own_place() {
        for direction in DIRECTIONS.distinct() {
            assert_eq!(nearest(DIRECTIONS, place(DIRECTIONS, direction)), direction);
        }
        assert_eq!(nearest(DIRECTIONS, glam::DVec2::new(0.0, 7.0)), Direction { theta: 5, phi: 0 });
    }
}
