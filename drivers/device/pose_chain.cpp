#include "drivers/device/pose_chain.h"

namespace prosector {

PoseChain::PoseChain(const Placement& placement)
    : room_device_(placement.room_device), mount_(placement.mount) {
  if (!placement.field_map.empty()) field_ = load_field_map(placement.field_map);
}

Pose PoseChain::from(const Pose& room_device, const Pose& device, std::size_t station) const {
  return room_device * (field_ ? field_->apply(device) : device) * mount_.at(station);
}

}  // namespace prosector
