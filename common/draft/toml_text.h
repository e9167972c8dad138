#pragma once
// Formatting of values as TOML.

#include <string>
#include <string_view>

#include "common/math.h"

namespace prosector {

/// Returns the text as a quoted TOML string, with escapes.
std::string toml_text(std::string_view text);

/// Returns a number as TOML, rounded to five significant digits.
std::string toml_number(double x);
std::string toml_numbers(const Vec3& v);

}  // namespace prosector
