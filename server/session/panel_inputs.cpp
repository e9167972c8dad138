#include "server/session/panel_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/panel_placing.h"

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

Refusal PanelInputs::take(const Command& command) {
  const auto ask = [&](PanelEvent::Kind kind) {
    asked_.push_back(
        {kind, command.participant, command.body, command.control, command.value, command.shape.p});
    return Refusal();
  };
  const auto placing = static_cast<PanelPlacing>(command.revision);
  if (command.kind == CommandKind::open_panel && placing > last_panel_placing)
    return fmt::format("no way {} to place a panel", command.revision);
  if (command.kind == CommandKind::open_panel && placing == PanelPlacing::stays) {
    if (command.body >= parts_.size())
      return fmt::format("no body {}: the scene has {}", command.body, parts_.size());
    if (!parts_[command.body]) return "only parts of the anatomy have a panel";
    return ask(PanelEvent::Kind::open);
  }
  const bool open = std::find(open_.begin(), open_.end(), command.participant) != open_.end();
  if (!open) return "you have no panel open";
  if (command.kind == CommandKind::close_panel) return ask(PanelEvent::Kind::close);
  if (command.kind == CommandKind::set_control) return ask(PanelEvent::Kind::set);
  return ask(placing == PanelPlacing::put ? PanelEvent::Kind::put : PanelEvent::Kind::put_back);
}

void PanelInputs::see(ParticipantId who, const HandInput& input, bool has_hands) {
  for (std::size_t k = 0; k < held_things; ++k) {
    if (!input.held[k].tracked) continue;
    const auto thing = static_cast<HeldThing>(k);
    moved_.push_back({who, thing, true, input.held[k].pose});
    held_[{who, thing}] = 0;
  }
  if (!has_hands) told_.erase(who);  // the simulation forgets the head, too
  if (!input.head_tracked || !has_hands) return;
  const HeadPlace head{who, input.head.p, direction_ahead(input.head)};
  const auto [told, is_new] = told_.try_emplace(who, head);
  const HeadPlace& last = told->second;
  if (!is_new && (head.at - last.at).norm() < head_step && (head.ahead - last.ahead).norm() < head_turn)
    return;
  told->second = head;
  heads_.push_back(head);
}

void PanelInputs::move_into(TickInput& out) {
  for (const PanelEvent& event : asked_) out.panels.push_back(event);
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
