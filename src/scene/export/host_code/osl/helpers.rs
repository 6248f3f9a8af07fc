//! Functions and structs that a text calls and the language does not have.

use crate::wgsl::identifiers;

/// The text with the headers, structs and functions that it needs before it.
pub(in super::super::super) fn with_preamble(text: &str) -> String {
    super::makers::with_makers(&format!("{}\n{text}", preamble(text)))
}

/// Headers, structs and functions that a text needs.
fn preamble(text: &str) -> String {
    let mut words = identifiers(text);
    let mut needed = vec![false; HELPERS.len()];
    // Helpers call those that stand before them.
    for (index, (name, source)) in HELPERS.iter().enumerate().rev() {
        if words.iter().any(|word| word == name) {
            needed[index] = true;
            words.extend(identifiers(source));
        }
    }
    let mut result = String::new();
    for header in ["vector2", "vector4"] {
        if words.iter().any(|word| word == header) {
            result += &format!("#include \"{header}.h\"\n");
        }
    }
    for ((_, source), _) in HELPERS.iter().zip(&needed).filter(|(_, needed)| **needed) {
        result += &format!("\n{source}");
    }
    result
}

/// Helpers: name and source, callees first.
const HELPERS: &[(&str, &str)] = &[
    ("Int2", "struct Int2 {\n    int x;\n    int y;\n};\n"),
    ("Int3", "struct Int3 {\n    int x;\n    int y;\n    int z;\n};\n"),
    ("Int4", "struct Int4 {\n    int x;\n    int y;\n    int z;\n    int w;\n};\n"),
    (
        "Matrix3",
        "// A matrix by its columns.\n\
         struct Matrix3 {\n    vector c0;\n    vector c1;\n    vector c2;\n};\n",
    ),
    (
        "Matrix2x2",
        "// A matrix by its columns.\n\
         struct Matrix2x2 {\n    vector2 c0;\n    vector2 c1;\n};\n",
    ),
    (
        "Matrix4x4",
        "// A matrix by its columns.\n\
         struct Matrix4x4 {\n    vector4 c0;\n    vector4 c1;\n    vector4 c2;\n    vector4 c3;\n\
         };\n",
    ),
    ("xyz", "vector xyz(vector4 v)\n{\n    return vector(v.x, v.y, v.z);\n}\n"),
    (
        "component",
        "float component(vector4 v, int index)\n{\n    \
         float all[4] = {v.x, v.y, v.z, v.w};\n    return all[index];\n}\n",
    ),
    ("fract", "float fract(float x)\n{\n    return x - floor(x);\n}\n"),
    ("fwidth", "float fwidth(float x)\n{\n    return abs(Dx(x)) + abs(Dy(x));\n}\n"),
    (
        "shift_right",
        "// The bits moved down, with zeros above: integers have signs here.\n\
         int shift_right(int x, int count)\n{\n    \
         return count == 0 ? x : (x >> count) & (0x7fffffff >> (count - 1));\n}\n",
    ),
    (
        "is_below",
        "// True if a is less than b, both read without a sign.\n\
         int is_below(int a, int b)\n{\n    \
         int lowest = -2147483647 - 1;\n    return (a ^ lowest) < (b ^ lowest);\n}\n",
    ),
    (
        "divide_unsigned",
        "// a / b, both read without a sign.\n\
         int divide_unsigned(int a, int b)\n{\n    \
         if (b < 0) {\n        return !is_below(a, b);\n    }\n    \
         if (a >= 0) {\n        return a / b;\n    }\n    \
         int half = shift_right(a, 1) / b * 2;\n    \
         return half + !is_below(a - half * b, b);\n}\n",
    ),
    (
        "remainder_unsigned",
        "// What is left of a / b, both read without a sign.\n\
         int remainder_unsigned(int a, int b)\n{\n    return a - divide_unsigned(a, b) * b;\n}\n",
    ),
    (
        "float_of_unsigned",
        "float float_of_unsigned(int x)\n{\n    \
         return x >= 0 ? (float)x : 2.0 * (float)(shift_right(x, 1) | (x & 1));\n}\n",
    ),
    (
        "unsigned_of_float",
        "int unsigned_of_float(float x)\n{\n    \
         if (x >= 2147483648.0) {\n        \
         return (int)(min(x, 4294967040.0) - 2147483648.0) + (-2147483647 - 1);\n    }\n    \
         return (int)max(x, 0.0);\n}\n",
    ),
    (
        "light_of_shown",
        "// Linear light of a color as it is shown, by the curve of sRGB.\n\
         vector light_of_shown(vector shown)\n{\n    \
         vector c = clamp(shown, vector(0.0), vector(1.0));\n    \
         vector high = pow((c + 0.055) / 1.055, 2.4);\n    \
         return vector(c[0] <= 0.04045 ? c[0] / 12.92 : high[0],\n                  \
         c[1] <= 0.04045 ? c[1] / 12.92 : high[1],\n                  \
         c[2] <= 0.04045 ? c[2] / 12.92 : high[2]);\n}\n",
    ),
    (
        "shown_of_light",
        "// A color as it is shown, of linear light, by the curve of sRGB.\n\
         vector shown_of_light(color light)\n{\n    \
         vector c = max((vector)light, vector(0.0));\n    \
         vector high = 1.055 * pow(c, 1.0 / 2.4) - 0.055;\n    \
         return vector(c[0] <= 0.0031308 ? 12.92 * c[0] : high[0],\n                  \
         c[1] <= 0.0031308 ? 12.92 * c[1] : high[1],\n                  \
         c[2] <= 0.0031308 ? 12.92 * c[2] : high[2]);\n}\n",
    ),
    (
        "to_y_up",
        "// A vector in the look's axes, which have y up where Blender's have z.\n\
         vector to_y_up(vector v)\n{\n    return vector(v[0], v[2], -v[1]);\n}\n",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn helpers_come_with_those_that_they_call() {
        let text = preamble("int f(int a) { return remainder_unsigned(a, 3); }");
        let at = |name: &str| text.find(&format!("int {name}(")).expect(name);
        assert!(at("shift_right") < at("divide_unsigned"));
        assert!(at("divide_unsigned") < at("remainder_unsigned"));
        assert!(!text.contains("fract"));
        assert!(preamble("vector4 c = b;").starts_with("#include \"vector4.h\"\n"));
    }
}
