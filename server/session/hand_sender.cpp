#include "server/session/hand_sender.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::uint64_t user_refresh_ticks = 15;
constexpr std::uint64_t let_go_ticks = 10;  // "no longer touching" is repeated: samples get lost
constexpr double min_shift = 1e-5;          // m

}  // namespace

void HandSender::update(const Snapshot& now, bool everything, std::vector<Message>& out) {
  for (const UserState& user : now.users) update_user(user, everything, out);
  std::erase_if(users_, [&](const auto& sent) {
    return std::none_of(now.users.begin(), now.users.end(),
                        [&](const UserState& u) { return u.participant == sent.first; });
  });
  for (const ContactSample& contact : now.contacts) {
    const std::pair key(contact.participant, contact.hand);
    if (contact.touching) touched_[key] = now.time.tick;
    const auto last = touched_.find(key);
    if (last != touched_.end() && now.time.tick - last->second <= let_go_ticks) out.push_back(contact);
  }
  std::erase_if(touched_, [&](const auto& t) { return now.time.tick - t.second > let_go_ticks; });
}

void HandSender::update_user(const UserState& user, bool everything, std::vector<Message>& out) {
  const auto [it, is_new] = users_.try_emplace(user.participant);
  Sent& sent = it->second;
  bool send = is_new || everything || user.input_sequence != sent.input_sequence ||
              user.time.tick - sent.tick >= user_refresh_ticks;
  for (std::size_t h = 0; h < 2; ++h) send |= (user.hands[h].pose.p - sent.hands[h]).norm() > min_shift;
  if (!send) return;
  sent = {user.input_sequence, user.time.tick, {user.hands[0].pose.p, user.hands[1].pose.p}};
  out.push_back(user);
}

}  // namespace prosector
