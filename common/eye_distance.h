#pragma once
// How far apart people's eyes are.

namespace prosector {

inline constexpr double usual_eye_distance = 0.063;  // m, of adults in the mean

}  // namespace prosector
