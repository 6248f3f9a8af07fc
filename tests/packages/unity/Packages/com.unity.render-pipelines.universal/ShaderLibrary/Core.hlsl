// A stand-in for the include of Unity's Universal Render Pipeline, of our own: what shaders of looks
// use of it, and names that it takes. Matrices come as rows, so that no packing counts.

#define UNITY_REVERSED_Z 1
#define UNITY_NEAR_CLIP_VALUE 1.0
#define PI 3.14159265
#define HALF_PI 1.57079633
#define real float
#define CBUFFER_START(name) cbuffer name : register(b1) {
#define CBUFFER_END };

struct Light
{
    float3 direction;
};

struct Attributes
{
    float3 position;
};

cbuffer UnityStandIn : register(b0)
{
    float4 world_from_object[4];
    float4 object_from_world[4];
    float4 camera_from_world_rows[4];
    float4 clip_from_world_rows[4];
    float4 clip_from_camera_rows[4];
    float4 world_space_camera;
    float4 _ScreenParams;
    float4 unity_OrthoParams;
};

float4x4 rows_of(float4 rows[4])
{
    return float4x4(rows[0], rows[1], rows[2], rows[3]);
}

#define UNITY_MATRIX_M rows_of(world_from_object)
#define UNITY_MATRIX_I_M rows_of(object_from_world)
#define UNITY_MATRIX_V rows_of(camera_from_world_rows)
#define UNITY_MATRIX_VP rows_of(clip_from_world_rows)
#define unity_CameraProjection rows_of(clip_from_camera_rows)
#define _WorldSpaceCameraPos world_space_camera.xyz

float3 TransformObjectToWorld(float3 position)
{
    return mul(UNITY_MATRIX_M, float4(position, 1.0)).xyz;
}

float3 TransformObjectToWorldNormal(float3 normal)
{
    return normalize(mul(normal, (float3x3)UNITY_MATRIX_I_M));
}
