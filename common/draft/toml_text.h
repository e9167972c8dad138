#pragma once
// Values as TOML writes them.

#include <string>
#include <string_view>

#include "common/math.h"

namespace prosector {

/// Returns a string in quotes, with what TOML wants escaped.
std::string toml_text(std::string_view text);

/// Returns a number, rounded to five digits.
std::string toml_number(double x);
std::string toml_numbers(const Vec3& v);

}  // namespace prosector
