#pragma once
// Camera whose images another program sends by OpenIGTLink: navigation software, ultrasound, endoscopes.

#include "drivers/camera/base/camera.h"

namespace prosector {

/// Connects to a server, "igtl://HOST[:PORT][/DEVICE]", and receives IMAGE messages of that device, or of any
/// device if none is named. Throws InputError if the connection fails.
std::unique_ptr<Camera> open_igtl_camera(const std::string& address);
/// Reports whether an address has the scheme igtl.
bool is_igtl_camera(const std::string& address);

}  // namespace prosector
