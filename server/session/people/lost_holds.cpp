#include "server/session/people/lost_holds.h"

#include <algorithm>

namespace prosector {

std::optional<BodyId> ReleasedHolds::take(const HandRef& hand) {
  const auto found = lost_.find(hand);
  if (found == lost_.end()) return std::nullopt;
  const BodyId body = found->second.body;
  lost_.erase(found);
  return body;
}

std::vector<ReleasedHolds::Lost> ReleasedHolds::of(ParticipantId participant) const {
  std::vector<Lost> out;
  for (const auto& [hand, entry] : lost_)
    if (hand.participant == participant) out.push_back({hand, entry.body});
  return out;
}

std::vector<ReleasedHolds::Lost> ReleasedHolds::follow(std::span<const HandState> hands, std::uint64_t tick) {
  std::vector<Lost> taken;
  for (auto it = lost_.begin(); it != lost_.end();) {
    const auto& [hand, entry] = *it;
    const bool is_held =
        std::ranges::any_of(hands, [&](const HandState& h) { return h.holding == entry.body; });
    if (is_held) taken.push_back({hand, entry.body});
    it = is_held || tick - entry.tick > ticks_ ? lost_.erase(it) : std::next(it);
  }
  return taken;
}

}  // namespace prosector
