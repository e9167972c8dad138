#pragma once
// Which panels travel this tick, and whether the room's light and pace do: what changed. Both stay for late
// joiners.

#include <map>
#include <vector>

#include "server/session/snapshot.h"

namespace prosector {

class PanelSender {
 public:
  /// Appends what changed since the last call; what closed goes to `ended`, for its instance to end.
  void update(const Snapshot& now, std::vector<Message>& out, std::vector<Message>& ended);

 private:
  std::map<ParticipantId, Panel> sent_;
  double lights_ = 1, pace_ = 1;
};

}  // namespace prosector
