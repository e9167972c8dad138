#pragma once
// An eye as a headset's runtime has it, as a camera of ours.

#include "client/view/draw_list.h"

namespace prosector {

/// Where an eye is and what it sees: angles from straight ahead, rad, right and up positive.
struct EyeView {
  Pose pose;
  double left = 0, right = 0, up = 0, down = 0;
};

/// Tells whether a picture can be drawn for the eye: all are numbers, and it sees something.
bool is_usable(const EyeView& eye);

/// Returns the off-axis camera of the eye, whose picture begins `x` pixels from the left.
DrawCamera camera_of(const EyeView& eye, int x, int width, int height);

}  // namespace prosector
