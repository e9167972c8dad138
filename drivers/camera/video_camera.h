#pragma once
// Cameras, files and streams that OpenCV's video input opens.

#include "drivers/camera/camera.h"

namespace prosector {

/// Opens a V4L2 device ("/dev/video0", or its number), a video's file, which is played at its own pace again
/// and again, or a stream's URL. Throws InputError where it can't be opened.
std::unique_ptr<Camera> open_video(const std::string& address);

}  // namespace prosector
