//! Journeys of an artist, each from an empty window to a look that is saved, opened again
//! in another window, and exported. Every step is done by pointer and keys at widgets that have a
//! name on the screen, and every journey ends with the same proof: the file holds the window's
//! look, another window and the program without a window draw the same picture of it, and compilers
//! of other projects take its shaders.
//!
//! Journeys through a part of the window end where that part ends, and stand with its tests:
//! masks in `stack`, bands and handles of highlights in `bands`, the library in
//! `library`, snapshots and variations in `snapshots`, light that is laid at a stroke in `fit`.

mod a_light_by_its_highlight;
mod a_look_from_nothing;
mod a_nan_is_found;
mod a_painted_surface;
mod a_rim_by_a_wedge;
mod a_seamless_tile;
mod a_shot_goes_to_a_farm;
mod a_shot_is_keyed;
mod a_wrong_frame;
mod artist;
mod comics_from_lambert;
mod five_thousand_nodes;
mod from_painted_pictures;
mod groups_are_shared;
mod half_the_cost;
mod keys_by_direction;
mod keys_over_time;
mod lights_of_a_scene;
mod passes_by_name;
mod picture;
mod recovered_after_a_crash;
