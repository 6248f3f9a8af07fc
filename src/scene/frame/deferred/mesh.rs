//! Meshes whose triangles are told by a vertex.

/// Order of a mesh's vertices in which the first corner of each triangle is a vertex of its own,
/// with the triangle's number: drawn so, the triangle at a pixel is known from a number that its
/// first corner gives to all of it, on every device. (The number of a primitive itself is not to be
/// had everywhere, and takes software Vulkan as long as half of the vertices.)
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NumberedMesh {
    /// Vertex of the mesh that stands at each place: first one for each triangle, then those that
    /// are no triangle's first corner.
    pub vertices: Vec<u32>,
    /// Indices of [`vertices`](Self::vertices), the triangles in the mesh's order.
    pub indices: Vec<u32>,
}

impl NumberedMesh {
    /// The order for a mesh with these indices, three for each triangle.
    pub fn new(indices: &[u32]) -> Self {
        let count = indices.iter().max().map_or(0, |most| *most as usize + 1);
        // The place where each vertex stands, if any.
        let mut places: Vec<Option<u32>> = vec![None; count];
        let mut vertices = Vec::with_capacity(indices.len() / 3);
        let mut turned = Vec::with_capacity(indices.len());
        for (number, corners) in (0..).zip(indices.chunks_exact(3)) {
            // A vertex that stands nowhere yet serves as the corner of other triangles, too.
            let free = corners.iter().position(|corner| places[*corner as usize].is_none());
            let first = free.unwrap_or_default();
            places[corners[first] as usize].get_or_insert(number);
            vertices.push(corners[first]);
            turned.extend([0, 1, 2].map(|corner| corners[(first + corner) % 3]));
        }
        let mut place = |vertex: u32| {
            *places[vertex as usize].get_or_insert_with(|| {
                vertices.push(vertex);
                (vertices.len() - 1) as u32
            })
        };
        let indices = turned
            .iter()
            .enumerate()
            .map(|(index, vertex)| if index % 3 == 0 { index as u32 / 3 } else { place(*vertex) })
            .collect();
        Self { vertices, indices }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(indices: &[u32]) {
        let mesh = NumberedMesh::new(indices);
        assert_eq!(mesh.indices.len(), indices.len());
        for (number, (own, was)) in mesh.indices.chunks(3).zip(indices.chunks(3)).enumerate() {
            assert_eq!(own[0] as usize, number, "the first corner is the triangle's own");
            let own: Vec<u32> = own.iter().map(|at| mesh.vertices[*at as usize]).collect();
            let turns = (0..3).any(|turn| (0..3).all(|i| own[i] == was[(i + turn) % 3]));
            assert!(turns, "{own:?} is not {was:?} turned");
        }
    }

    #[test]
    fn the_first_corner_of_each_triangle_has_its_number() {
        check(&[]);
        check(&[0, 1, 2]);
        check(&[0, 1, 2, 2, 1, 3, 0, 2, 3, 0, 3, 1]);
        // More triangles than corners, some of no area.
        check(&[0, 1, 2, 0, 1, 2, 2, 1, 0, 1, 1, 1, 0, 0, 2, 5, 1, 0]);
        let fan: Vec<u32> = (1..40).flat_map(|corner| [0, corner, corner + 1]).collect();
        check(&fan);
        let extra = NumberedMesh::new(&fan).vertices.len();
        assert!(extra <= 39 + 2, "{extra}: few vertices stand there twice");
    }
}
