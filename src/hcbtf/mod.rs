//! Hand-painted 6D textures (HCBTFs): how their files are read and written, how rules fill what is not painted, and how
//! all of it becomes the texture that shaders look up.
