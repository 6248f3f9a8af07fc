        /// <summary>Lets a light of the look be where a light of the scene is.</summary>
        static void Follow(
            ref LightSettings light, Light source, Double3x3 worldFromOwn, Double3 origin)
        {
            if (source == null)
            {
                return;
            }
            Transform place = source.transform;
            light.direction = Within(worldFromOwn, Mirrored(-place.forward));
            light.aim = Within(worldFromOwn, Mirrored(place.forward));
            light.position = Within(worldFromOwn, Mirrored(place.position) - origin);
            light.color = Rgb(source.color{{linear}});
            light.intensity = source.isActiveAndEnabled ? source.intensity : 0.0;
            if (source.type == LightType.Spot)
            {
                light.inner = source.innerSpotAngle * (Math.PI / 360.0);
                light.outer = source.spotAngle * (Math.PI / 360.0);
            }
        }

        /// <summary>A vector of the world in a frame of its own.</summary>
        static Double3 Within(Double3x3 worldFromOwn, Double3 v)
        {
            Double3x3 rows = Turned(worldFromOwn);
            return rows.c0 * v.x + rows.c1 * v.y + rows.c2 * v.z;
        }

        /// <summary>The matrix with rows for columns.</summary>
        static Double3x3 Turned(Double3x3 m) => new Double3x3(
            new Double3(m.c0.x, m.c1.x, m.c2.x),
            new Double3(m.c0.y, m.c1.y, m.c2.y),
            new Double3(m.c0.z, m.c1.z, m.c2.z));

// And colors.
        static Double3 Rgb(Color color) => new Double3(color.r, color.g, color.b);

