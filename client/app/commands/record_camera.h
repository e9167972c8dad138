#pragma once
// `prosector-client camera record`: records a camera's images as a video, which can serve as a camera.

#include "client/app/commands/camera_command.h"

namespace prosector {

/// Writes a camera's images to the video `options.out` (.avi) for `options.seconds` in real time. A synthetic
/// camera's images are rendered one by one without a time limit. Files of the same name hold its lens (.toml)
/// and the true poses in each image (.csv). Returns the program's exit code. Throws InputError if something
/// can't be opened or written.
int record_camera(const CameraCommandOptions& options);

}  // namespace prosector
