#pragma once
// Selects the panels to send this tick, and decides whether to send the room's light and pace: those that
// changed. Late joiners receive the last samples of both.

#include <map>
#include <vector>

#include "server/session/sending/snapshot.h"

namespace prosector {

class PanelSender {
 public:
  /// Appends messages for control panels, and for the room's light and pace, that changed since the last call
  /// to `out`. Panels that were closed are appended to `ended`, so that their DDS instances are disposed of.
  void update(const Snapshot& now, std::vector<Message>& out, std::vector<Message>& ended);

 private:
  std::map<ParticipantId, Panel> sent_;
  double lights_ = 1, pace_ = 1;
};

}  // namespace prosector
