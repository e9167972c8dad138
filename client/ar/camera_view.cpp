#include "client/ar/camera_view.h"

#include <algorithm>

namespace prosector {

CameraView view_of(const Lens& bent, const Lens& straight, int width, int height) {
  CameraView out;
  out.step = std::max(static_cast<double>(bent.width) / width, static_cast<double>(bent.height) / height);
  // Centre of the lens' image, in the undistorted image, from its border.
  const double x = bent.width / 2.0 + straight.cx - bent.cx;
  const double y = bent.height / 2.0 + straight.cy - bent.cy;
  out.left = x - out.step * width / 2;
  out.top = y - out.step * height / 2;
  DrawCamera& camera = out.camera;
  camera.left = (out.left - 0.5 - straight.cx) / straight.fx;
  camera.right = camera.left + out.step * width / straight.fx;
  camera.top = (straight.cy - out.top + 0.5) / straight.fy;
  camera.bottom = camera.top - out.step * height / straight.fy;
  camera.width = width;
  camera.height = height;
  return out;
}

}  // namespace prosector
