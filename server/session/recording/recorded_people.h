#pragma once
// Participants of a recorded session at the present time of its playback.

#include <cstdint>
#include <vector>

#include "server/session/people/session.h"
#include "server/session/recording/recording_index.h"

namespace prosector {

class RecordedPeople {
 public:
  /// Starts without participants. `index` must outlive the object.
  explicit RecordedPeople(const RecordingIndex& index) : index_(index), now_(SessionRules{}) {}

  /// Goes to the end of `tick`, forwards or backwards. Appends the roster's changes since the last call to
  /// `out`, as messages for clients.
  void go_to(std::uint64_t tick, std::vector<Outgoing>& out);
  /// Returns the recorded participants and observers at the tick of the last call of go_to().
  const Roster& now() const { return now_; }

 private:
  const RecordingIndex& index_;
  Roster now_;
};

}  // namespace prosector
