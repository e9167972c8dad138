#pragma once
// Selects the panels to send this tick, and decides whether to send the room's light and pace: those that
// changed. Late joiners receive the last samples of both.

#include <map>
#include <vector>

#include "server/session/sending/snapshot.h"

namespace prosector {

class PanelSender {
 public:
  /// Appends the changes since the last call. Closed panels go to `ended`, so that their instances are
  /// disposed of.
  void update(const Snapshot& now, std::vector<Message>& out, std::vector<Message>& ended);

 private:
  std::map<ParticipantId, Panel> sent_;
  double lights_ = 1, pace_ = 1;
};

}  // namespace prosector
