#pragma once
// Opens cameras, files and streams with OpenCV's video input.

#include "drivers/camera/base/camera.h"

namespace prosector {

/// Opens a V4L2 device ("/dev/video0" or its number), a video file, or a stream's URL. A file plays at its
/// own rate in a loop. Throws InputError if the source can't be opened.
std::unique_ptr<Camera> open_video(const std::string& address);

}  // namespace prosector
