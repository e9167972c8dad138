#include "server/session/recording/recorded_people.h"

#include <utility>

namespace prosector {

void RecordedPeople::go_to(std::uint64_t tick, std::vector<Outgoing>& out) {
  Roster then = index_.people_at(tick);
  for (const auto& [id, member] : now_.members())
    if (then.find(id) == nullptr) out.push_back({Roster::entry(member), true});
  for (const auto& [id, member] : then.members()) {
    const Participant* before = now_.find(id);
    if (before == nullptr || before->role != member.role) out.push_back({Roster::entry(member)});
  }
  now_ = std::move(then);
}

}  // namespace prosector
