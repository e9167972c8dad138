#pragma once
// Fits a field map to poses that a receiver reported at known positions, and chooses the form of the map.
//
// The forms are polynomials of each total degree, and the spline with a linear polynomial, smoothed by λ.
// Each is tested on a simulated field similar to the measured one (simulated_field.h). It is fitted to
// simulated samples at the measured points and evaluated at random positions in their box. This error is
// reported.
//
// Each form is also tested by five-fold cross-validation. That error is too large, because a point that is
// left out leaves a hole, and on the box's faces needs extrapolation. It is too small where a polynomial
// oscillates between the points: degree N and more, on a grid with N points per axis. The form with the least
// expected error wins. Among forms about as good, the one with the least cross-validation error wins.

#include <span>
#include <string>
#include <vector>

#include "drivers/device/field_map.h"
#include "drivers/fitting/field_sample.h"
#include "drivers/fitting/pose_errors.h"

namespace prosector {

inline constexpr std::size_t min_field_samples = 27;

/// One form of the map that corrects magnetic distortion, with its tested errors. The form is a polynomial of
/// total degree `degree`, or a spline with the parameter `smoothing` (larger is smoother).
struct FieldTrial {
  int degree = 1;
  bool spline = false;
  double smoothing = 0;
  PoseErrors expected;  // expected between the points
  double left_out = 0;  // m RMS, cross-validation

  std::string name() const;
};
FieldTrial polynomial_form(int degree);
FieldTrial spline_form(double smoothing);

struct FieldFit {
  FieldMap map;
  FieldTrial chosen;
  std::vector<FieldTrial> trials;
  double before = 0, turn_before = 0;  // m, rad RMS without a map
  double after = 0, turn_after = 0;    // m, rad RMS expected between the points
};

/// Fits a map that corrects magnetic distortion, in the given form (polynomial degree or spline smoothing),
/// to all samples.
FieldMap fit_field_form(std::span<const FieldSample> samples, const FieldTrial& form);

/// Fits maps of several forms (polynomials and splines) that correct magnetic distortion, and returns the one
/// with the least expected error. `noise` is the known RMS noise of a sample's pose. Throws InputError with
/// advice if there are too few samples or they do not fill a box.
FieldFit fit_field(std::span<const FieldSample> samples, const PoseErrors& noise = {});

/// Returns the RMS errors of the samples' reported poses relative to their true poses. If `map` is not null,
/// it corrects the reported poses first.
PoseErrors pose_errors(std::span<const FieldSample> samples, const FieldMap* map);

}  // namespace prosector
