#pragma once
// Bodies that the user's hands held or touched last.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "client/replica/replica.h"
#include "common/ids.h"

namespace prosector {

/// For each of the user's hands, the body that it held or touched last, as reported by the server.
class HandledBodies {
 public:
  /// Updates the bodies from the replica's newest state of the participant `user`. Forgets all bodies when
  /// the replica follows another run of a server.
  void update(const Replica& replica, ParticipantId user);
  /// Returns the body that the hand (left_hand, right_hand) held at the last update, otherwise the body that
  /// it held or touched last. Returns nullopt if it has neither held nor touched a body.
  std::optional<BodyId> last(std::size_t hand) const { return last_[hand]; }

 private:
  std::uint64_t server_run_ = 0;  // run of the server that numbered the bodies
  std::array<std::optional<BodyId>, 2> last_;
};

}  // namespace prosector
