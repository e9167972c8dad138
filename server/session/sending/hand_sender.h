#pragma once
// Selects the users and contacts to send this tick: changes immediately, everything else periodically.

#include <cstdint>
#include <map>
#include <vector>

#include "common/hand_messages.h"
#include "common/ids.h"
#include "common/math.h"
#include "idl/message.h"
#include "server/session/sending/snapshot.h"

namespace prosector {

class HandSender {
 public:
  void update(const Snapshot& now, bool everything, std::vector<Message>& out);

 private:
  struct Sent {
    std::uint64_t input_sequence = 0, tick = 0;
    std::array<Vec3, 2> hands;
  };
  std::map<ParticipantId, Sent> users_;
  std::map<std::pair<ParticipantId, std::uint8_t>, int> let_go_;  // updates since the hand touched something

  void update_user(const UserState& user, bool everything, std::vector<Message>& out);
  void update_contacts(const Snapshot& now, std::vector<Message>& out);
};

}  // namespace prosector
