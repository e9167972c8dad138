#include "client/view/shown_effort.h"

namespace prosector {

std::optional<ShownEffort> shown_effort(const Replica& replica, BodyId body, ParticipantId viewer) {
  const BodyStatus* status = replica.body_status(body);
  if (status == nullptr) return std::nullopt;
  const auto self = replica.roster().find(viewer);
  const bool is_host = self != replica.roster().end() && self->second.role == Role::host;
  return ShownEffort{status->stepped_down, replica.status() ? replica.status()->step_ms_p50 : 0,
                     status->error, status->prices, is_host};
}

}  // namespace prosector
