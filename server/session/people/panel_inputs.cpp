#include "server/session/people/panel_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/panel_placement.h"

namespace prosector {
namespace {

constexpr double head_step = 0.01;  // m: smaller movements of a head are not passed on
constexpr double head_turn = 0.05;  // smaller changes of a head's unit direction are not passed on

/// Returns the horizontal unit vector of the direction that a head faces, also when it looks steeply up or
/// down; zero if it lies on its side.
Vec3 direction_ahead(const Pose& head) {
  const Vec3 level = Vec3::UnitY().cross(head.q * Vec3::UnitX());
  return level.norm() > 0.1 ? Vec3(level.normalized()) : Vec3::Zero();
}

}  // namespace

Refusal PanelInputs::take(ParticipantId who, const OpenPanel& command) {
  const auto& [body, placing, at] = command;
  if (placing > last_panel_placement)
    return fmt::format("unknown panel placement {}", fmt::underlying(placing));
  panel::PanelEvent event{.participant = who, .body = body, .at = at};
  if (placing != PanelPlacement::stays) {
    event.kind =
        placing == PanelPlacement::put ? panel::PanelEvent::Kind::put : panel::PanelEvent::Kind::put_back;
    return ask_of_open(event);
  }
  if (body >= parts_.size())
    return fmt::format("no body {}: the scene has {} bodies, numbered from 0", body, parts_.size());
  if (!parts_[body]) return "only parts of the anatomy have a panel";
  asked_.push_back(event);
  return {};
}

Refusal PanelInputs::take(ParticipantId who, const ClosePanel&) {
  return ask_of_open({.kind = panel::PanelEvent::Kind::close, .participant = who});
}

Refusal PanelInputs::take(ParticipantId who, const SetControl& command) {
  return ask_of_open({.kind = panel::PanelEvent::Kind::set,
                      .participant = who,
                      .control = command.control,
                      .value = command.value});
}

/// Queues an event of a participant's open panel. Refuses it if there is none.
Refusal PanelInputs::ask_of_open(const panel::PanelEvent& event) {
  if (std::find(open_.begin(), open_.end(), event.participant) == open_.end())
    return "you have no panel open";
  asked_.push_back(event);
  return {};
}

void PanelInputs::see(ParticipantId who, const HandInput& input, bool has_hands) {
  for (std::size_t k = 0; k < held_things; ++k) {
    if (!input.held[k].tracked) continue;
    const auto thing = static_cast<HeldObject>(k);
    moved_.push_back({who, thing, true, input.held[k].pose});
    held_[{who, thing}] = 0;
  }
  if (!has_hands) known_heads_.erase(who);  // the simulation forgets the head, too
  if (!input.head_tracked || !has_hands) return;
  const panel::HeadPlace head{who, input.head.p, direction_ahead(input.head)};
  const auto [known, is_new] = known_heads_.try_emplace(who, head);
  const panel::HeadPlace& last = known->second;
  if (!is_new && (head.at - last.at).norm() < head_step && (head.ahead - last.ahead).norm() < head_turn)
    return;
  known->second = head;
  heads_.push_back(head);
}

void PanelInputs::move_into(TickInput& out) {
  for (const panel::PanelEvent& event : asked_) out.panels.push_back(event);
  asked_.clear();
  out.heads = std::exchange(heads_, {});
  out.held = std::exchange(moved_, {});
  for (auto it = held_.begin(); it != held_.end();) {
    auto& [held, unseen] = *it;
    const bool lost = unseen >= held_timeout_;
    if (lost) out.held.push_back({held.first, held.second, false, {}});
    ++unseen;
    it = lost ? held_.erase(it) : std::next(it);
  }
}

void PanelInputs::finish_tick(std::span<const Panel> panels) {
  open_.clear();
  for (const Panel& panel : panels) open_.push_back(panel.participant);
}

}  // namespace prosector
