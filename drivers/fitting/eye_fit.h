#pragma once
// Where a user's eyes are and what they see: the distance between them by a sight, and a display's projection
// by SPAAM.

#include <Eigen/Core>
#include <span>

#include "common/math.h"

namespace prosector {

/// The distance between the pupils by a thin rod in front of the screen: each eye alone sees it at another
/// place of a ruler on the screen, x apart. With D from the eyes to the screen and d from them to the rod:
///   e = x · d / (D − d)
/// Lengths in m. People have 52 to 78 mm (Dodgson 2004).
struct EyeDistance {
  double distance = 0;
  double error = 0;  // RMS, expected
};
inline constexpr double least_eye_distance = 0.045, most_eye_distance = 0.085;  // m
/// Returns the distance for marks that are right within `mark_error`, and lengths within `length_error`.
/// Throws InputError for what no eyes have.
EyeDistance eye_distance_by_sight(double marks_apart, double screen, double rod, double mark_error = 1e-3,
                                  double length_error = 5e-3);

inline constexpr double card_width = 85.60e-3;  // m, of a bank card (ISO/IEC 7810 ID-1)
/// Returns metres of a pixel of the screen, from the width that a bank card takes there. Throws InputError
/// for what no screen has.
double pixel_by_card(double card_pixels);

/// A known point in the head receiver's frame, and the pixel of one eye's picture that covered it. The pixel
/// counts from the upper left corner.
struct SeenPoint {
  Vec3 point;
  Eigen::Vector2d pixel;
};
inline constexpr std::size_t least_seen_points = 12;

/// One eye's camera as SPAAM finds it (Tuceryan and Navab 2000): the 3×4 matrix that maps points to pixels.
/// It is solved from normalised pairs by the least singular vector (DLT; Hartley 1997), and split into K, R
/// and the eye's place.
struct EyeFit {
  Eigen::Matrix<double, 3, 4> projection;           // pixels from points
  Pose eye;                                         // in the head receiver's frame; −z looks ahead, +y up
  double left = 0, right = 0, bottom = 0, top = 0;  // tangents of the picture's edges, as DrawCamera has them
  double residual = 0;                              // pixels RMS
  double fov_horizontal() const;                    // rad
  double fov_vertical() const;
};

/// Fits. Throws InputError that says what to do where there are fewer than 12 pairs, or they lie in a plane.
EyeFit fit_eye(std::span<const SeenPoint> seen, int width, int height);

/// What a stereo display needs of both eyes.
struct EyesFit {
  double distance = 0;        // m
  double fov_horizontal = 0;  // rad, mean of both
  double fov_vertical = 0;
  double convergence = 0;  // m; 0: parallel pictures
  Pose head;               // the point between the eyes in the receiver's frame: the head station's mount
};
EyesFit join_eyes(const EyeFit& left, const EyeFit& right);

}  // namespace prosector
