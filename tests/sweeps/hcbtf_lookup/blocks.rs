//! HCBTFs in compressed blocks: the GPU decodes what the CPU decodes, with the stated loss, and a
//! device without such textures shows the same.

use std::sync::Arc;

use chiaro::document::{Grid, Hcbtf, Storage, Tile};
use chiaro::files::Disk;
use chiaro::frame::{Assets, EvalSample, PlanOptions, Planner};
use chiaro::hcbtf::fill::fill;
use chiaro::hcbtf::{LayerOptions, LayeredTexture, from_layers, load, loss, stored};
use chiaro::library::Library;
use chiaro::progress::Progress;
use chiaro::render::{Gpu, Renderer, device_descriptor};

use super::{BALANCED, Directions, LOOKUPS, at_random, by_hand, file, note, stored_as};
use crate::support::eval::{eval_on, options, renderer, scene_of, shape, truth};
use crate::support::random::Random;
use crate::support::report::Errors;
use crate::support::wait::block_on;

const OPTIONS: LayerOptions =
    LayerOptions { has_levels: true, is_decoded: false, storage: Storage::Blocks };

/// An HCBTF of smooth paint with strokes across, partly transparent.
fn strokes(size: [u32; 2]) -> Hcbtf {
    let grid = Grid {
        size,
        light: Directions { theta: 3, phi: 4 },
        view: Directions { theta: 2, phi: 5 },
    };
    let mut random = Random::new(u64::from(size[0]));
    let mut tile = || {
        let [slope, shift] = [random.between(-1.5, 1.5), random.between(0.0, 9.0)];
        let texel = |at: u32| {
            let [x, y] = [f64::from(at % size[0]), f64::from(at / size[0])];
            let is_stroke = (x + slope * y + shift).rem_euclid(7.0) < 2.0;
            let ground = [120.0 + 5.0 * x, 90.0 + 6.0 * y, 60.0 + 3.0 * (x + y), 255.0];
            let color =
                if is_stroke { [40.0, 30.0 + 4.0 * y, 70.0, 255.0 - 9.0 * shift] } else { ground };
            color.map(|channel| channel.clamp(0.0, 255.0) as u8)
        };
        Arc::new(Tile::new(size, (0..size[0] * size[1]).flat_map(texel).collect()).unwrap())
    };
    Hcbtf {
        painted: grid.addresses().map(|address| (address, tile())).collect(),
        ..Hcbtf::new(grid)
    }
}

fn blocks_of(hcbtf: &Hcbtf) -> LayeredTexture {
    let filled = fill(hcbtf, &Progress::new()).unwrap();
    stored(&hcbtf.grid, |address| filled.tile(address), OPTIONS, &Progress::new()).unwrap()
}

/// A device of the same adapter without compressed textures.
fn without_blocks() -> Gpu {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter =
        block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())).unwrap();
    let mut descriptor = device_descriptor(&adapter);
    descriptor.required_features.remove(wgpu::Features::TEXTURE_COMPRESSION_BC);
    let (device, queue) = block_on(adapter.request_device(&descriptor)).unwrap();
    Gpu::new(device, queue, adapter.get_info())
}

/// Lookups in blocks, in sizes that are whole blocks and in sizes that are not.
#[test]
fn blocks_are_looked_up_as_they_are_decoded_with_and_without_a_device_that_has_them() {
    assert!(renderer().gpu().has_blocks(), "software Vulkan has them");
    let mut plain = Renderer::new(without_blocks());
    assert!(!plain.gpu().has_blocks());
    for size in [[16, 8], [13, 6]] {
        let painted = strokes(size);
        let path = file(&format!("blocks_{}", size[0]), &painted);
        // The blocks decoded by another decoder than the GPU's.
        let hcbtf = from_layers(&blocks_of(&painted)).unwrap();
        let samples = at_random(&hcbtf, 500);
        for lookup in LOOKUPS {
            let near = |got: &[[f64; 4]], bound: f64, what: &str| {
                let mut errors = Errors::new(format!("{size:?}, {lookup}, {what}"), bound);
                for (got, sample) in got.iter().zip(&samples) {
                    note(&mut errors, *got, by_hand(&hcbtf, sample, lookup), || {
                        format!("{sample:?}")
                    });
                }
                errors.finish();
            };
            let on = |renderer: &mut Renderer, tier: &str, samples: &[EvalSample]| {
                let look = stored_as("blocks", &path, lookup, tier);
                eval_on(renderer, &look, Library::built_in(), &options(""), samples)
            };
            near(&on(&mut renderer(), "exact", &samples), 4e-5, "exact");
            near(&on(&mut renderer(), "balanced", &samples), BALANCED, "balanced");
            near(&on(&mut plain, "exact", &samples), 4e-5, "decoded");
            near(
                &truth(&stored_as("blocks", &path, lookup, "exact"), "", &samples[..60]),
                1e-7,
                "f64",
            );
        }
    }
}

#[test]
fn a_device_without_blocks_says_so_once_and_draws_the_same() {
    let path = file("blocks_told", &strokes([13, 6]));
    let setup = |storage: &str| {
        let look = stored_as(storage, &path, "smooth", "exact");
        let (mesh, matrix) = shape("waves");
        scene_of(
            vec![(look.clone(), mesh.clone(), matrix), (look, mesh, matrix)],
            Default::default(),
        )
    };
    let options = PlanOptions { size: [64, 48], samples: 1, time: 0.0 };
    let plan = |storage: &str| {
        let mut planner = Planner::new(Assets::default());
        planner
            .plan(&setup(storage), Library::built_in(), &Default::default(), &options)
            .unwrap()
            .value
    };
    let plan_of_blocks = plan("blocks");
    let mut plain = Renderer::new(without_blocks());
    let told = plain.gpu().warnings(&plan_of_blocks);
    assert_eq!(told.iter().map(|told| told.code).collect::<Vec<_>>(), ["no-blocks"]);
    assert!(plain.gpu().warnings(&plan("quick")).is_empty());
    assert!(renderer().gpu().warnings(&plan_of_blocks).is_empty());
    let decoded = block_on(plain.picture(&plan_of_blocks)).unwrap();
    assert!(decoded.rgba.iter().any(|pixel| pixel[0] > 0.1), "something is seen");
    assert!(block_on(renderer().picture(&plan_of_blocks)).unwrap() == decoded);
}

/// The loss that docs/performance.md states for the examples.
#[test]
fn the_examples_lose_little() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/hcbtf");
    for name in ["pencil", "halftone"] {
        let hcbtf = load(&Disk, &folder.join(format!("{name}.hcbtf"))).unwrap().value;
        let filled = fill(&hcbtf, &Progress::new()).unwrap();
        let found = loss(&hcbtf.grid, |address| filled.tile(address), &blocks_of(&hcbtf));
        println!("{name}: {found:?}");
        assert!(found.rms > 0.0 && found.rms < 4.0 && found.largest < 64.0, "{name}: {found:?}");
    }
}
