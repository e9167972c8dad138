#include "server/session/sending/panel_sender.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double least_move = 1e-3;  // of a control's range

bool same(const Panel& a, const Panel& b) {
  if (a.body != b.body || a.pose.p != b.pose.p || a.pose.q.coeffs() != b.pose.q.coeffs()) return false;
  return std::equal(
      a.controls.begin(), a.controls.end(), b.controls.begin(),
      [](const ControlState& x, const ControlState& y) {
        const bool at_end = y.position == 0 || y.position == 1;
        return x.on == y.on && x.touched == y.touched &&
               (x.position == y.position || (!at_end && std::abs(x.position - y.position) < least_move));
      });
}

}  // namespace

void PanelSender::update(const Snapshot& now, std::vector<Message>& out, std::vector<Message>& ended) {
  for (auto it = sent_.begin(); it != sent_.end();) {
    const bool open = std::any_of(now.panels.begin(), now.panels.end(),
                                  [&](const Panel& panel) { return panel.participant == it->first; });
    if (!open) {
      it->second.open = false;
      it->second.time = now.time;
      ended.push_back(it->second);
    }
    it = open ? std::next(it) : sent_.erase(it);
  }
  for (const Panel& panel : now.panels) {
    const auto before = sent_.find(panel.participant);
    if (before != sent_.end() && same(before->second, panel)) continue;
    sent_.insert_or_assign(panel.participant, panel);
    out.push_back(panel);
  }
  if (now.lights == lights_ && now.pace == pace_) return;
  lights_ = now.lights;
  pace_ = now.pace;
  out.push_back(RoomState{now.time, now.lights, now.pace});
}

}  // namespace prosector
