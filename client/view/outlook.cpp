#include "client/view/outlook.h"

namespace prosector {
namespace {

Overlays fitting(const Mono& /*mono*/) {
  return {};
}
Overlays fitting(const StereoProfile& /*stereo*/) {
  return {.insets = false};
}
// A text over the frame would be at a different angle in each eye.
Overlays fitting(const HeadsetEyes& /*eyes*/) {
  return {.insets = false, .over_frame = false};
}
Overlays fitting(const WindowCamera& /*window*/) {
  return {};
}
Overlays fitting(const CameraOverlay& /*through*/) {
  return {.insets = false, .virtual_room = false};
}

}  // namespace

Overlays overlays_of(const Projection& projection) {
  return std::visit([](const auto& one) { return fitting(one); }, projection);
}

}  // namespace prosector
