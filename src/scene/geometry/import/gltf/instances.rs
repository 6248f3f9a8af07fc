//! Copies of one node's mesh (`EXT_mesh_gpu_instancing`): accessors of moves, turns and scales, in
//! the node's space.

use chiaro_locale::tr;
use glam::{DMat4, DQuat, DVec3};
use gltf::accessor::Dimensions;
use gltf::{Document, Mesh, Node};

use super::accessor;
use super::motion::MeshPlace;
use crate::diag::Diagnostic;
use crate::geometry::import::MAX_VERTICES;
use crate::geometry::import::report::ImportProblem;
use crate::geometry::import::source::Source;

/// The name of the extension for instances.
pub(super) const INSTANCING: &str = "EXT_mesh_gpu_instancing";

/// A mesh with the transforms of its copies.
pub(super) struct PlacedMesh<'a> {
    pub(super) mesh: Mesh<'a>,
    /// Number of the node that has the mesh.
    node: u32,
    /// Transform of the node, from its own space to the scene's.
    world: DMat4,
    /// Copies of the mesh, if the node asks for them: then no mesh stands at the node itself.
    instances: Option<Instances>,
}

/// Transforms of the copies of a mesh; a list that the file lacks is `None`.
struct Instances {
    count: usize,
    translations: Option<Vec<[f64; 3]>>,
    rotations: Option<Vec<[f64; 4]>>,
    scales: Option<Vec<[f64; 3]>>,
}

impl<'a> PlacedMesh<'a> {
    /// Reads the mesh of a node with the copies that the node asks for. `drawn` counts the
    /// primitives of the whole file, each as often as it is drawn.
    ///
    /// # Errors
    /// Where an accessor is missing or cannot be read, and where there are more primitives than
    /// vertices are allowed.
    pub(super) fn read(
        document: &Document,
        node: &Node<'a>,
        world: DMat4,
        buffers: &[Source],
        drawn: &mut usize,
    ) -> Result<Option<Self>, ImportProblem> {
        let Some(mesh) = node.mesh() else { return Ok(None) };
        let mut instances = None;
        if let Some(extension) = node.extension_value(INSTANCING) {
            let named = InstanceAccessors {
                document,
                node: node.index(),
                attributes: &extension["attributes"],
            };
            let count = |count| count_drawn(&mesh, count, drawn);
            instances = named.read(buffers, count)?;
        }
        if instances.is_none() {
            count_drawn(&mesh, 1, drawn)?;
        }
        Ok(Some(Self { mesh, node: node.index() as u32, world, instances }))
    }

    /// The transforms from the mesh's space to the scene's with the places within the node, one for
    /// each copy of the mesh.
    pub(super) fn places(&self) -> impl Iterator<Item = (DMat4, MeshPlace)> + '_ {
        let count = self.instances.as_ref().map_or(1, |instances| instances.count);
        let local = |index| {
            self.instances.as_ref().map_or(DMat4::IDENTITY, |instances| instances.local(index))
        };
        (0..count).map(move |index| {
            let instance = local(index);
            (self.world * instance, MeshPlace { node: self.node, instance })
        })
    }
}

/// Adds the primitives of `copies` of a mesh to `drawn`. Even primitives without triangles are
/// bounded: they take no memory, but time.
fn count_drawn(mesh: &Mesh, copies: usize, drawn: &mut usize) -> Result<(), ImportProblem> {
    *drawn = drawn.saturating_add(copies.saturating_mul(mesh.primitives().len()));
    if *drawn > MAX_VERTICES {
        let message = tr!("the scene has more than {MAX_VERTICES} primitives in their places");
        return Err(Diagnostic::error("mesh-too-large", message).into());
    }
    Ok(())
}

impl Instances {
    fn local(&self, index: usize) -> DMat4 {
        let at = |list: &Option<Vec<[f64; 3]>>| list.as_ref().map(|list| DVec3::from(list[index]));
        let turn = self.rotations.as_ref().map(|list| DQuat::from_array(list[index]).normalize());
        DMat4::from_scale_rotation_translation(
            at(&self.scales).unwrap_or(DVec3::ONE),
            turn.unwrap_or(DQuat::IDENTITY),
            at(&self.translations).unwrap_or(DVec3::ZERO),
        )
    }
}

/// The accessors that a node names for the transforms of its copies.
struct InstanceAccessors<'d, 'j> {
    document: &'d Document,
    node: usize,
    attributes: &'j gltf::json::Value,
}

impl<'d> InstanceAccessors<'d, '_> {
    fn wrong(&self, why: &str) -> ImportProblem {
        let message = tr!("node {node} has wrong {INSTANCING}: {why}", node = self.node);
        Box::new(Diagnostic::error("mesh-syntax", message))
    }

    fn accessor(
        &self,
        name: &str,
        dimensions: Dimensions,
    ) -> Result<Option<gltf::Accessor<'d>>, ImportProblem> {
        let Some(index) = self.attributes.get(name) else { return Ok(None) };
        let index = index.as_u64().and_then(|index| usize::try_from(index).ok());
        let accessor = index.and_then(|index| self.document.accessors().nth(index));
        match accessor {
            Some(accessor) if accessor.dimensions() == dimensions => Ok(Some(accessor)),
            Some(_) => Err(self.wrong(&tr!("{name} is of another type"))),
            None => Err(self.wrong(&tr!("{name} names no accessor"))),
        }
    }

    /// Reads the accessors once `check` has accepted their count.
    fn read(
        &self,
        buffers: &[Source],
        check: impl FnOnce(usize) -> Result<(), ImportProblem>,
    ) -> Result<Option<Instances>, ImportProblem> {
        let translations = self.accessor("TRANSLATION", Dimensions::Vec3)?;
        let rotations = self.accessor("ROTATION", Dimensions::Vec4)?;
        let scales = self.accessor("SCALE", Dimensions::Vec3)?;
        let counts: Vec<usize> = [&translations, &rotations, &scales]
            .into_iter()
            .flatten()
            .map(gltf::Accessor::count)
            .collect();
        // Without any of these accessors, other attributes may count copies that all stand in one
        // place.
        let Some(&count) = counts.first() else { return Ok(None) };
        if counts.iter().any(|&other| other != count) {
            return Err(self.wrong(tr!("its attributes have different counts")));
        }
        check(count)?;
        let rows3 = |accessor: Option<gltf::Accessor>| {
            accessor.map(|accessor| accessor::rows::<3>(&accessor, buffers, 0.0)).transpose()
        };
        let rotations = rotations.map(|accessor| accessor::rows::<4>(&accessor, buffers, 0.0));
        Ok(Some(Instances {
            count,
            translations: rows3(translations)?,
            rotations: rotations.transpose()?,
            scales: rows3(scales)?,
        }))
    }
}
