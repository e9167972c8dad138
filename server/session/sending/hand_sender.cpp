#include "server/session/sending/hand_sender.h"

#include <algorithm>
#include <tuple>

namespace prosector {
namespace {

constexpr std::uint64_t user_refresh_ticks = 15;
constexpr int let_go_updates = 10;  // updates in which "no longer touching" is repeated: samples get lost
constexpr double min_hand_shift = 1e-5;  // m: smaller movements of a hand are not sent

}  // namespace

void HandSender::update(const Snapshot& now, bool everything, std::vector<Message>& out) {
  for (const UserState& user : now.users) update_user(user, everything, out);
  std::erase_if(users_, [&](const auto& sent) {
    return std::none_of(now.users.begin(), now.users.end(),
                        [&](const UserState& u) { return u.participant == sent.first; });
  });
  update_contacts(now, out);
  for (const FeltPlanes& felt : now.felt) out.push_back(felt);
}

/// Appends contacts. The end of a contact is repeated for some updates, not ticks: on a busy machine not
/// every tick is published. A hand that vanished is reported as touching nothing, too.
void HandSender::update_contacts(const Snapshot& now, std::vector<Message>& out) {
  for (auto& [key, updates] : let_go_) ++updates;
  for (const ContactSample& contact : now.contacts)
    if (contact.touching || contact.impact >= 0) {
      let_go_[{contact.participant, contact.hand}] = 0;
      out.push_back(contact);
    }
  for (const auto& [key, updates] : let_go_) {
    if (updates == 0) continue;
    ContactSample nothing;
    std::tie(nothing.participant, nothing.hand) = key;
    nothing.time = now.time;
    out.push_back(nothing);
  }
  std::erase_if(let_go_, [](const auto& hand) { return hand.second >= let_go_updates; });
}

void HandSender::update_user(const UserState& user, bool everything, std::vector<Message>& out) {
  const auto [it, is_new] = users_.try_emplace(user.participant);
  Sent& sent = it->second;
  bool send = is_new || everything || user.input_sequence != sent.input_sequence ||
              user.time.tick - sent.tick >= user_refresh_ticks;
  for (std::size_t h = 0; h < 2; ++h) send |= (user.hands[h].pose.p - sent.hands[h]).norm() > min_hand_shift;
  if (!send) return;
  sent = {user.input_sequence, user.time.tick, {user.hands[0].pose.p, user.hands[1].pose.p}};
  out.push_back(user);
}

}  // namespace prosector
