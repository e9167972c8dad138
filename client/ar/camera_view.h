#pragma once
// Undistorted camera image as background, and the matching render camera.

#include "client/view/draw_list.h"
#include "drivers/camera/base/lens.h"

namespace prosector {

/// Camera projection of a frame whose background is an undistorted camera image, and the image area that
/// fills the frame.
struct CameraView {
  DrawCamera camera;  // its pose is not set
  double left = 0, top = 0,
         step = 1;  // in pixels of the undistorted image: offset of the frame's upper left corner from the
                    // image's, and size of a frame's pixel
};

/// Returns projection and image area for a frame of `width` × `height` pixels with an undistorted camera
/// image as its background. `bent` is the camera's lens model with distortion, `straight` that of the
/// undistorted image. The camera's whole image area fits into the frame at the maximum scale, centred.
///
/// K of OpenCV refers to pixel centres, OpenGL's frustum to pixel borders. Hence the tangents at the borders,
/// with l and t the frame's left and top in the undistorted image: left = (l − ½ − cx)/fx, top = (cy − t +
/// ½)/fy.
CameraView view_of(const Lens& bent, const Lens& straight, int width, int height);

}  // namespace prosector
