//! Frame plans of a scene at a time: which passes run, on which modules, with which values, and
//! why.
//!
//! [`open`] finds everything that a look or a scene names; [`Planner::plan`] makes a [`FramePlan`]
//! of it, which a renderer executes without knowing what a look is. A pass is in the plan only
//! while a live node of a visible object needs it; parts that are left out are listed with the
//! reason.

mod aims;
mod aovs;
mod assets;
mod camera;
mod casters;
mod content;
mod cost;
mod coverage;
mod deferred;
mod display;
mod effects;
mod executor;
mod handover;
mod keys;
mod layers;
mod links;
mod mattes;
mod mix;
mod motion;
mod nearest;
mod object_lights;
mod picture;
mod place;
mod plan;
mod samples;
mod screen;
mod setup;
mod shadow_maps;
mod shot;
mod store;
mod tiles;
mod uvs;
mod values;
mod visibility;

/// Types of the compiler that a plan holds; executors of plans need no more of the compiler than
/// these.
pub use crate::compile::{
    BindingKind, CompiledShader, ImageShape, ImageUse, SAMPLES_PER_ROW, Stage, Uniform,
    VertexAttribute,
};
/// The passes of a plan, which the compiler lists: a look's module names those that it reads.
pub use crate::library::{PassId, PassOutput, PassRow, PassWork, ScreenExtent, TexelFormat};
pub use aovs::{AovKind, AovLayer, AovRequest, LayeredPicture};
pub use assets::{
    Assets, Change, Image, MAX_IMAGE_SIDE, MESH_PREFIX, Overlay, OverlayVersion, SHAPE_PREFIX,
    UNSAVED_HCBTF, image_bytes,
};
pub use camera::{View, widened};
pub use casters::Casters;
pub use cost::{EffectCost, TierCosts, TierOperations, attribute_bytes, tier_costs};
pub use coverage::PixelArea;
pub use deferred::{
    Deferral, DeferredDraw, DeferredLook, DeferredModule, MESH_TEXELS_PER_ROW, NumberedMesh,
};
pub use display::{DisplayModule, DisplayTable};
pub use effects::{Effect, EffectKind, EffectState, effects};
pub use executor::{Executor, LayersFuture, PictureFuture, ShadedShare};
pub use handover::stack_of;
pub use handover::{MAX_DEPTH, SHORTEN, too_deep};
pub use keys::{
    BezierSpan, KeyedValues, ObjectValues, ParamTable, Rig, RigInputs, SceneRig, Track, Wires,
    driver_value, is_direction, light_field, set_light_field, structural_look,
};
pub use links::{LayerReach, LightReach, ShadowReach};
pub use mattes::MattePart;
pub use mix::SOLOED;
pub use motion::PlayedAnimation;
pub use picture::Picture;
pub use place::{PlacementError, place_camera, turn_lights};
pub use plan::{
    Draw, DroppedEffect, FramePlan, LookInputs, Pass, PlanOptions, PlanStyle, Planner, named_map,
};
pub use samples::{EvalBatch, EvalSample, Evaluable, LightOverride, eval_batches};
pub use screen::{Ink, PassImage, ScreenBinding, ScreenModule, ScreenResource, ViewNumber};
pub use setup::{
    ANY_MATERIAL, DEFAULT_MESH, LookSource, Setup, SetupLook, SetupObject, default_setup, look_of,
    object_matrix, open, place_objects, scene_setup,
};
pub use shadow_maps::{LightLayer, LightModule, MapCaster, ShadowMaps};
pub use shot::{ResolvedShot, ShotFile, ShotResolver, ShotStack, ValueChange, open_shot, scene_of};
pub use store::AssetStore;
pub use tiles::{MAX_TILE_SAMPLES, TileView, moving_light, tile_assets};
pub use uvs::missing_uvs;
pub use values::check_exposed_value;
pub use visibility::CullMode;
