//! What all pictures of a device share: meshes, images and pipelines on the GPU.

use super::image::Images;
use super::mesh::Meshes;
use super::pipeline::Pipelines;

/// What was uploaded to a device and compiled for it. Each mesh and each image is uploaded once,
/// and each module compiled once, whichever pictures draw with it; what nobody draws with any more
/// goes. Clones are handles to the same store.
#[derive(Clone, Debug, Default)]
pub(super) struct Store {
    pub(super) meshes: Meshes,
    pub(super) images: Images,
    pub(super) pipelines: Pipelines,
}

impl Store {
    /// Drops what nobody holds any more.
    pub(super) fn keep_recent(&self) {
        self.meshes.keep_recent();
        self.images.keep_recent();
    }

    /// Forgets everything, after the device had no room: nobody else is to find what was made
    /// then.
    pub(super) fn clear(&self) {
        self.meshes.clear();
        self.images.clear();
        self.pipelines.clear();
    }
}

/// How often meshes and images were handed to a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UploadCounts {
    /// Meshes, each counted once whatever attributes of it came later.
    pub meshes: u64,
    /// Images and HCBTFs; changes of parts are not counted.
    pub images: u64,
}
