#include "drivers/camera/face/eyes_filter.h"

namespace prosector {

Pose EyesFilter::update(const Pose& camera_head, std::int64_t time_ns) {
  const double z = camera_head.p.z();
  const Pose across = across_.update({camera_head.p / z, camera_head.q}, time_ns);
  const Pose along = along_.update({Vec3(0, 0, z), Quat::Identity()}, time_ns);
  return {along.p.z() * across.p, across.q};
}

}  // namespace prosector
