/// View direction
///
/// From the surface to the eye, in world space: what glancing angles, rims and reflections are
/// measured against.
///
/// @param view from=view hidden
/// @return view "View" : Unit.
fn view(view: vec3f) -> vec3f {
    return view;
}
