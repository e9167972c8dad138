#pragma once
// Calibration of a user's eyes: the interpupillary distance by a sighting method, and a display's projection
// by SPAAM.

#include <Eigen/Core>
#include <span>

#include "common/math.h"

namespace prosector {

/// Interpupillary distance and its expected error, measured with a thin rod in front of the screen. Each eye
/// alone sees the rod at a different mark of a ruler on the screen; the marks are x apart. With the distances
/// D from the eyes to the screen and d from the eyes to the rod, the interpupillary distance is e = x · d /
/// (D − d). Lengths are in m. Adults have 52 to 78 mm (Dodgson 2004).
struct EyeDistance {
  double distance = 0;
  double error = 0;  // expected RMS error
};
inline constexpr double least_eye_distance = 0.045, most_eye_distance = 0.085;  // m
/// Computes the interpupillary distance and its expected error from the distance between the two marks on the
/// screen at which the eyes see a rod. `screen` and `rod` are distances from the eyes; all lengths are in m.
/// `mark_error` and `length_error` are RMS errors of the marks and of the other lengths. Throws InputError
/// for an implausible result.
EyeDistance eye_distance_by_sighting(double marks_apart, double screen, double rod, double mark_error = 1e-3,
                                     double length_error = 5e-3);

inline constexpr double card_width = 85.60e-3;  // m, width of a bank card (ISO/IEC 7810 ID-1)
/// Returns the size of a screen pixel, m, from the width in pixels of a bank card held to the screen. Throws
/// InputError for an implausible result.
double pixel_size_from_card(double card_pixels);

/// A known point (m, head receiver's frame) and the pixel of one eye's image that covered it. Pixels count
/// from the upper left corner.
struct SeenPoint {
  Vec3 point;
  Eigen::Vector2d pixel;
};
inline constexpr std::size_t min_seen_points = 12;

/// Projection of one eye of a display, calibrated by SPAAM (Tuceryan and Navab 2000). The 3×4 matrix that
/// maps points to pixels is the least singular vector of normalised pairs (DLT; Hartley 1997). It is
/// decomposed into the intrinsic matrix, the rotation and the eye's position.
struct EyeFit {
  Eigen::Matrix<double, 3, 4> projection;  // maps points to pixels
  Pose eye;                                // pose in the head receiver's frame; −z looks forward, +y up
  double left = 0, right = 0, bottom = 0, top = 0;  // tangents of the image's edges, as in DrawCamera
  double residual = 0;                              // pixels RMS
  double fov_horizontal() const;                    // rad
  double fov_vertical() const;
};

/// Fits the projection of one eye to pairs of points and pixels. `width` and `height` are the size of the
/// eye's image in pixels. Throws InputError with advice if there are fewer than 12 pairs or all points lie
/// nearly in a plane.
EyeFit fit_eye(std::span<const SeenPoint> seen, int width, int height);

/// Calibrated parameters of both eyes for a stereo display: interpupillary distance, fields of view,
/// convergence distance and head pose.
struct EyesFit {
  double distance = 0;        // m
  double fov_horizontal = 0;  // rad, mean of both eyes
  double fov_vertical = 0;
  double convergence = 0;  // m; 0: parallel views
  Pose head;  // pose of the point between the eyes in the receiver's frame: the head station's mount
};
EyesFit join_eyes(const EyeFit& left, const EyeFit& right);

}  // namespace prosector
