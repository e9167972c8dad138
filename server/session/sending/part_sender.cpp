#include "server/session/sending/part_sender.h"

#include <utility>

namespace prosector {

std::vector<Outgoing> PartSender::take(const Simulation& simulation) {
  std::vector<PublishedPart> now(simulation.body_count());
  for (BodyId body = 0; body < now.size(); ++body) now[body].part = simulation.part(body);
  for (const HandState& hand : simulation.hands()) {  // sorted by participant and hand
    if (!hand.holding) continue;
    std::vector<HandRef>& holders = now[*hand.holding].holders;
    if (holders.size() < max_holders)
      holders.push_back({hand.participant, static_cast<std::uint8_t>(hand.hand)});
  }
  if (published_.size() < now.size())
    published_.resize(now.size());  // a recording may go back to before pieces were cut off
  std::vector<Outgoing> out;
  for (BodyId body = 0; body < now.size(); ++body) {
    if (now[body] == published_[body]) continue;
    published_[body] = std::move(now[body]);
    const auto& [part, holders] = published_[body];
    out.push_back({PartState{body, simulation.time(), part.attached, part.hidden, part.lit, part.inspected,
                             part.opacity, part.stiffness, part.shape, holders}});
  }
  return out;
}

}  // namespace prosector
