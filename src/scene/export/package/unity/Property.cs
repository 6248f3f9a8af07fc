        /// <summary>A property of the shader.</summary>
        readonly struct Property
        {
            readonly int id;
            readonly int first;
            readonly int count;
            readonly bool isWhole;

            Property(string name, int first, int count, bool isWhole)
            {
                id = Shader.PropertyToID(name);
                this.first = first;
                this.count = count;
                this.isWhole = isWhole;
            }

            public static Property Number(string name, int at) => new Property(name, at, 1, false);

            public static Property Whole(string name, int at) => new Property(name, at, 1, true);

            public static Property Vector(string name, int first, int count) =>
                new Property(name, first, count, false);

            public void Set(Material material, double[] numbers)
            {
                if (isWhole)
                {
                    material.SetInteger(id, (int)numbers[first]);
                }
                else if (count == 1)
                {
                    material.SetFloat(id, Single(numbers[first]));
                }
                else
                {
                    var vector = new Vector4();
                    for (int part = 0; part < count; part++)
                    {
                        vector[part] = Single(numbers[first + part]);
                    }
                    material.SetVector(id, vector);
                }
            }

            /// <summary>The number as a shader has it; 0 for what is none.</summary>
            static float Single(double x) => double.IsNaN(x)
                ? 0f
                : (float)Math.Min(Math.Max(x, float.MinValue), float.MaxValue);
        }
