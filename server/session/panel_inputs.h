#pragma once
// What participants send as what panels consume in a tick: commands become events, heads that moved become
// places, and a panel whose owner may no longer work it closes.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

constexpr bool is_panel_command(CommandKind kind) {
  return kind == CommandKind::open_panel || kind == CommandKind::close_panel ||
         kind == CommandKind::set_control;
}

class PanelInputs {
 public:
  /// Takes, by body, whether it is a part of the anatomy.
  /// `held_timeout`: ticks without news after which what is held counts as lost.
  PanelInputs(std::vector<bool> parts, std::uint64_t held_timeout)
      : parts_(std::move(parts)), held_timeout_(held_timeout) {}

  /// Adds the next body.
  void add_body(bool is_part) { parts_.push_back(is_part); }

  /// Takes one of the panel commands of somebody who may touch, or returns why not.
  Refusal take(const Command& command);
  /// Takes a participant's newest input; `has_hands` when one of its hands is in the room.
  void see(ParticipantId who, const HandInput& input, bool has_hands);

  /// Appends what this tick consumes. `may_touch(who)`: still in the session, and no observer.
  template <class MayTouch>
  void consume(const MayTouch& may_touch, TickInput& out) {
    for (const ParticipantId who : open_)
      if (!may_touch(who)) out.panels.push_back({.kind = PanelEvent::Kind::close, .participant = who});
    for (auto& [held, unseen] : held_)
      if (!may_touch(held.first)) unseen = held_timeout_;
    move_into(out);
  }
  /// Takes, after the step, whose panels are open.
  void finish_tick(std::span<const Panel> panels);

 private:
  std::vector<bool> parts_;
  std::vector<ParticipantId> open_;
  std::vector<PanelEvent> asked_;
  std::map<ParticipantId, HeadPlace> told_;  // how the simulation believes heads to be
  std::vector<HeadPlace> heads_;
  std::uint64_t held_timeout_;
  std::map<std::pair<ParticipantId, HeldThing>, std::uint64_t> held_;  // ticks since each was told of
  std::vector<HeldPlace> moved_;

  void move_into(TickInput& out);
};

}  // namespace prosector
