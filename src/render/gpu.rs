//! The GPU: a device and its queue.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use chiaro_locale::tr;

use super::error::{LimitedSize, RenderError};
use super::store::{Store, UploadCounts};
use super::target::PICTURE;
use crate::diag::Diagnostic;
use crate::frame::FramePlan;
use crate::hcbtf::TexelCoding;
use crate::{hcbtf, milestones};

/// Format of pictures in 32-bit floats.
const FLOATS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

/// A device of our own or of a window, with its store of uploaded resources.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// The device.
    pub device: wgpu::Device,
    /// Command queue of the device.
    pub queue: wgpu::Queue,
    /// Description of the adapter.
    pub info: wgpu::AdapterInfo,
    /// Format that pictures are drawn in.
    pub(super) picture: wgpu::TextureFormat,
    /// True if the device can blend and average several samples of 32-bit floats.
    samples_floats: bool,
    /// Errors that no scope caught, and the loss of the device.
    problem: Arc<Mutex<Option<RenderError>>>,
    /// Resources that were uploaded and compiled, shared by all renderers.
    pub(super) store: Store,
}

/// Guard that catches errors of the device while it lives.
///
/// Fields are dropped in their order, and the error scope that was pushed last must be popped
/// first: a function that returned early would end the program otherwise.
pub(super) struct ErrorGuard {
    validation: wgpu::ErrorScopeGuard,
    memory: wgpu::ErrorScopeGuard,
    problem: Arc<Mutex<Option<RenderError>>>,
}

/// Descriptor of the device to open on an adapter: all of the adapter's limits, and timestamps,
/// blending of 32-bit floats and compressed textures if it has them.
pub fn device_descriptor(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
    wgpu::DeviceDescriptor {
        label: Some("chiaro"),
        required_features: adapter.features()
            & (wgpu::Features::TIMESTAMP_QUERY
                | wgpu::Features::FLOAT32_BLENDABLE
                | wgpu::Features::TEXTURE_COMPRESSION_BC),
        required_limits: adapter.limits(),
        ..wgpu::DeviceDescriptor::default()
    }
}

impl Gpu {
    /// Opens the best adapter of the system, a software renderer if need be.
    ///
    /// # Errors
    /// A system without adapters, and an adapter that gives no device.
    pub async fn headless() -> Result<Self, RenderError> {
        let mut failure = tr!("no backend was tried").to_owned();
        let mut found = None;
        // OpenGL is tried last: its libraries print messages about missing displays.
        let wanted = wgpu::Backends::from_env()
            .map_or(vec![wgpu::Backends::PRIMARY, wgpu::Backends::GL], |one| vec![one]);
        for backends in wanted {
            let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
            descriptor.backends = backends;
            let options = wgpu::RequestAdapterOptions {
                power_preference: wgpu::PowerPreference::HighPerformance,
                ..wgpu::RequestAdapterOptions::default()
            };
            match wgpu::Instance::new(descriptor).request_adapter(&options).await {
                Ok(adapter) => {
                    found = Some(adapter);
                    break;
                }
                Err(error) => failure = error.to_string(),
            }
        }
        let adapter = found.ok_or(RenderError::NoAdapter { message: failure })?;
        milestones::reached("adapter");
        let mut descriptor = device_descriptor(&adapter);
        // What a format can do beyond what WebGPU says of all devices.
        let own = wgpu::Features::TEXTURE_ADAPTER_SPECIFIC_FORMAT_FEATURES;
        descriptor.required_features |= adapter.features() & own;
        let refused =
            |error: wgpu::RequestDeviceError| RenderError::NoAdapter { message: error.to_string() };
        let (device, queue) = adapter.request_device(&descriptor).await.map_err(refused)?;
        milestones::reached("device");
        let samples_floats = device.features().contains(own) && {
            let flags = adapter.get_texture_format_features(FLOATS).flags;
            flags.contains(
                wgpu::TextureFormatFeatureFlags::MULTISAMPLE_X4
                    | wgpu::TextureFormatFeatureFlags::MULTISAMPLE_RESOLVE
                    | wgpu::TextureFormatFeatureFlags::BLENDABLE,
            )
        };
        Ok(Self { samples_floats, ..Self::new(device, queue, adapter.get_info()) })
    }

    /// Wraps a device that was opened by others.
    pub fn new(device: wgpu::Device, queue: wgpu::Queue, info: wgpu::AdapterInfo) -> Self {
        let problem = Arc::new(Mutex::new(None));
        let lost = problem.clone();
        device.set_device_lost_callback(move |reason, message| {
            if reason != wgpu::DeviceLostReason::Destroyed {
                set(&lost, RenderError::Lost { message });
            }
        });
        let uncaught = problem.clone();
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            set(&uncaught, from_wgpu(error));
        }));
        let store = Store::default();
        Self { device, queue, info, picture: PICTURE, samples_floats: false, problem, store }
    }

    /// The device with pictures in 32-bit floats if it can blend them: for comparisons, with one
    /// sample a pixel.
    #[must_use]
    pub fn precise(&self) -> Self {
        let can = self.device.features().contains(wgpu::Features::FLOAT32_BLENDABLE);
        Self { picture: if can { FLOATS } else { PICTURE }, ..self.clone() }
    }

    /// The device with pictures and layers in 32-bit floats, with so many samples a pixel.
    ///
    /// # Errors
    /// A warning of a device that cannot blend or average them.
    pub fn in_floats(&self, samples: u32) -> Result<Self, Diagnostic> {
        let blends = self.device.features().contains(wgpu::Features::FLOAT32_BLENDABLE);
        if blends && (samples == 1 || self.samples_floats) {
            return Ok(self.precise());
        }
        let gpu = self.name();
        let (message, hint) = if blends {
            let message = tr!(
                "{gpu} cannot average samples in 32 bits: numbers are drawn in 16 bits and written \
                 in 32"
            );
            (message, tr!("`--samples 1` draws in 32 bits"))
        } else {
            let message = tr!(
                "{gpu} cannot blend in 32 bits: numbers are drawn in 16 bits and written in 32"
            );
            (message, tr!("`--on reference` can"))
        };
        Err(Diagnostic::warning("no-floats", message).hint(hint))
    }

    /// The device with a store of its own, which frees its resources when it is dropped: for
    /// callers that draw many looks once each.
    #[must_use]
    pub fn with_own_store(&self) -> Self {
        Self { store: Store::default(), ..self.clone() }
    }

    /// Numbers of uploads of meshes and images, by all renderers that share this device's store.
    pub fn uploads(&self) -> UploadCounts {
        UploadCounts { meshes: self.store.meshes.uploads(), images: self.store.images.uploads() }
    }

    /// Number of pipelines of looks, and of the passes before them that draw meshes, that this
    /// device's store keeps.
    pub fn pipelines(&self) -> usize {
        self.store.pipelines.count()
    }

    /// True if the adapter is a software renderer.
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// True if the device can time passes by its own clock.
    pub fn has_timestamps(&self) -> bool {
        self.device.features().contains(wgpu::Features::TIMESTAMP_QUERY)
    }

    /// True if textures can be compressed blocks (BC7); for other devices they are decoded before
    /// they are uploaded.
    pub fn has_blocks(&self) -> bool {
        self.device.features().contains(wgpu::Features::TEXTURE_COMPRESSION_BC)
    }

    /// Warnings about drawing `plan` on this device: textures that must be decoded for it.
    pub fn warnings(&self, plan: &FramePlan) -> Vec<Diagnostic> {
        let images = plan.draws.iter().flat_map(|draw| &draw.images);
        let blocks = images
            .filter(|image| image.coding == TexelCoding::Bc7)
            .map(|image| (image.hash, image.bytes.len()));
        let decoded: usize =
            blocks.collect::<HashMap<_, _>>().into_values().map(|bytes| 4 * bytes).sum();
        if self.has_blocks() || decoded == 0 {
            return Vec::new();
        }
        let message = tr!(
            "{gpu} has no compressed textures: painted surfaces (HCBTFs) take {mib} MiB there",
            gpu = self.name(),
            mib = decoded >> 20
        );
        let hint = tr!("the picture is the same; the storage `compact` may take less here");
        vec![Diagnostic::warning("no-blocks", message).hint(hint)]
    }

    /// Name of the adapter and its backend, for reports.
    pub fn name(&self) -> String {
        format!("{} ({:?})", self.info.name, self.info.backend)
    }

    /// Largest textures of HCBTFs that the device can hold.
    pub fn holds(&self) -> hcbtf::Device {
        let limits = self.device.limits();
        let [side, layers] =
            [limits.max_texture_dimension_2d, limits.max_texture_array_layers].map(u64::from);
        hcbtf::Device {
            name: self.name(),
            limits: hcbtf::Limits { side, layers, has_blocks: self.has_blocks() },
        }
    }

    /// The most layers that one draw can write beside the picture.
    pub fn most_layers(&self) -> usize {
        let limits = self.device.limits();
        let texel = self.picture.target_pixel_byte_cost().unwrap_or(8);
        let targets =
            limits.max_color_attachments.min(limits.max_color_attachment_bytes_per_sample / texel);
        targets.saturating_sub(1) as usize
    }

    /// Waits until the GPU has finished all submitted work.
    pub(super) fn wait(&self) -> Result<(), RenderError> {
        let waited = self.device.poll(wgpu::PollType::wait_indefinitely());
        waited.map(drop).map_err(|error| RenderError::Lost { message: error.to_string() })
    }

    /// Begins to catch errors of the device.
    pub(super) fn guard(&self) -> ErrorGuard {
        ErrorGuard {
            memory: self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory),
            validation: self.device.push_error_scope(wgpu::ErrorFilter::Validation),
            problem: self.problem.clone(),
        }
    }

    /// Checks that a target of `size` pixels is possible.
    pub(super) fn check_size(&self, size: [u32; 2]) -> Result<(), RenderError> {
        let limit = self.device.limits().max_texture_dimension_2d;
        let side = size[0].max(size[1]);
        if side > limit {
            return Err(RenderError::TooLarge {
                what: LimitedSize::PictureSide,
                size: side.into(),
                limit: limit.into(),
            });
        }
        Ok(())
    }
}

fn set(slot: &Mutex<Option<RenderError>>, error: RenderError) {
    slot.lock().unwrap_or_else(std::sync::PoisonError::into_inner).get_or_insert(error);
}

fn from_wgpu(error: wgpu::Error) -> RenderError {
    match error {
        wgpu::Error::OutOfMemory { .. } => {
            let message = tr!("the GPU has not enough memory for this picture").to_owned();
            RenderError::OutOfMemory { message }
        }
        wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. } => {
            RenderError::Refused { message: description }
        }
    }
}

impl ErrorGuard {
    /// Stops catching errors, and returns the first one.
    pub(super) async fn finish(self) -> Result<(), RenderError> {
        let validation = self.validation.pop().await;
        let memory = self.memory.pop().await;
        let uncaught =
            self.problem.lock().unwrap_or_else(std::sync::PoisonError::into_inner).take();
        match memory.or(validation).map(from_wgpu).or(uncaught) {
            None => Ok(()),
            Some(error) => Err(error),
        }
    }
}
