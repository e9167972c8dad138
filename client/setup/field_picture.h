#pragma once
// A bent field as arrows at the points of its grid: what was off before a map, and what is left with it.

#include <vector>

#include "client/setup/interface.h"
#include "drivers/fitting/field_fit.h"

namespace prosector {

struct FieldPicture {
  std::vector<Vec3> places;         // m, true ones
  std::vector<Vec3> before, after;  // m: by what reported places are off
  double expected = 0;              // m RMS to expect between the points
};

FieldPicture picture_of(const std::vector<FieldSample>& samples, const FieldFit& fit);
/// Draws both beside each other, over the width there is.
void draw_field_picture(Interface& ui, const FieldPicture& picture);

}  // namespace prosector
