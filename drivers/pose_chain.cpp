#include "drivers/pose_chain.h"

namespace prosector {

PoseChain::PoseChain(const DeviceConfig& config) : room_device_(config.room_device), mount_(config.mount) {
  if (!config.field_map.empty()) field_ = load_field_map(config.field_map);
}

Pose PoseChain::from(const Pose& room_device, const Pose& device, std::size_t station) const {
  return room_device * (field_ ? field_->apply(device) : device) * mount_.at(station);
}

}  // namespace prosector
