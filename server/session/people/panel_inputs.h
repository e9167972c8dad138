#pragma once
// Converts participants' messages to the inputs of panels in a tick. Commands become events, movements of
// heads become head places. A panel closes when its owner may no longer use it.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/commands.h"
#include "server/physics/simulation.h"

namespace prosector {

class PanelInputs {
 public:
  /// Starts with the scene's bodies: `parts` has, by body, whether it is a part of the anatomy.
  /// `held_timeout` is the number of ticks without an update after which a held tablet or stylus counts as
  /// gone.
  PanelInputs(std::vector<bool> parts, std::uint64_t held_timeout)
      : parts_(std::move(parts)), held_timeout_(held_timeout) {}

  /// Adds the body with the next id, such as a piece that was cut off. `is_part`: whether it is a part of the
  /// anatomy, which has a panel.
  void add_body(bool is_part) { parts_.push_back(is_part); }

  /// Queues a panel command of participant `who`, a member with the right to touch bodies, for the next tick.
  /// Returns the reason if the command is refused.
  Refusal take(ParticipantId who, const OpenPanel& command);
  Refusal take(ParticipantId who, const ClosePanel& command);
  Refusal take(ParticipantId who, const SetControl& command);
  /// Stores the places of the participant's head and held objects from its newest input, for the next tick.
  /// `has_hands`: whether any of its hands is in the room.
  void see(ParticipantId who, const HandInput& input, bool has_hands);

  /// Appends the queued panel events, head places and places of held objects to the inputs `out` of this
  /// tick. `may_touch(who)` returns whether the participant is in the session and not an observer; the panels
  /// and held objects of others are removed.
  template <class MayTouch>
  void consume(const MayTouch& may_touch, TickInput& out) {
    for (const ParticipantId who : open_)
      if (!may_touch(who)) out.panels.push_back({.kind = panel::PanelEvent::Kind::close, .participant = who});
    for (auto& [held, unseen] : held_)
      if (!may_touch(held.first)) unseen = held_timeout_;
    move_into(out);
  }
  /// Updates the list of participants with an open panel after the step. `panels` are the panels that are
  /// open now.
  void finish_tick(std::span<const Panel> panels);

 private:
  std::vector<bool> parts_;
  std::vector<ParticipantId> open_;
  std::vector<panel::PanelEvent> asked_;
  std::map<ParticipantId, panel::HeadPlace> known_heads_;  // head places that the simulation has
  std::vector<panel::HeadPlace> heads_;
  std::uint64_t held_timeout_;
  std::map<std::pair<ParticipantId, HeldObject>, std::uint64_t> held_;  // ticks since the last update of each
  std::vector<panel::HeldPlace> moved_;

  Refusal ask_of_open(const panel::PanelEvent& event);
  void move_into(TickInput& out);
};

}  // namespace prosector
