//! Chiaro: from a graph of light to one readable WGSL shader.
//!
//! A [`document::Look`] is what an artist wires. [`compile`] checks it against the [`library`] of
//! nodes (each one a WGSL file), runs whatever is known before the fragment through [`interp`] in
//! f64, removes what cannot reach the output, and emits one WGSL module that [`wgsl`] has
//! validated. [`frame`] joins looks, meshes, lights, keys and time into a frame plan, which the
//! renderer executes and `export` turns into files for other programs.
//!
//! Each floor of the house is a crate under `src/`, lowest first; here its rooms go by the names
//! that people say.
//!
//! ## Where things are
//!
//! Paths are from `src/`, or from the top; a test holds that they exist, and that a name after the
//! path of a file is in that file. Reasons are in `docs/decisions.md`, words in `docs/glossary.md`.
//!
//! Documents:
//! - Fields in files: rows in `compiler/document/look.rs`, `compiler/document/scene.rs` and
//!   `compiler/document/hcbtf/`; types, readers and writers come of them in
//!   `compiler/document/described/`.
//! - Undo: `compiler/document/edit/history.rs` (`History`) in one document,
//!   `editor/state/session/steps.rs` across all, by the times in `editor/state/document/times.rs`.
//! - Diagnostics: `language/diag/mod.rs` has their form; each text is where the problem is found.
//!
//! Shaders:
//! - Order of nodes: `compiler/compile/emit/mod.rs` (`order_calls`).
//! - Shorter forms of functions where facts hold: lines of docs in `shaders/lib/`, read in
//!   `compiler/library/rules.rs` (`FormRule`); `compiler/compile/functions/` takes them.
//! - Contexts, which nodes read of the surroundings: `compiler/library/context/table.rs`.
//! - Passes: `compiler/library/passes/table.rs`.
//! - Curvature: `shaders/passes/curvature.wgsl`, `shaders/lib/curvature_map.wgsl`,
//!   `shaders/lib/slope.wgsl`.
//! - Outlines: `shaders/lib/edge_map.wgsl` finds edges, `shaders/lib/line_map.wgsl` how far they
//!   are, `shaders/lib/lines.wgsl` what lines cover; the order of passes is that of the table.
//! - Languages of exports: `scene/export/mod.rs` (`LANGUAGES`).
//! - Pixels that stay from frame to frame: `render/kept.rs`; which ones, by
//!   `scene/frame/plan/look_inputs.rs` (`LookInputs`).
//! - Looks drawn over the picture: `scene/frame/deferred/mod.rs` (`Deferral`), chosen in
//!   `scene/frame/plan/deferral.rs`, drawn in `render/deferred/mod.rs`.
//!
//! HCBTFs:
//! - Rules: rows in `compiler/document/hcbtf/rule/mod.rs` (`Rule`), strokes and reliefs beside it;
//!   `scene/hcbtf/fill/` runs them, `scene/hcbtf/generate/` draws.
//! - Files: `scene/hcbtf/file.rs`; all samples as one picture: `scene/hcbtf/sheet.rs` (as the
//!   thesis has it), `scene/hcbtf/contact.rs` (tiles side by side).
//! - Lookup: `shaders/lib/hcbtf.wgsl`; the texture that it reads: `scene/hcbtf/layers.rs`.
//! - Painting window: `editor/painter/`; command line: `cli/hcbtf/`.
//!
//! Lights:
//! - Fields: rows in `compiler/document/light/mod.rs` (`light_fields!`).
//! - Sets of lights: `compiler/document/set.rs` (`LightSet`); links to objects:
//!   `compiler/document/light/link.rs` (`LightLink`), `scene/frame/links.rs` (`unlinked_lights`).
//! - Mutes, solos and masters of groups: `compiler/document/light/master.rs` (`GroupMaster`),
//!   `scene/frame/mix.rs` (`light_mix`).
//! - Fading with distance, and the cone: `shaders/lib/light.wgsl` (`light_fading`, `light_cone`).
//! - A scene's lights in place of a look's, by id: `scene/frame/plan/placement.rs` (`lights`),
//!   `scene/frame/keys/rig.rs` (`keyed_values`).
//! - Handles on the object: `editor/viewport/lights.rs`.
//! - Light that is painted on the picture: `editor/tools/fitting/`, `laboratory/fit/solve.rs`.
//!
//! Measures:
//! - Fragments in f64: `reference/modules.rs` (`Fragments`).
//! - Distance of the GPU's picture from them: `laboratory/accuracy/error.rs` (`compare`).
//! - Time: `laboratory/accuracy/cost.rs`; time and error are shown by `editor/panels/cost/`.
//! - Counted operations: `language/wgsl/operations.rs`, `scene/frame/cost.rs`; shown by
//!   `editor/panels/effects.rs`.
//!
//! Film:
//! - Shots: `compiler/document/shot/mod.rs` (`Shot`); values by address:
//!   `compiler/document/shot/place.rs` (`set_value`); put into a scene:
//!   `scene/frame/shot/resolve.rs` (`change_scene`), at a time:
//!   `scene/frame/shot/moving.rs` (`at`).
//! - Frames of a scene: `film/frames.rs` (`FrameList`); drawn by `cli/render/frames.rs`.
//! - EXR: `film/exr/mod.rs` (`encode`).
//! - Contributions of layers and lights: `film/contributions.rs`; lights of one step parted:
//!   `compiler/compile/parting.rs`; tables of what bends them: `compiler/compile/transfer.rs`.
//! - Layers beside the picture: `film/layers.rs` (`LayeredPlan`), drawn by looks' modules as
//!   `compiler/compile/aov.rs` (`AovSource`) says; mattes: `scene/frame/mattes.rs` (`MattePart`).
//! - Views of OpenColorIO: `film/view/mod.rs` (`DisplayView`); on the GPU `render/display.rs`; in
//!   the window `editor/state/display.rs` and `editor/viewport/colors.rs`.
//! - Frames, farms' jobs and wedges from the window: `editor/panels/frames/` and
//!   `editor/panels/wedge/varied.rs`; the program's own command line makes them, in a process
//!   beside the window: `editor/state/runs/run.rs` (`ProgramRun`).
//!
//! Window:
//! - Panels: `editor/panels/mod.rs` (`PANELS`) lists their rows, which are in the panels' files.
//! - Shortcuts: rows in `editor/commands/table/`, listed by `editor/app/shortcuts_and_palette.rs`.
//! - Unsaved work after a crash: `files/journal/` keeps it, `editor/state/safety/` offers it.
//! - Documents that the last program ended over: `editor/state/crashes.rs` (`Suspect`).
#![forbid(unsafe_code)]
#![warn(missing_docs)]

#[doc(inline)]
pub use chiaro_language::{clock, diag, figures, ids, interp, milestones, progress, wgsl};

#[doc(inline)]
pub use chiaro_compiler::{catalog, compile, document, examples, library};

#[doc(inline)]
pub use chiaro_files as files;

#[cfg(feature = "scene")]
#[doc(inline)]
pub use chiaro_scene::{
    directions, drawing, export, frame, geometry, hcbtf, import, placing, threads,
};

#[cfg(feature = "scene")]
#[doc(inline)]
pub use chiaro_reference as reference;
#[cfg(feature = "gpu")]
#[doc(inline)]
pub use chiaro_render as render;

#[cfg(feature = "scene")]
#[doc(inline)]
pub use chiaro_film as film;
#[cfg(feature = "scene")]
#[doc(inline)]
pub use chiaro_laboratory::fit;
#[cfg(feature = "gpu")]
#[doc(inline)]
pub use chiaro_laboratory::{accuracy, gallery};
#[cfg(feature = "sweeps")]
#[doc(inline)]
pub use chiaro_sweeps as sweeps;

#[cfg(feature = "cli")]
#[doc(inline)]
pub use chiaro_cli as cli;
#[cfg(feature = "editor")]
#[doc(inline)]
pub use chiaro_editor as editor;
