#pragma once
// Fits a field map to poses that a receiver reported at known places, and chooses its form by
// cross-validation.
//
// Forms: polynomials of each total degree, and the spline with a linear polynomial, smoothed by λ. Each is
// fitted to four fifths of the points and judged on the other fifth, five times; the least RMS error of
// positions wins. So a degree that explodes between the points loses. A grid of N points an axis carries
// degrees below N.

#include <span>
#include <string>
#include <vector>

#include "drivers/field_map.h"

namespace prosector {

/// What the receiver reported at a place, and what its pose is known to be; device frame.
struct FieldSample {
  Pose reported;
  Pose truth;
};

inline constexpr std::size_t least_field_samples = 27;

/// One form that was tried. Degree of the polynomial; with a `smoothing`, the spline.
struct FieldTrial {
  int degree = 1;
  bool spline = false;
  double smoothing = 0;
  double error = 0;       // m RMS on points left out
  double turn_error = 0;  // rad RMS on points left out

  std::string name() const;
};

struct FieldFit {
  FieldMap map;
  FieldTrial chosen;
  std::vector<FieldTrial> trials;
  double before = 0, turn_before = 0;  // m, rad RMS without a map
  double after = 0, turn_after = 0;    // m, rad RMS on points left out: what to expect between the points
};

/// Fits one form to all samples.
FieldMap fit_field_form(std::span<const FieldSample> samples, const FieldTrial& form);

/// Fits all forms and chooses. Throws InputError that says what to do where there are too few samples, or
/// they don't fill a box.
FieldFit fit_field(std::span<const FieldSample> samples);

/// RMS errors of poses.
struct PoseErrors {
  double position = 0, turn = 0;  // m, rad
};
/// Returns how far the reported poses are off, after the map where there is one.
PoseErrors pose_errors(std::span<const FieldSample> samples, const FieldMap* map);

}  // namespace prosector
