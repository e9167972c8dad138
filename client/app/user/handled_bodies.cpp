#include "client/app/user/handled_bodies.h"

#include <utility>
#include <vector>

#include "client/view/held_bodies.h"

namespace prosector {
namespace {

/// Returns the body that the hand holds, otherwise the body that it touches; nullopt if there is none.
std::optional<BodyId> handled(const Replica& replica, const HandRef& hand) {
  if (const std::vector<BodyId> held = held_by(replica, hand); !held.empty()) return held.front();
  const ContactSample* touch = replica.contact(hand.participant, hand.hand);
  const bool touches = touch != nullptr && touch->touching && touch->body < replica.scene()->bodies.size();
  return touches ? std::optional(touch->body) : std::nullopt;
}

}  // namespace

void HandledBodies::update(const Replica& replica, ParticipantId user) {
  if (!replica.session() || !replica.scene()) return;
  const std::uint64_t run = replica.session()->server_run;
  if (std::exchange(server_run_, run) != run) last_ = {};
  for (const std::size_t hand : {left_hand, right_hand})
    if (const auto body = handled(replica, {user, static_cast<std::uint8_t>(hand)})) last_[hand] = body;
}

}  // namespace prosector
