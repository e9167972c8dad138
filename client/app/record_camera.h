#pragma once
// prosector-client camera record: a camera's pictures as a film, which is a camera again.

#include "client/app/camera_command.h"

namespace prosector {

/// Writes a camera's pictures to `out` (.avi) for that long, at its own pace. A synthetic camera's are drawn
/// one by one, however long that takes: none is late. Beside them go the lens (.toml) and where everything
/// was in each picture (.csv). Returns the exit code. Throws InputError where something can't be opened or
/// written.
int record_camera(const CameraCommandOptions& options);

}  // namespace prosector
