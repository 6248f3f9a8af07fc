//! Store of a device: meshes, images and pipelines on the GPU, shared by all pictures.

use super::deferred::DeferredStore;
use super::image::Images;
use super::mesh::Meshes;
use super::pipeline::Pipelines;

/// Resources that were uploaded to a device and compiled for it. Each mesh and each image is
/// uploaded once, and each module compiled once, whichever pictures draw with it; resources that no
/// picture uses any more are dropped. Clones are handles to the same store.
#[derive(Clone, Debug, Default)]
pub(super) struct Store {
    pub(super) meshes: Meshes,
    pub(super) images: Images,
    pub(super) pipelines: Pipelines,
    pub(super) deferred: DeferredStore,
}

impl Store {
    /// Drops meshes and images that have no holder any more.
    pub(super) fn keep_recent(&self) {
        self.meshes.keep_recent();
        self.images.keep_recent();
        self.deferred.meshes.keep_recent();
    }

    /// Drops all resources, after the device ran out of memory: those created then must not be
    /// found again.
    pub(super) fn clear(&self) {
        self.meshes.clear();
        self.images.clear();
        self.pipelines.clear();
        self.deferred.meshes.clear();
        self.deferred.pipelines.clear();
    }
}

/// Numbers of uploads to a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UploadCounts {
    /// Uploads of meshes, each mesh counted once, whichever of its attributes came later.
    pub meshes: u64,
    /// Uploads of images and HCBTFs; changes of parts are not counted.
    pub images: u64,
}
