// Stand-ins for the classes of Unity that components of looks use, of our own, for Mono.

using System;
using System.Collections.Generic;

namespace UnityEngine
{
    public class ExecuteAlways : Attribute { }
    public class DisallowMultipleComponent : Attribute { }
    public class RequireComponent : Attribute { public RequireComponent(Type type) { } }
    public class AddComponentMenu : Attribute { public AddComponentMenu(string name) { } }
    public class HeaderAttribute : Attribute { public HeaderAttribute(string text) { } }
    public class TooltipAttribute : Attribute { public TooltipAttribute(string text) { } }
    public class RangeAttribute : Attribute { public RangeAttribute(float min, float max) { } }
    public class MinAttribute : Attribute { public MinAttribute(float min) { } }
    public class SerializeField : Attribute { }
    public class HideInInspector : Attribute { }

    public struct Vector2
    {
        public float x, y;
        public Vector2(float x, float y) { this.x = x; this.y = y; }
    }

    public struct Vector3
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 operator -(Vector3 a) => new Vector3(-a.x, -a.y, -a.z);
        public static float Distance(Vector3 a, Vector3 b) => (float)Math.Sqrt(
            (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
    }

    public struct Vector4
    {
        public float x, y, z, w;
        public Vector4(float x, float y, float z, float w)
        { this.x = x; this.y = y; this.z = z; this.w = w; }
        public float this[int index]
        {
            get => index == 0 ? x : index == 1 ? y : index == 2 ? z : w;
            set
            {
                if (index == 0) x = value;
                else if (index == 1) y = value;
                else if (index == 2) z = value;
                else w = value;
            }
        }
    }

    public struct Color
    {
        public float r, g, b, a;
        public Color(float r, float g, float b, float a)
        { this.r = r; this.g = g; this.b = b; this.a = a; }
        static float Linear(float x) => x <= 0.04045f
            ? x / 12.92f : (float)Math.Pow((x + 0.055) / 1.055, 2.4);
        public Color linear => new Color(Linear(r), Linear(g), Linear(b), a);
    }

    public struct Matrix4x4
    {
        public float m00, m01, m02, m03, m10, m11, m12, m13, m20, m21, m22, m23, m30, m31, m32, m33;
    }

    public struct Bounds { public Vector3 center; }

    public enum HideFlags { None, DontSave }
    public enum LightType { Spot, Directional, Point }

    public class Object
    {
        public string name;
        public HideFlags hideFlags;
        public static void Destroy(Object one) { }
        public static void DestroyImmediate(Object one) { }
    }

    public static class Debug
    {
        public static void LogError(object message, Object context) { }
    }

    public class Component : Object
    {
        public Transform transform;
        public Renderer renderer_;
        public T GetComponent<T>() where T : class => renderer_ as T;
    }

    public class Behaviour : Component { public bool isActiveAndEnabled = true; }
    public class MonoBehaviour : Behaviour { }

    public class Transform : Component
    {
        public Vector3 position, right, up, forward;
    }

    public class Renderer : Component
    {
        public Material[] sharedMaterials = new Material[0];
        public Bounds bounds;
    }

    public class Light : Behaviour
    {
        public LightType type;
        public Color color;
        public float intensity, spotAngle, innerSpotAngle;
    }

    public class Camera : Behaviour
    {
        public Matrix4x4 worldToCameraMatrix;
        public bool orthographic;
        public int pixelWidth, pixelHeight;
    }

    public class TextAsset : Object
    {
        public byte[] bytes;
    }

    public enum FilterMode { Point, Bilinear }
    public enum TextureWrapMode { Repeat, Clamp, Mirror }
    public enum TextureFormat { RGBA32 = 4, BC7 = 25 }

    public class Texture : Object
    {
        public FilterMode filterMode;
        public TextureWrapMode wrapMode;
        public int anisoLevel;
        // What the test is told: a file, or layers in a file.
        public virtual string Told() => "file " + name;
    }

    public class Texture2DArray : Texture
    {
        readonly int width, height;
        readonly byte[][] layers;
        bool isApplied;

        public Texture2DArray(
            int width, int height, int depth, TextureFormat format, bool mipChain, bool linear)
        {
            if (format != TextureFormat.RGBA32 || mipChain || !linear)
                throw new ArgumentException("layers are drawn of one level of bytes alone");
            this.width = width;
            this.height = height;
            layers = new byte[depth][];
        }

        public void SetPixelData<T>(T[] data, int mipLevel, int element, int start)
        {
            layers[element] = new byte[4 * width * height];
            Array.Copy(data, start, layers[element], 0, layers[element].Length);
        }

        public void Apply(bool updateMipmaps, bool makeNoLongerReadable) { isApplied = true; }

        public override string Told()
        {
            if (!isApplied || filterMode != FilterMode.Bilinear || anisoLevel != 0
                || wrapMode != TextureWrapMode.Mirror)
                throw new InvalidOperationException(name);
            using (var file = System.IO.File.Create("layers.bin"))
                foreach (byte[] layer in layers)
                    file.Write(layer, 0, layer.Length);
            return "layers " + width + " " + height + " " + layers.Length + " layers.bin";
        }
    }

    public class Shader : Object
    {
        public static List<string> Names = new List<string>();
        public static Shader Find(string name) => new Shader { name = name };
        public static int PropertyToID(string name)
        {
            Names.Add(name);
            return Names.Count - 1;
        }
    }

    public class Material : Object
    {
        public SortedDictionary<string, float[]> Numbers = new SortedDictionary<string, float[]>();
        public SortedDictionary<string, Texture> Textures = new SortedDictionary<string, Texture>();
        public Material(Shader shader) { }
        public void SetTexture(string name, Texture texture)
        {
            if (texture != null) Textures[name] = texture;
        }
        public void SetFloat(string name, float x) { Numbers[name] = new[] { x }; }
        public void SetFloat(int id, float x) { Numbers[Shader.Names[id]] = new[] { x }; }
        public void SetInteger(int id, int x) { Numbers[Shader.Names[id]] = new[] { (float)x }; }
        public void SetVector(int id, Vector4 v)
        {
            Numbers[Shader.Names[id]] = new[] { v.x, v.y, v.z, v.w };
        }
    }

    public static class Time { public static float time; public static int frameCount; }
    public static class Application { public static bool isPlaying; }
}

namespace UnityEngine.Rendering
{
    public struct ScriptableRenderContext { }
    public enum CullMode { Off, Front, Back }

    public static class RenderPipelineManager
    {
        public static event Action<ScriptableRenderContext, Camera> beginCameraRendering;
        public static void Begin(Camera camera)
        {
            beginCameraRendering(new ScriptableRenderContext(), camera);
        }
    }
}
