#pragma once
// Camera whose images another program sends by OpenIGTLink: navigation software, ultrasound, endoscopes.

#include "drivers/camera/base/camera.h"

namespace prosector {

/// Connects to the OpenIGTLink server at "igtl://HOST[:PORT][/DEVICE]". Returns a camera with the images that
/// this device, or any device if none is named, sends as IMAGE messages. Throws InputError if the connection
/// fails.
std::unique_ptr<Camera> open_igtl_camera(const std::string& address);
/// Reports whether a camera's address begins with "igtl://", so that another program sends its images by
/// OpenIGTLink.
bool is_igtl_camera(const std::string& address);

}  // namespace prosector
