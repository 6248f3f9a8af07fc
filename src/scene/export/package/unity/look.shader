// {{title}}: made by Chiaro {{version}}, for Unity 6 and the Universal Render Pipeline 17.
// The component beside this file sets the numbers, which follow the camera and the lights.

Shader "Chiaro/{{title}}"
{
    Properties
    {
        [Enum(Off, 0, Front, 1, Back, 2)] _Cull ("Sides left out", Float) = {{cull}}
        [HideInInspector] _object_id ("", Float) = 0
{{properties}}
    }

    SubShader
    {
        Tags { "RenderPipeline" = "UniversalPipeline" {{queue}} }
        Cull [_Cull]

        HLSLINCLUDE
        #pragma target 3.5
        #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"

        // All of the material, in one block, as the SRP Batcher wants it.
        CBUFFER_START(UnityPerMaterial)
        float _Cull;
        float _object_id;
{{numbers}}
        CBUFFER_END

        #include "{{stem}}.hlsl"

        // Unity's space is left-handed and the look's right-handed: x is mirrored, in the world and
        // in the object, as importers of meshes do.
        static const float4x4 MIRROR =
            float4x4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

        float3 mirrored(float3 v)
        {
            return float3(-v.x, v.yz);
        }

        struct MeshVertex
        {
{{attributes}}
        };

        struct Passed
        {
            float4 clip : SV_POSITION;
{{varyings}}
        };

        // The eye and 1; for a parallel view the direction toward the viewer and 0.
        float4 eye_of_camera()
        {
            float3 toward = mirrored(UNITY_MATRIX_V[2].xyz);
            float3 eye = mirrored(_WorldSpaceCameraPos);
            return unity_OrthoParams.w > 0.5 ? float4(toward, 0.0) : float4(eye, 1.0);
        }

        // The look has matrices by columns where HLSL has rows, hence each transposed.
        void take_surroundings()
        {
{{surroundings}}
        }

        void take_settings()
        {
{{settings}}
        }

{{pixel}}
{{curve}}

        Passed vertex_of_look(MeshVertex mesh)
        {
            take_surroundings();
            take_settings();
{{vertex}}
            return passed;
        }

        float4 fragment_of_look(Passed passed, bool is_front)
        {
            take_surroundings();
            take_settings();
{{inputs}}
            return fs_main(input);
        }
        ENDHLSL

        Pass
        {
            Name "Forward"
            Tags { "LightMode" = "UniversalForward" }
            ZWrite On
{{blend}}

            HLSLPROGRAM
            #pragma vertex vertex_of_look
            #pragma fragment forward

            float4 forward(Passed passed, bool is_front : SV_IsFrontFace) : SV_Target
            {
                float4 color = fragment_of_look(passed, is_front);
{{shown}}
                return color;
            }
            ENDHLSL
        }

        Pass
        {
            Name "ShadowCaster"
            Tags { "LightMode" = "ShadowCaster" }
            ZWrite On
            ColorMask 0

            HLSLPROGRAM
            #pragma vertex shadow_vertex
            #pragma fragment depth
            #pragma multi_compile_vertex _ _CASTING_PUNCTUAL_LIGHT_SHADOW

            // Set by the pipeline while it draws shadow maps.
            float3 _LightDirection;
            float3 _LightPosition;
            float4 _ShadowBias;

            Passed shadow_vertex(MeshVertex mesh)
            {
                Passed passed = vertex_of_look(mesh);
                float3 world = TransformObjectToWorld(mesh.position);
                float3 normal = TransformObjectToWorldNormal(mesh.normal);
                #if defined(_CASTING_PUNCTUAL_LIGHT_SHADOW)
                float3 toward = normalize(_LightPosition - world);
                #else
                float3 toward = _LightDirection;
                #endif
                float slope = 1.0 - saturate(dot(toward, normal));
                world += toward * _ShadowBias.x + normal * (slope * _ShadowBias.y);
                passed.clip = mul(UNITY_MATRIX_VP, float4(world, 1.0));
                // What lies before the light's near plane casts a shadow too.
                #if UNITY_REVERSED_Z
                passed.clip.z = min(passed.clip.z, passed.clip.w * UNITY_NEAR_CLIP_VALUE);
                #else
                passed.clip.z = max(passed.clip.z, passed.clip.w * UNITY_NEAR_CLIP_VALUE);
                #endif
                return passed;
            }

{{depth}}
            ENDHLSL
        }

        Pass
        {
            Name "DepthOnly"
            Tags { "LightMode" = "DepthOnly" }
            ZWrite On
            ColorMask R

            HLSLPROGRAM
            #pragma vertex vertex_of_look
            #pragma fragment depth

{{depth}}
            ENDHLSL
        }

        Pass
        {
            Name "DepthNormals"
            Tags { "LightMode" = "DepthNormals" }
            ZWrite On

            HLSLPROGRAM
            #pragma vertex normals_vertex
            #pragma fragment normals

            struct PassedNormal
            {
                Passed passed;
                float3 normal : NORMAL;
            };

            PassedNormal normals_vertex(MeshVertex mesh)
            {
                PassedNormal result;
                result.passed = vertex_of_look(mesh);
                result.normal = TransformObjectToWorldNormal(mesh.normal);
                return result;
            }

            float4 normals(PassedNormal input, bool is_front : SV_IsFrontFace) : SV_Target
            {
{{cut}}
                float3 normal = normalize(input.normal);
                return float4(is_front ? normal : -normal, 0.0);
            }
            ENDHLSL
        }
    }
}
