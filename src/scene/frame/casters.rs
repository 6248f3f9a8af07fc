//! Casters: the triangles of all objects, as shaders send rays past them.
//!
//! What a shader reads is one texture, whose layout `shaders/lib/casters.wgsl` tells: the objects'
//! rows, trees over those objects that cast some light's shadows onto some object, and the
//! [trees](MeshTree) of the objects' meshes. A mesh's tree is made once, wherever the mesh stands:
//! when an object moves, only the first rows are made anew.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

use chiaro_locale::tr;
use glam::{DMat4, DVec3};
use indexmap::IndexSet;

use super::setup::SetupObject;
use super::visibility::ObjectPlacement;
use crate::diag::Diagnostic;
use crate::document::LightValues;
use crate::geometry::{Bounds, Mesh, MeshTree, tree_of_boxes};

/// Number of texels in a row of the texture, a power of 2.
const ROW: usize = 1 << 11;

/// Most rows of the texture: what every GPU takes.
const MOST_ROWS: usize = 1 << 13;

/// Number of texels of an object's row.
const OBJECT: usize = 5;

/// Share of its size by which the box of an object grows, for the roundings of rays.
const AROUND: f64 = 1e-6;

/// Texture of all triangles that cast shadows.
#[derive(Clone, Debug, Default)]
pub struct Casters {
    /// Texels before the meshes' trees.
    head: Vec<[f64; 4]>,
    /// Trees of meshes, one after another, each from the beginning of a row.
    trees: Vec<Arc<MeshTree>>,
    /// Texels of the trees over objects, by the objects' numbers.
    roots: HashMap<Vec<usize>, usize>,
    /// Hash of everything that is in it.
    hash: u64,
}

impl Casters {
    /// The casters of a scene's objects. `sets` are sets of objects, by number and in order, that
    /// cast some light's shadows; `occluders` are those of them that stand about an object, by the
    /// object's number.
    ///
    /// # Errors
    /// `too-many-casters` for more triangles than the texture can hold.
    pub(super) fn new(
        objects: &[SetupObject],
        placed: &[ObjectPlacement],
        sets: &IndexSet<Vec<usize>>,
        occluders: &HashMap<usize, usize>,
    ) -> Result<Self, Diagnostic> {
        let mut made = Self::default();
        let mut hasher = DefaultHasher::new();
        // The places of meshes follow from the size of the head, which follows from the sets.
        let nodes = |set: &Vec<usize>| 2 * (2 * set.len()).saturating_sub(1);
        let head = OBJECT * objects.len() + sets.iter().map(nodes).sum::<usize>();
        let mut at = head.next_multiple_of(ROW);
        let mut places: HashMap<*const Mesh, usize> = HashMap::new();
        for (number, object) in objects.iter().enumerate() {
            let tree = object.mesh.tree();
            let begin = *places.entry(Arc::as_ptr(&object.mesh)).or_insert_with(|| {
                made.trees.push(tree.clone());
                let begin = at;
                at += tree.texels.len().next_multiple_of(ROW);
                begin
            });
            let rows = tree.from_world(object.world_from_object).transpose();
            made.head.extend([rows.x_axis, rows.y_axis, rows.z_axis].map(|row| row.to_array()));
            let counts = [tree.nodes, tree.triangles].map(f64::from);
            made.head.push([begin as f64, counts[0], number as f64, counts[1]]);
            made.head.push([LightValues::NO_CASTERS, 0.0, 0.0, 0.0]);
        }
        let most = ROW * MOST_ROWS;
        if at > most {
            let triangles: u64 = made.trees.iter().map(|tree| u64::from(tree.triangles)).sum();
            let message = tr!(
                "the {triangles} triangles of the scene's meshes are too many to cast shadows: \
                 they take {at} texels, and {most} is the most"
            );
            return Err(Diagnostic::error("too-many-casters", message)
                .hint(tr!("use simpler meshes, or no nodes that ask for shadows")));
        }
        let boxes: Vec<[DVec3; 2]> = objects
            .iter()
            .zip(placed)
            .map(|(object, placed)| box_of(object.world_from_object, &placed.bounds))
            .collect();
        for set in sets {
            if !set.is_empty() {
                made.roots.insert(set.clone(), made.head.len());
                made.push_tree(set, &boxes);
            }
        }
        for (object, set) in occluders {
            let set = &sets[*set];
            let casters = made.number(set, set.binary_search(object).is_ok());
            made.head[OBJECT * object + 4][0] = casters;
        }
        for texel in &made.head {
            texel.map(f64::to_bits).hash(&mut hasher);
        }
        for tree in &made.trees {
            (Arc::as_ptr(tree) as usize).hash(&mut hasher);
        }
        made.hash = hasher.finish();
        Ok(made)
    }

    /// Adds the tree over some objects.
    fn push_tree(&mut self, set: &[usize], boxes: &[[DVec3; 2]]) {
        let own: Vec<[DVec3; 2]> = set.iter().map(|number| boxes[*number]).collect();
        let root = self.head.len();
        for node in tree_of_boxes(&own) {
            let after = (root + 2 * node.after as usize) as f64;
            let holds = node.holds.map_or(-1.0, |held| (OBJECT * set[held as usize]) as f64);
            self.head.push(node.least.extend(after).to_array());
            self.head.push(node.greatest.extend(holds).to_array());
        }
    }

    /// [`LightValues::casters`] of a light whose shadows these objects cast, by number and in
    /// order, onto an object that casts them onto itself or not.
    pub(super) fn number(&self, set: &[usize], onto_itself: bool) -> f64 {
        let root = self.roots.get(set).map_or(LightValues::NO_CASTERS, |root| 2.0 * *root as f64);
        root + f64::from(u8::from(onto_itself))
    }

    /// Width and height of the texture.
    pub fn size(&self) -> [u32; 2] {
        let trees = self.trees.iter().map(|tree| tree.texels.len().div_ceil(ROW));
        let rows = self.head.len().div_ceil(ROW) + trees.sum::<usize>();
        [ROW as u32, rows.max(1) as u32]
    }

    /// Hash of everything that is in it: the same hash is the same texture.
    pub fn hash(&self) -> u64 {
        self.hash
    }

    /// All texels, row by row.
    pub fn texels(&self) -> Vec<[f64; 4]> {
        let [width, height] = self.size().map(|side| side as usize);
        let mut texels = self.head.clone();
        let fill = |texels: &mut Vec<[f64; 4]>| {
            texels.resize(texels.len().next_multiple_of(ROW), [0.0; 4]);
        };
        for tree in &self.trees {
            fill(&mut texels);
            texels.extend(tree.texels.iter().map(|texel| texel.map(f64::from)));
        }
        texels.resize(width * height, [0.0; 4]);
        texels
    }

    /// The first rows of the texture in f32, which hold everything but the meshes' trees.
    pub fn head(&self) -> Vec<[f32; 4]> {
        let mut head: Vec<[f32; 4]> =
            self.head.iter().map(|texel| texel.map(|number| number as f32)).collect();
        head.resize(head.len().next_multiple_of(ROW).max(ROW), [0.0; 4]);
        head
    }

    /// The trees of meshes, in the order in which they follow the first rows; each begins a row.
    pub fn trees(&self) -> &[Arc<MeshTree>] {
        &self.trees
    }
}

/// The box around an object in world space, a little larger.
fn box_of(world_from_object: DMat4, bounds: &Bounds) -> [DVec3; 2] {
    let corners = bounds.corners().map(|corner| world_from_object.transform_point3(corner));
    let least = corners.into_iter().fold(DVec3::INFINITY, DVec3::min);
    let most = corners.into_iter().fold(DVec3::NEG_INFINITY, DVec3::max);
    let far = least.abs().max(most.abs()).max_element() + (most - least).max_element();
    [least - AROUND * far, most + AROUND * far]
}
