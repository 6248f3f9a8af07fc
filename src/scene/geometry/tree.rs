//! Trees of boxes over the triangles of meshes, for rays.
//!
//! A [`MeshTree`] is a list of texels, as `shaders/lib/casters.wgsl` reads them: shaders walk it
//! without a stack, because each node names the one that follows where its box is missed.

use std::sync::Arc;

use glam::{DMat4, DVec3, Vec3, Vec3A};
use obvhs::Boundable;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use super::mesh::Mesh;

/// Space around boxes for the roundings of rays that meet them, for places of about 1.
const AROUND: f32 = 2e-6;

/// Most triangles of a node.
const MOST_IN_NODE: u32 = 4;

/// A tree over the triangles of a mesh.
///
/// First come the nodes, two texels each: the least corner of the box and the number of the node
/// that follows where the box is missed; the greatest corner and the number of the node's first
/// triangle, or -1 where more nodes come next. Then the triangles, three corners each, whose fourth
/// number is 1 where the next triangle is of the same node; last the normals at these corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshTree {
    /// Texels of the tree.
    pub texels: Vec<[f32; 4]>,
    /// Number of nodes.
    pub nodes: u32,
    /// Number of triangles.
    pub triangles: u32,
    /// Middle of the mesh's box, in object space, which is the origin of the tree's.
    center: DVec3,
    /// Factor of sizes from object space to the tree's: a power of 2, so that nothing is rounded.
    scale: f64,
    /// Numbers of the mesh's triangles in the tree's order, shared with the tree's refittings.
    order: Arc<[u32]>,
}

/// Share of the nodes that are put elsewhere where that makes the tree better.
const REINSERTED: f32 = 0.02;

/// Cost of a node beside that of a triangle.
const NODE_COST: f32 = 2.0;

/// Order in which a tree's nodes are walked.
struct Walk {
    /// Nodes, each before all that it holds.
    nodes: Vec<u32>,
    /// By place in the walk: the place of the node after all that this one holds.
    after: Vec<u32>,
}

impl Walk {
    fn new(tree: &Bvh2) -> Self {
        let mut nodes = Vec::with_capacity(tree.nodes.len());
        let mut open = if tree.nodes.is_empty() { Vec::new() } else { vec![0_u32] };
        while let Some(index) = open.pop() {
            nodes.push(index);
            let node = &tree.nodes[index as usize];
            if !node.is_leaf() {
                open.extend([node.first_index + 1, node.first_index]);
            }
        }
        // What a node holds lies after it, so that sizes are known from the end on.
        let mut sizes = vec![1_u32; tree.nodes.len()];
        for &index in nodes.iter().rev() {
            let node = &tree.nodes[index as usize];
            if !node.is_leaf() {
                let [a, b] = [node.first_index, node.first_index + 1].map(|i| sizes[i as usize]);
                sizes[index as usize] = 1 + a + b;
            }
        }
        let after = (0..).zip(&nodes).map(|(place, index)| place + sizes[*index as usize]);
        Self { after: after.collect(), nodes }
    }
}

/// A box for a tree.
struct BuilderBox(Aabb);

impl Boundable for BuilderBox {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

/// A node of a tree over boxes, in the order in which rays walk it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxNode {
    /// Least corner.
    pub least: DVec3,
    /// Greatest corner.
    pub greatest: DVec3,
    /// Place of the node that follows where the box is missed.
    pub after: u32,
    /// The box that the node holds; `None` where more nodes come next.
    pub holds: Option<u32>,
}

/// The tree over boxes given by their least and greatest corners, a box a leaf.
pub fn tree_of_boxes(boxes: &[[DVec3; 2]]) -> Vec<BoxNode> {
    let corner = |v: DVec3| Vec3A::from(v.as_vec3());
    let boxed = |[least, greatest]: &[DVec3; 2]| {
        BuilderBox(Aabb { min: corner(*least), max: corner(*greatest) })
    };
    let tree = built(&boxes.iter().map(boxed).collect::<Vec<_>>(), 1);
    let walk = Walk::new(&tree);
    let mut nodes: Vec<BoxNode> = Vec::with_capacity(walk.nodes.len());
    let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for (&index, &after) in walk.nodes.iter().zip(&walk.after) {
        let node = &tree.nodes[index as usize];
        let held = node.is_leaf().then(|| tree.primitive_indices[node.first_index as usize]);
        let (least, greatest) = match held {
            Some(held) => (boxes[held as usize][0], boxes[held as usize][1]),
            None => none,
        };
        nodes.push(BoxNode { least, greatest, after, holds: held });
    }
    // Boxes of what a node holds, known from the end on.
    for place in (0..nodes.len()).rev() {
        let end = nodes[place].after as usize;
        let mut inner = place + 1;
        while inner < end {
            let BoxNode { least, greatest, after, .. } = nodes[inner];
            nodes[place].least = nodes[place].least.min(least);
            nodes[place].greatest = nodes[place].greatest.max(greatest);
            inner = after as usize;
        }
    }
    nodes
}

fn built<T: Boundable>(boxes: &[T], most: u32) -> Bvh2 {
    if boxes.is_empty() {
        return Bvh2::default();
    }
    let all = (0..boxes.len() as u32).collect();
    let mut tree = PlocBuilder::with_capacity(boxes.len()).build(
        PlocSearchDistance::Low,
        boxes,
        all,
        SortPrecision::U64,
        0,
    );
    ReinsertionOptimizer::default().run(&mut tree, REINSERTED, None);
    collapse(&mut tree, most, NODE_COST);
    tree
}

/// The origin of a mesh's tree, and the factor of sizes from object space to the tree's.
fn frame_of(mesh: &Mesh) -> (DVec3, f64) {
    let bounds = mesh.bounds();
    let reach = 0.5 * bounds.size().max_element();
    (bounds.center(), if reach > 0.0 { (-reach.log2().ceil()).exp2() } else { 1.0 })
}

/// The place of a vertex in the space of a tree.
fn placed_in(mesh: &Mesh, (center, scale): (DVec3, f64)) -> impl Fn(u32) -> Vec3 + '_ {
    move |index| {
        let place = DVec3::from(mesh.positions[index as usize].map(f64::from));
        ((place - center) * scale).as_vec3()
    }
}

impl MeshTree {
    /// The tree over all triangles of a mesh.
    pub fn new(mesh: &Mesh) -> Self {
        let (center, scale) = frame_of(mesh);
        let placed = placed_in(mesh, (center, scale));
        let corners = mesh.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]);
        let corners: Vec<[u32; 3]> = corners.collect();
        let boxes = corners.iter().map(|corners| {
            let [a, b, c] = corners.map(&placed);
            BuilderBox(Aabb { min: a.min(b).min(c).into(), max: a.max(b).max(c).into() })
        });
        let tree = built(&boxes.collect::<Vec<_>>(), MOST_IN_NODE);
        let walk = Walk::new(&tree);
        let mut made = Self {
            texels: Vec::with_capacity(2 * walk.nodes.len() + 6 * corners.len()),
            nodes: walk.nodes.len() as u32,
            triangles: corners.len() as u32,
            center,
            scale,
            order: Arc::default(),
        };
        // Triangles in the order in which the walk comes to them, and whether more follow.
        let mut order: Vec<(u32, bool)> = Vec::with_capacity(corners.len());
        for (&index, &after) in walk.nodes.iter().zip(&walk.after) {
            let node = &tree.nodes[index as usize];
            let holds = if node.is_leaf() { order.len() as f32 } else { -1.0 };
            let [least, greatest] = [node.aabb().min - AROUND, node.aabb().max + AROUND];
            made.texels.push([least.x, least.y, least.z, after as f32]);
            made.texels.push([greatest.x, greatest.y, greatest.z, holds]);
            if node.is_leaf() {
                let held = node.first_index..node.first_index + node.prim_count;
                let last = held.end - 1;
                order.extend(held.map(|i| (tree.primitive_indices[i as usize], i < last)));
            }
        }
        for &(triangle, is_followed) in &order {
            let more = f32::from(u8::from(is_followed));
            let texel = |corner: u32| placed(corner).extend(more).to_array();
            made.texels.extend(corners[triangle as usize].map(texel));
        }
        made.order = order.into_iter().map(|(triangle, _)| triangle).collect();
        made.push_normals(mesh);
        made
    }

    /// Size of the texels in memory, in bytes: all but a small part of the tree.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.texels)
    }

    /// The tree of this one's mesh deformed: the same nodes around the same triangles, which takes
    /// a fraction of the time, and boxes that hold what is in them now.
    #[must_use]
    pub fn refitted(&self, mesh: &Mesh) -> Self {
        let (center, scale) = frame_of(mesh);
        let placed = placed_in(mesh, (center, scale));
        let nodes = self.nodes as usize;
        let mut texels = Vec::with_capacity(self.texels.len());
        texels.extend_from_slice(&self.texels[..2 * nodes]);
        for (number, triangle) in self.order.iter().enumerate() {
            let more = self.texels[2 * nodes + 3 * number][3];
            let start = 3 * *triangle as usize;
            let corners = &mesh.indices[start..start + 3];
            texels.extend(corners.iter().map(|c| placed(*c).extend(more).to_array()));
        }
        // What a node holds lies after it, so that boxes are known from the end on.
        for node in (0..nodes).rev() {
            let (mut least, mut greatest) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let after = texels[2 * node][3];
            let mut triangle = texels[2 * node + 1][3];
            let mut within = node + 1;
            if triangle < 0.0 {
                while within < after as usize {
                    let [low, high] = [texels[2 * within], texels[2 * within + 1]];
                    least = least.min(Vec3::from_slice(&low));
                    greatest = greatest.max(Vec3::from_slice(&high));
                    within = low[3] as usize;
                }
            } else {
                let first = triangle;
                loop {
                    let at = 2 * nodes + 3 * triangle as usize;
                    for corner in &texels[at..at + 3] {
                        least = least.min(Vec3::from_slice(corner) - AROUND);
                        greatest = greatest.max(Vec3::from_slice(corner) + AROUND);
                    }
                    if texels[at][3] < 0.5 {
                        break;
                    }
                    triangle += 1.0;
                }
                triangle = first;
            }
            texels[2 * node] = least.extend(after).to_array();
            texels[2 * node + 1] = greatest.extend(triangle).to_array();
        }
        let mut made = Self { texels, center, scale, ..self.clone_order() };
        made.push_normals(mesh);
        made
    }

    /// A tree of the same counts and order, without texels.
    fn clone_order(&self) -> Self {
        let Self { nodes, triangles, center, scale, .. } = *self;
        Self { texels: Vec::new(), nodes, triangles, center, scale, order: self.order.clone() }
    }

    /// Appends the normals at the triangles' corners.
    fn push_normals(&mut self, mesh: &Mesh) {
        for triangle in self.order.iter() {
            let start = 3 * *triangle as usize;
            self.texels.extend(mesh.indices[start..start + 3].iter().map(|corner| {
                let [x, y, z] = mesh.normals[*corner as usize];
                [x, y, z, 0.0]
            }));
        }
    }

    /// The matrix from world space to the tree's, for an object that stands in the world so; zeros
    /// where the object has no extent in some direction.
    pub fn from_world(&self, world_from_object: DMat4) -> DMat4 {
        let object_from_world = world_from_object.inverse();
        if !object_from_world.is_finite() {
            return DMat4::ZERO;
        }
        DMat4::from_scale(DVec3::splat(self.scale))
            * DMat4::from_translation(-self.center)
            * object_from_world
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::shape;

    /// Every triangle is held once, every box holds what it says, and a walk that misses nothing
    /// goes through all nodes.
    #[test]
    fn a_tree_holds_every_triangle_once() {
        let still = ["sphere", "cube", "city"].map(|name| {
            let mesh = shape(name).expect("a shape");
            let tree = MeshTree::new(&mesh);
            let again = tree.refitted(&mesh);
            let nodes = 2 * tree.nodes as usize;
            assert_eq!(again.texels[nodes..], tree.texels[nodes..], "{name}");
            // Boxes are as tight as they were, or tighter.
            let pairs = again.texels[..nodes].iter().zip(&tree.texels[..nodes]);
            for (at, (own, first)) in pairs.enumerate() {
                let is_within = |axis: usize| match at % 2 {
                    0 => own[axis] >= first[axis],
                    _ => own[axis] <= first[axis],
                };
                assert!(own[3] == first[3] && (0..3).all(is_within), "{name}: {own:?}");
            }
            (name, mesh, tree)
        });
        let bent = still.clone().map(|(name, mut mesh, tree)| {
            mesh.positions.iter_mut().for_each(|[x, y, z]| *x += 0.4 * *y * *y - 3.0 * *z + 7.0);
            let tree = tree.refitted(&mesh);
            (name, mesh, tree)
        });
        for (name, mesh, tree) in still.into_iter().chain(bent) {
            assert_eq!(tree.triangles as usize, mesh.triangle_count(), "{name}");
            let (nodes, triangles) = (tree.nodes as usize, tree.triangles as usize);
            assert_eq!(tree.texels.len(), 2 * nodes + 6 * triangles);
            let mut seen = vec![0; triangles];
            for node in 0..nodes {
                let [least, greatest] = [tree.texels[2 * node], tree.texels[2 * node + 1]];
                let after = least[3] as usize;
                assert!(after > node && after <= nodes, "{name}: walks go upward");
                let mut triangle = greatest[3];
                while triangle >= 0.0 {
                    let at = 2 * nodes + 3 * triangle as usize;
                    for corner in &tree.texels[at..at + 3] {
                        for axis in 0..3 {
                            assert!(corner[axis].abs() <= 1.0);
                            assert!((least[axis]..=greatest[axis]).contains(&corner[axis]));
                        }
                    }
                    seen[triangle as usize] += 1;
                    triangle = if tree.texels[at][3] > 0.5 { triangle + 1.0 } else { -1.0 };
                }
            }
            assert!(seen.iter().all(|count| *count == 1), "{name}");
        }
    }

    #[test]
    fn boxes_of_nodes_hold_those_within() {
        let at = |x: f64| [DVec3::new(x, 0.0, 0.0), DVec3::new(x + 1.0, 2.0, 1.0)];
        let nodes = tree_of_boxes(&[at(0.0), at(5.0), at(-3.0)]);
        assert_eq!(nodes.len(), 5);
        assert_eq!((nodes[0].least.x, nodes[0].greatest.x, nodes[0].after), (-3.0, 6.0, 5));
        let mut held: Vec<u32> = nodes.iter().filter_map(|node| node.holds).collect();
        held.sort_unstable();
        assert_eq!(held, [0, 1, 2]);
        assert!(tree_of_boxes(&[]).is_empty());
        assert_eq!(tree_of_boxes(&[at(1.0)])[0].holds, Some(0));
    }

    #[test]
    fn a_mesh_without_extent_has_a_tree() {
        let empty = MeshTree::new(&Mesh::default());
        assert_eq!((empty.nodes, empty.triangles, empty.texels.len()), (0, 0, 0));
        let flat = DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0));
        assert_eq!(empty.from_world(flat), DMat4::ZERO);
    }
}
