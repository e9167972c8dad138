#pragma once
// Whether a body is as large as its file says.

#include <string>

namespace prosector {

inline constexpr double reported_volume_error = 2;   // %: a larger one is reported
inline constexpr double accepted_volume_error = 20;  // %: a larger one is refused unless the scene accepts it
inline constexpr double max_accepted_volume_error = 1000;  // %: the largest that a scene can accept

/// Compares a volume with what the file says (m³; 0 or less: nothing). Returns a warning, "" where they
/// differ by at most reported_volume_error. Throws InputError that ends with `remedy`, a sentence, where they
/// differ by more than `accepted` per cent (0: accepted_volume_error). Both name `of`, what the file's volume
/// is of.
std::string check_volume(double made, double expected, double accepted, const std::string& of,
                         const std::string& remedy);

}  // namespace prosector
