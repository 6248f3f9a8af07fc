/// Light in set
///
/// Whether a light is one of a set: 1 or 0. In a group that runs for each light of a set, some of
/// them can so be drawn apart: the rim lights harder, the window's warmer, without a group of their
/// own.
///
/// @param light "Light" light_name : The light's id; in a group that runs for each light, that one.
/// @param lights "Lights" text default=* : The set: ids, "names" and groups, as in
///   key | group:rim - group:set.
/// @param member default=0 member=lights : 1 if the light is of the set.
/// @return inside "Inside" : 1 if the light is of the set, 0 if not.
/// @unit
fn light_in_set(member: f32) -> f32 {
    return member;
}
