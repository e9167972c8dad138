#pragma once
// Senders that aren't members of the session: not yet, or not any more.

#include <cstdint>
#include <iterator>
#include <map>
#include <optional>

#include "common/ids.h"
#include "idl/bus.h"
#include "server/session/people/session_output.h"

namespace prosector {

/// A sender that isn't a member. It joins with both its Presence and its command.
struct Visitor {
  std::uint64_t writer = 0;
  std::uint64_t seen = 0;  // tick of the newest sample
  std::optional<Presence> presence;
  std::optional<Command> join;
  std::uint64_t join_tick = 0;
};

class Visitors {
 public:
  /// Returns the visitor with that id, which is added if it is new. Null when the id belongs to another
  /// process (counted in `output` as `what`), or when there are too many visitors.
  Visitor* admit(ParticipantId id, std::uint64_t writer, std::uint64_t tick, const char* what,
                 SessionOutput& output);
  /// Returns the visitor with that id. Null if there is none.
  Visitor* find(ParticipantId id);
  /// Calls `settle(id, visitor)` for each visitor, and removes those for which it returns true.
  template <class Settle>
  void remove_if(const Settle& settle) {
    for (auto it = visitors_.begin(); it != visitors_.end();)
      it = settle(it->first, it->second) ? visitors_.erase(it) : std::next(it);
  }
  /// Forgets visitors that have been silent for more than `ticks` ticks, if there are many visitors.
  void forget_silent(std::uint64_t tick, std::uint64_t ticks);

 private:
  std::map<ParticipantId, Visitor> visitors_;
};

}  // namespace prosector
