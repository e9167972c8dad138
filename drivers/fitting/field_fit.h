#pragma once
// Fits a field map to poses that a receiver reported at known places, and chooses its form.
//
// Forms: polynomials of each total degree, and the spline with a linear polynomial, smoothed by λ. Each is
// tried on a field like the one that was measured (like_field.h). It is fitted to what that gives at the same
// points, and judged at places anywhere in their box: this error is told.
//
// Besides, each is judged on points left out (cross-validation): it is fitted to four fifths of them and
// judged on the other fifth, five times. That is more than there will be, for a point left out leaves a
// hole, and at the box' faces lies beyond the others. And it is less where a polynomial explodes between the
// points: on a grid of N points an axis, of degree N and more. The least error to expect wins; of those
// that are about as good, that which is best at points left out.

#include <span>
#include <string>
#include <vector>

#include "drivers/field_map.h"
#include "drivers/fitting/field_sample.h"
#include "drivers/fitting/pose_errors.h"

namespace prosector {

inline constexpr std::size_t least_field_samples = 27;

/// One form that was tried. Degree of the polynomial; with a `smoothing`, the spline.
struct FieldTrial {
  int degree = 1;
  bool spline = false;
  double smoothing = 0;
  PoseErrors expected;  // between the points
  double left_out = 0;  // m RMS at points left out

  std::string name() const;
};
FieldTrial polynomial_form(int degree);
FieldTrial spline_form(double smoothing);

struct FieldFit {
  FieldMap map;
  FieldTrial chosen;
  std::vector<FieldTrial> trials;
  double before = 0, turn_before = 0;  // m, rad RMS without a map
  double after = 0, turn_after = 0;    // m, rad RMS to expect between the points
};

/// Fits one form to all samples.
FieldMap fit_field_form(std::span<const FieldSample> samples, const FieldTrial& form);

/// Fits all forms and chooses. `noise`: of a sample, as far as it is known. Throws InputError that says what
/// to do where there are too few samples, or they don't fill a box.
FieldFit fit_field(std::span<const FieldSample> samples, const PoseErrors& noise = {});

/// Returns how far the reported poses are off, after the map where there is one.
PoseErrors pose_errors(std::span<const FieldSample> samples, const FieldMap* map);

}  // namespace prosector
