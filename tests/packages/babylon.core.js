// What packages import, out of the one script of the npm package babylonjs.
export const {
  Constants, Matrix, RawTexture, ShaderLanguage, ShaderMaterial, Texture, UniformBuffer, Vector3,
} = window.BABYLON;
