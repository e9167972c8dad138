#pragma once
// Comparison of a body's volume with that of its source file.

#include <string>

namespace prosector {

inline constexpr double reported_volume_error = 2;   // %: a larger one is reported
inline constexpr double accepted_volume_error = 20;  // %: a larger one is refused unless the scene allows it
inline constexpr double max_accepted_volume_error = 1000;  // %: the largest that a scene can allow

/// Compares the volume `made` (m³) of a body with the volume expected from its file (m³; 0 or less: no
/// check). Returns a warning, or "" if they differ by at most reported_volume_error. Throws InputError if
/// they differ by more than `accepted` per cent (0: accepted_volume_error); the message ends with the
/// sentence `remedy`. `of` describes the expected volume in both messages.
std::string check_volume(double made, double expected, double accepted, const std::string& of,
                         const std::string& remedy);

}  // namespace prosector
