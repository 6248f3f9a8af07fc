// {{title}}: made by Chiaro {{version}}, for Unity 6 and the Universal Render Pipeline 17.

using System;
{{collections}}
using UnityEngine;
using UnityEngine.Rendering;
{{using}}

namespace Chiaro
{
    /// <summary>The look "{{title}}" on a renderer.</summary>
    /// <remarks>Gives the renderer a material, and sets the material's numbers for each camera that
    /// draws.</remarks>
    [ExecuteAlways, DisallowMultipleComponent, RequireComponent(typeof(Renderer))]
    [AddComponentMenu("Chiaro/{{title}}")]
    public sealed class {{class}}Look : MonoBehaviour
    {
{{fields}}
        [Header("Drawing")]
        [Tooltip("Axes that the look's lights turn with; none for those of the world.")]
        public Transform illumination;

        [Tooltip("Draw both sides of triangles, as open meshes need it.")]
        public bool bothSides = {{both}};

        // Kept with the scene, so that builds have the shader.
        [SerializeField, HideInInspector] Shader shader;
        [SerializeField, HideInInspector] Material[] wornBefore;

        Renderer wearer;
        Material material;

{{own_lights}}
{{properties}}
        void Reset()
        {
            shader = Shader.Find("Chiaro/{{title}}");
        }

        void OnEnable()
        {
            if (shader == null)
            {
                Reset();
            }
            if (shader == null)
            {
                Debug.LogError("The build has no shader \"Chiaro/{{title}}\": put the component "
                    + "on an object of a scene, or the shader among Always Included Shaders in "
                    + "Project Settings, Graphics.", this);
                return;
            }
            wearer = GetComponent<Renderer>();
            material = new Material(shader)
            {
                name = "{{title}}",
                hideFlags = HideFlags.DontSave,
            };
            var found = wearer.sharedMaterials;
            // A scene that was saved while the look is worn has no materials there.
            if (wornBefore == null || Array.Exists(found, one => one != null))
            {
                wornBefore = found;
            }
            var worn = new Material[Math.Max(found.Length, 1)];
            for (int part = 0; part < worn.Length; part++)
            {
                worn[part] = material;
            }
            wearer.sharedMaterials = worn;
            RenderPipelineManager.beginCameraRendering += BeforeCamera;
        }

        void OnDisable()
        {
            if (material == null)
            {
                return;
            }
            RenderPipelineManager.beginCameraRendering -= BeforeCamera;
            wearer.sharedMaterials = wornBefore;
            if (Application.isPlaying)
            {
                Destroy(material);
            }
            else
            {
                DestroyImmediate(material);
            }
        }

        void BeforeCamera(ScriptableRenderContext context, Camera camera)
        {
{{set}}
            material.SetFloat("_Cull", (float)(bothSides ? CullMode.Off : CullMode.Back));
        }

{{settings}}
{{around}}
{{follow}}
{{property}}
    }
{{work}}
}
