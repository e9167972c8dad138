#pragma once
// Opens cameras, files and streams with OpenCV's video input.

#include "drivers/camera/base/camera.h"

namespace prosector {

/// Opens a camera by OpenCV: a V4L2 device ("/dev/video0" or its number), a video file, a still image, or a
/// stream's URL. A video file plays at its own rate in a loop. Throws InputError if the source cannot be
/// opened.
std::unique_ptr<Camera> open_video(const std::string& address);

}  // namespace prosector
