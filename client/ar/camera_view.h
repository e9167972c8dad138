#pragma once
// Undistorted camera image as background, and the matching render camera.

#include "client/view/draw_list.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

/// How an undistorted image fills a frame.
struct CameraView {
  DrawCamera camera;  // its pose is not set
  double left = 0, top = 0,
         step = 1;  // in pixels of the undistorted image: offset of the frame's upper left corner from the
                    // image's, and size of a frame's pixel
};

/// Returns the view for images with lens model `bent`, undistorted as `straight`, in a frame of this size
/// (pixels). A frame with the lens' image size shows the image completely, at maximum scale.
///
/// K of OpenCV refers to pixel centres, OpenGL's frustum to pixel borders. Hence the tangents at the borders:
/// left = (l − ½ − cx)/fx, top = (cy − t + ½)/fy.
CameraView view_of(const Lens& bent, const Lens& straight, int width, int height);

}  // namespace prosector
