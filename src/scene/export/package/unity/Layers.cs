        /// <summary>Painted surfaces as textures, each made once for all objects.</summary>
        static readonly Dictionary<TextAsset, Texture2DArray> Painted =
            new Dictionary<TextAsset, Texture2DArray>();

        /// <summary>The layers of a painted surface, of which KTX2 has one level.</summary>
        static Texture2DArray Layers(TextAsset file)
        {
            if (file == null)
            {
                return null;
            }
            if (Painted.TryGetValue(file, out Texture2DArray known) && known != null)
            {
                return known;
            }
            byte[] bytes = file.bytes;
            Func<int, int> word = at => BitConverter.ToInt32(bytes, at);
            // Formats as Vulkan numbers them: 37 is RGBA of 8 bits, 145 blocks of BC7.
            if (bytes.Length < 104 || word(0) != 0x58544bab || word(12) != 37 && word(12) != 145)
            {
                throw new FormatException(
                    file.name + " is no painted surface of Chiaro: export the look again");
            }
            TextureFormat format = word(12) == 37 ? TextureFormat.RGBA32 : TextureFormat.BC7;
            int count = Math.Max(word(32), 1);
            var layers = new Texture2DArray(word(20), word(24), count, format, false, true)
            {
                name = file.name,
                filterMode = FilterMode.{{filter}},
                wrapMode = TextureWrapMode.Mirror,
                anisoLevel = 0,
            };
            int start = word(80);
            int size = word(88) / count;
            for (int layer = 0; layer < count; layer++)
            {
                layers.SetPixelData(bytes, 0, layer, start + layer * size);
            }
            layers.Apply(false, true);
            Painted[file] = layers;
            return layers;
        }

