#pragma once
// A camera's straight picture as what lies behind everything, and the eye that sees the room as the camera
// does.

#include "client/view/draw_list.h"
#include "drivers/camera/lens.h"

namespace prosector {

/// How a straight picture fills a picture of ours.
struct CameraView {
  DrawCamera camera;  // its pose is not set
  double left = 0, top = 0,
         step = 1;  // pixels of the straight picture: of our upper left corner from its own, and of a pixel
                    // of ours
};

/// Returns the view of `bent`'s pictures, which `straight` shows without distortion, in a picture of that
/// size (pixels). A frame as large as the lens' own is whole in it, and as large as it can be.
///
/// With K of OpenCV's pixel centres and OpenGL's of pixels' borders, the tangents follow from the borders:
/// left = (l − ½ − cx)/fx, top = (cy − t + ½)/fy.
CameraView view_of(const Lens& bent, const Lens& straight, int width, int height);

}  // namespace prosector
