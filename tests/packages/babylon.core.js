// What packages import, out of the one script of the npm package babylonjs.
export const {
  Color4, Constants, DrawWrapper, EffectRenderer, Matrix, Observable, RawTexture,
  RawTexture2DArray, RenderTargetTexture, ShaderLanguage, ShaderMaterial, SmartArray, Texture,
  UniformBuffer,
} = window.BABYLON;
