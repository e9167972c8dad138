#pragma once
// A distorted magnetic field as arrows at its grid points: the errors before and after the correction.

#include <vector>

#include "client/setup/interface.h"
#include "drivers/fitting/field_fit.h"

namespace prosector {

struct FieldPicture {
  std::vector<Vec3> places;         // m, true positions
  std::vector<Vec3> before, after;  // m: errors of the reported positions
  double expected = 0;              // m, expected RMS error between the points
};

FieldPicture picture_of(const std::vector<FieldSample>& samples, const FieldFit& fit);
/// Draws two plots side by side over the available width: the tracker's position errors in a distorted
/// magnetic field, as arrows, before and after the correction.
void draw_field_picture(Interface& ui, const FieldPicture& picture);

}  // namespace prosector
