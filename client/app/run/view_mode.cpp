#include "client/app/run/view_mode.h"

#include "client/view/camera.h"

namespace prosector {

std::optional<Pose> ViewMode::eye() const {
  const auto& from = client_.looks_from;
  return from ? std::optional(look_at(from->eye, from->target)) : std::nullopt;
}

}  // namespace prosector
