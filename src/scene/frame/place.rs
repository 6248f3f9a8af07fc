//! Cameras and lights placed by a line of text, as on the command line and in a gallery's list.

use chiaro_locale::tr;
use glam::{DQuat, DVec3};

use crate::document::{Camera, Projection, Scene};

/// Error in a line of text that places a camera or lights.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlacementError {
    /// Part of the text that is wrong.
    pub found: String,
    /// Form of the text that is accepted there.
    pub wanted: &'static str,
}

/// Places a camera: `eye=X,Y,Z`, `target=X,Y,Z`, `up=X,Y,Z`, `orbit=YAW,PITCH` and `fov=DEGREES` in
/// degrees, `distance=D` and `ortho=HEIGHT` in scene units; joined by `;`, applied in order.
///
/// # Errors
/// A part in another form, and an eye at its target.
pub fn place_camera(camera: &mut Camera, text: &str) -> Result<(), PlacementError> {
    let bad = |part: &str| PlacementError {
        found: part.to_owned(),
        wanted: tr!(
            "eye=X,Y,Z, target=X,Y,Z, up=X,Y,Z, orbit=YAW,PITCH, distance=D, ortho=HEIGHT or \
                 fov=DEGREES \
                 from 0.06 to 179.4, joined by `;`"
        ),
    };
    for part in text.split(';').map(str::trim).filter(|part| !part.is_empty()) {
        let (key, value) = part.split_once('=').ok_or_else(|| bad(part))?;
        let values = numbers(value).ok_or_else(|| bad(part))?;
        let target = DVec3::from(camera.target);
        let offset = DVec3::from(camera.eye) - target;
        match (key.trim(), values.as_slice()) {
            ("eye", &[x, y, z]) => camera.eye = [x, y, z],
            ("target", &[x, y, z]) => camera.target = [x, y, z],
            ("up", &[x, y, z]) => camera.up = [x, y, z],
            ("orbit", &[yaw, pitch]) => {
                let turn = DQuat::from_rotation_y(yaw.to_radians())
                    * DQuat::from_rotation_x(-pitch.to_radians());
                camera.eye = (target + turn * DVec3::Z * offset.length()).to_array();
                // The up vector is turned too, so that a view from straight above has one.
                camera.up = (turn * DVec3::Y).to_array();
            }
            ("distance", &[distance]) if distance > 0.0 => {
                camera.eye = (target + offset.normalize_or(DVec3::Z) * distance).to_array();
            }
            ("ortho", &[height]) if height > 0.0 => {
                camera.projection = Projection::Orthographic;
                // A height or an angle that is given applies to the picture at hand, whatever its
                // aspect.
                (camera.height, camera.aspect) = (height, 0.0);
            }
            ("fov", &[degrees]) if Camera::holds_fov(degrees.to_radians()) => {
                camera.projection = Projection::Perspective;
                (camera.fov, camera.aspect) = (degrees.to_radians(), 0.0);
            }
            _ => return Err(bad(part)),
        }
    }
    if DVec3::from(camera.target).distance(camera.eye.into()) < 1e-9
        || DVec3::from(camera.up).length() < 1e-9
    {
        let wanted = tr!("an eye away from the target, and an `up` of any length but 0");
        return Err(PlacementError { found: text.to_owned(), wanted });
    }
    Ok(())
}

/// Turns a scene's illumination frame, and every light in it: `text` is degrees around the vertical
/// axis, or `YAW,PITCH`.
///
/// # Errors
/// A text that is not one angle or two.
pub fn turn_lights(scene: &mut Scene, text: &str) -> Result<(), PlacementError> {
    let angles =
        numbers(text).filter(|n| (1..=2).contains(&n.len())).ok_or_else(|| PlacementError {
            found: text.to_owned(),
            wanted: tr!("degrees around the vertical axis, or YAW,PITCH"),
        })?;
    let yaw = DQuat::from_rotation_y(angles[0].to_radians());
    let pitch = DQuat::from_rotation_x(-angles.get(1).copied().unwrap_or(0.0).to_radians());
    let turned = yaw * pitch * DQuat::from_array(scene.illumination);
    scene.illumination = turned.normalize().to_array();
    Ok(())
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(|part| part.trim().parse::<f64>().ok().filter(|x| x.is_finite())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_of_view_that_no_camera_has_is_told() {
        for degrees in ["0.05", "179.5", "0", "-3"] {
            let mut camera = Camera::default();
            let text = format!("fov={degrees}");
            let wrong = place_camera(&mut camera, &text).unwrap_err();
            assert!(
                wrong.found == text && wrong.wanted.contains("from 0.06 to 179.4"),
                "{wrong:?}"
            );
        }
        for degrees in [0.06, 30.0, 179.4_f64] {
            let mut camera = Camera::default();
            place_camera(&mut camera, &format!("fov={degrees}")).unwrap();
            assert_eq!(camera.fov, degrees.to_radians());
        }
    }
}
