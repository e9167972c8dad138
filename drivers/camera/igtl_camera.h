#pragma once
// Pictures that another program sends by OpenIGTLink, as a camera: navigation software, ultrasound,
// endoscopes.

#include "drivers/camera/camera.h"

namespace prosector {

/// Connects to a server, "igtl://HOST[:PORT][/DEVICE]", and takes its IMAGE messages: of that device, else of
/// any. Throws InputError where it can't.
std::unique_ptr<Camera> open_igtl_camera(const std::string& address);
/// Tells whether an address is one of these.
bool is_igtl_camera(const std::string& address);

}  // namespace prosector
