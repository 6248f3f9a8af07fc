import chiaro::total;

/// Logarithm
///
/// To which power a base must be raised to give this number. 0 and below count as the smallest
/// number above 0; where the base is 1 the result is 0.
///
/// @param value "Value" default=1 min=0 : The number.
/// @param base "Base" default=2.718281828459045 min=0 : e is the natural logarithm.
/// @return value "Value" : log(value) / log(base).
fn logarithm(value: f32, base: f32) -> f32 {
    return divided(logarithm_of(value), logarithm_of(base));
}
