/// Nothing
///
/// Nothing at all.
