#include "client/view/session_overlay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "client/view/avatar.h"
#include "client/view/contact_overlay.h"
#include "client/view/corner_axes.h"
#include "client/view/overlay_frame.h"

namespace prosector {
namespace {

/// Adds the contact of the touching hand; if both touch, that of the hand with the larger impulse.
void add_contact(DrawList& list, const Replica& replica, ParticipantId who) {
  const ContactSample* strongest = nullptr;
  for (const std::size_t hand : {right_hand, left_hand}) {
    const ContactSample* contact = replica.contact(who, hand);
    if (contact == nullptr || !contact->touching || contact->body >= replica.scene()->bodies.size()) continue;
    if (strongest == nullptr || contact->impulse > strongest->impulse) strongest = contact;
  }
  if (strongest == nullptr) return;
  const BodyStatus* status = replica.body_status(strongest->body);
  add_contact_overlay(list, *strongest, replica.scene()->bodies[strongest->body].name,
                      status != nullptr ? status->press_error : -1);
}

/// Adds the name of the body at the pointer, and its holders.
void add_pointed_name(DrawList& list, const Replica& replica, const ViewSettings& settings) {
  constexpr double right = 16, above = 30, height = 13;  // points from the pointer
  if (!settings.pointed || *settings.pointed >= replica.scene()->bodies.size()) return;
  const Eigen::Vector2d at = settings.pointer / list.scale + Eigen::Vector2d(right, -above);
  list.texts.push_back({.text = named_with_holders(replica, *settings.pointed, settings.words),
                        .at = {at.x(), at.y(), 0},
                        .height = height});
}

/// Adds lines at the lower border, to the right of the axes.
void add_messages(DrawList& list, const std::vector<std::string>& messages) {
  constexpr double left = 118, lowest = 24, spacing = 18, height = 14, least = 11, margin = 6;  // points
  const double bottom = OverlayFrame(list).lowest - lowest;
  for (std::size_t k = 0; k < messages.size(); ++k)
    list.texts.push_back({.text = messages[k],
                          .at = {left, bottom - spacing * static_cast<double>(messages.size() - 1 - k), 0},
                          .height = height,
                          .wrap = OverlayFrame(list).width - 2 * margin - left,
                          .least_height = least,
                          .tallest = spacing});
}

}  // namespace

const RosterEntry* find_by_name(const Replica& replica, const std::string& name) {
  const RosterEntry* found = nullptr;
  for (const auto& [id, entry] : replica.roster())
    if (entry.name == name && (found == nullptr || found->role == Role::observer)) found = &entry;
  return found;
}

std::string named_with_holders(const Replica& replica, BodyId body, const Catalogue& words) {
  std::string out = replica.scene()->bodies[body].name;
  std::set<std::string> holders;
  if (const PartState* part = replica.part(body))
    for (const HandRef& hand : part->holders)
      if (const auto who = replica.roster().find(hand.participant); who != replica.roster().end())
        holders.insert(who->second.name);
  if (!holders.empty()) out += words.tr(", held by {}", fmt::format("{}", fmt::join(holders, ", ")));
  return out;
}

void add_session_overlay(DrawList& list, const Replica& replica, const LocalUser& self,
                         const ViewSettings& settings) {
  if (settings.time) {
    list.strip = time_bar_strip;
    add_time_bar(list, *settings.time);
  }
  add_corner_axes(list, replica.scene()->patient, list.cameras.front());
  const auto line = [&](int row, std::string text) {
    list.texts.push_back({.text = std::move(text), .at = {10, 10 + 18.0 * row, 0}, .height = 14});
  };
  const SessionInfo& session = *replica.session();
  const Catalogue& words = settings.words;
  line(0, fmt::format("{} - {}", session.session, session.scene));
  if (const auto& status = replica.status())
    line(1, words.tr("x{:.2f}  step {:.1f} ms  {}  {}", status->real_time_factor, status->step_ms_p50,
                     status->participants == 1 ? std::string(words.tr("1 participant"))
                                               : words.tr("{} participants", status->participants),
                     status->observers == 1 ? std::string(words.tr("1 observer"))
                                            : words.tr("{} observers", status->observers)));
  if (replica.server_gone())
    line(2, words.tr("the server does not respond; waiting"));
  else if (replica.recording())
    line(2, words.tr("a recording"));
  else if (replica.time().pace() == 0)
    line(2, words.tr("time stopped"));
  else if (replica.time().pace() < 1)
    line(2, words.tr("slow motion, {:g} of real time", replica.time().pace()));
  if (!settings.follow.empty())
    line(3, find_by_name(replica, settings.follow) != nullptr
                ? words.tr("view of {}", settings.follow)
                : words.tr("{} is not in the session; showing your own view", settings.follow));
  add_messages(list, settings.messages);
  add_pointed_name(list, replica, settings);
  if (const RosterEntry* followed = find_by_name(replica, settings.follow))
    add_contact(list, replica, followed->participant);
  else if (self.present)
    add_contact(list, replica, self.participant);
}

}  // namespace prosector
