//! Tests of the window, driven by pointer and keys as a person drives it.
#![cfg(feature = "editor")]

use chiaro_test_drawing as support;

mod bands;
mod canvas;
mod dock;
mod editor_support;
mod export;
mod fit;
mod gizmo;
mod imports;
mod journeys;
mod keys;
mod kills;
mod language;
mod layer_links;
mod layout;
mod library;
mod light_panels;
mod light_shots;
mod monkey;
mod names;
mod paint;
mod paint_make;
mod paint_parts;
mod paint_shots;
mod panels;
mod picture;
mod placing;
mod placing_groups;
mod playback;
mod rest;
mod safety;
mod scene;
mod scene_light_keys;
mod scene_parts;
mod shot_documents;
mod shot_keys;
mod shot_window;
mod shots;
mod snapshots;
mod stack;
mod stack_shots;
mod start;
mod timeline;
mod viewport;
mod window;
