#include "server/session/people/roster.h"

#include <fmt/format.h>

#include <algorithm>

namespace prosector {
namespace {

/// Colours that differ from tissue and from each other, also for the colour-blind (after Okabe and Ito). The
/// first free one is assigned.
constexpr std::array<std::array<double, 3>, 8> colors = {{{0.00, 0.17, 0.45},
                                                          {0.90, 0.35, 0.00},
                                                          {0.00, 0.34, 0.17},
                                                          {0.87, 0.77, 0.05},
                                                          {0.09, 0.46, 0.82},
                                                          {0.60, 0.19, 0.39},
                                                          {0.05, 0.05, 0.05},
                                                          {0.80, 0.80, 0.80}}};

bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32; });
}

}  // namespace

std::string SessionRules::name_of(BodyId body) const {
  return body < names.size() ? names[body] : fmt::format("body {}", body);
}

Refusal Roster::refusal(const Presence& p) const {
  if (p.version != protocol_version)
    return fmt::format(
        "this server uses protocol version {}, your client version {}: install the same release on both",
        protocol_version, p.version);
  if (p.name.find_first_not_of(' ') == std::string::npos) return "a name is needed (--name NAME)";
  if (has_control_character(p.name)) return "the name has control characters";
  for (const auto& [id, other] : members_)
    if (other.presence.name == p.name)
      return fmt::format("the name \"{}\" is taken in this session: choose another name", p.name);
  if (p.role != Role::observer && p.role != Role::dissector && p.role != Role::host)
    return fmt::format("no such role: {}", static_cast<int>(p.role));
  if (p.role == Role::host)
    for (const auto& [id, other] : members_)
      if (other.role == Role::host)
        return fmt::format("the session already has a host: \"{}\". Join without the role of host",
                           other.presence.name);
  if (members_.size() >= static_cast<std::size_t>(rules_.capacity))
    return fmt::format(
        "session full: {} participants, observers included. Ask the host to raise `session.capacity`",
        rules_.capacity);
  if (p.role == Role::observer && observers() >= static_cast<std::uint32_t>(rules_.observers))
    return fmt::format(
        "no free place for an observer: all {} are taken. Ask the host to raise `session.observers`",
        rules_.observers);
  return {};
}

bool Roster::in_anothers_place(const Presence& p) const {
  return std::ranges::any_of(members_, [&](const auto& m) {
    return m.second.presence.name == p.name || (p.role == Role::host && m.second.role == Role::host);
  });
}

Refusal Roster::role_refusal(const Participant& subject, Role role) const {
  if (rules_.recording && role == Role::dissector) return "this is a recording: join as an observer";
  if (role == Role::observer && subject.role != Role::observer &&
      observers() >= static_cast<std::uint32_t>(rules_.observers))
    return fmt::format(
        "no free place for an observer: all {} are taken. Ask the host to raise `session.observers`",
        rules_.observers);
  return {};
}

const Participant& Roster::admit(const Presence& presence, std::uint64_t writer) {
  std::uint32_t color = 0;
  const auto taken = [&](std::uint32_t c) {
    return std::any_of(members_.begin(), members_.end(), [c](const auto& m) { return m.second.color == c; });
  };
  while (taken(color)) ++color;
  const bool watches = rules_.recording && presence.role == Role::dissector;
  return members_[presence.participant] = {presence, watches ? Role::observer : presence.role, writer, color};
}

Participant* Roster::find(ParticipantId id) {
  const auto it = members_.find(id);
  return it == members_.end() ? nullptr : &it->second;
}

std::uint32_t Roster::participants() const {
  return static_cast<std::uint32_t>(members_.size()) - observers();
}

std::uint32_t Roster::observers() const {
  return static_cast<std::uint32_t>(std::count_if(
      members_.begin(), members_.end(), [](const auto& m) { return m.second.role == Role::observer; }));
}

RosterEntry Roster::entry(const Participant& p) {
  const auto& rgb = colors[p.color % colors.size()];
  return {p.presence.participant, p.presence.name, p.role, {rgb[0], rgb[1], rgb[2]}, p.presence.devices};
}

}  // namespace prosector
