#include "client/view/parts_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "client/replica/shown_names.h"
#include "client/text/search_key.h"

namespace prosector {
namespace {

enum class Group : std::uint8_t { anatomy, bones, things, room };
constexpr std::array<const char*, 4> group_names = {msg("Anatomy"), msg("Bones"),
                                                    msg("Instruments and objects"), msg("Room")};

Group group_of(const SceneBody& body) {
  if (body.appearance.surface == Surface::bone) return Group::bones;  // including unattached ones
  if (body.part) return Group::anatomy;
  return body.moves || body.kind == BodyKind::soft ? Group::things : Group::room;
}

bool is_meant(const SceneBody& body, std::u32string_view searched) {
  if (is_found(search_key(body.name), searched) || is_found(search_key(body.term), searched)) return true;
  return std::ranges::any_of(
      body.names, [&](const LocalName& name) { return is_found(search_key(name.name), searched); });
}

std::vector<PartHolder> holders_of(const Replica& replica, BodyId body) {
  std::vector<PartHolder> out;
  const PartState* part = replica.part(body);
  if (part == nullptr) return out;
  for (const HandRef& hand : part->holders)
    if (const auto who = replica.roster().find(hand.participant); who != replica.roster().end())
      if (const PartHolder holder{who->second.name, who->second.color};
          std::ranges::find(out, holder) == out.end())
        out.push_back(holder);
  return out;
}

/// Returns the row of an organ and the pieces cut from it.
PartRow row_of(const PartsData& known, const PartsChoice& choice, BodyId organ) {
  const SceneBody& body = known.scene.bodies[organ];
  PartRow row{.text = body.name, .parts = {authors_name(body)}, .color = body.appearance.color};
  row.look = choice.look_of(row.parts.front(), body.part);
  row.isolated = choice.is_isolated(row.parts.front());
  if (row.look.color) row.color = *row.look.color;
  for (BodyId other = organ; other < known.organs.size(); ++other) {
    if (known.organs[other] != organ) continue;
    row.bodies.push_back(other);
    for (const PartHolder& holder : known.holders[other])
      if (std::ranges::find(row.holders, holder) == row.holders.end()) row.holders.push_back(holder);
  }
  return row;
}

/// Returns a group's heading, whose controls act on all rows of the group.
PartRow head_of(Group group, const std::vector<PartRow>& rows, const Catalogue& words) {
  PartRow head{
      .is_head = true,
      .text = fmt::format("{} · {}", words.tr(group_names[static_cast<std::size_t>(group)]), rows.size()),
      .color = rows.front().color};
  head.look.hidden = head.isolated = true;
  for (const PartRow& row : rows) {
    head.parts.insert(head.parts.end(), row.parts.begin(), row.parts.end());
    head.look.hidden = head.look.hidden && row.look.hidden;
    head.look.opacity = std::min(head.look.opacity, row.look.opacity);
    head.isolated = head.isolated && row.isolated;
  }
  return head;
}

std::vector<BodyId> organs_known(const Replica& replica) {
  return organs_of(*replica.scene(), [&](BodyId body) {
    const TopologyRevision* shown = replica.bodies().topology(body);
    return shown != nullptr ? shown->piece_of : -1;
  });
}

}  // namespace

std::vector<PartLook> looks_of(const Replica& replica, const PartsChoice& choice) {
  std::vector<PartLook> out;
  for (const BodyId organ : organs_known(replica)) {
    const SceneBody& body = replica.scene()->bodies[organ];
    out.push_back(choice.look_of(authors_name(body), body.part));
  }
  return out;
}

PartsData parts_data(const Replica& replica) {
  PartsData known;
  if (!replica.scene()) return known;
  known.scene = *replica.scene();
  known.organs = organs_known(replica);
  for (BodyId body = 0; body < known.scene.bodies.size(); ++body)
    known.holders.push_back(holders_of(replica, body));
  return known;
}

std::vector<PartRow> part_rows(const PartsData& known, const PartsChoice& choice, std::string_view search,
                               const Catalogue& words) {
  const std::u32string searched = search_key(search);
  std::array<std::vector<PartRow>, group_names.size()> groups;
  for (BodyId body = 0; body < known.scene.bodies.size(); ++body)
    if (const SceneBody& part = known.scene.bodies[body];
        known.organs[body] == body && is_meant(part, searched))
      groups[static_cast<std::size_t>(group_of(part))].push_back(row_of(known, choice, body));
  std::vector<PartRow> out;
  for (std::size_t group = 0; group < groups.size(); ++group) {
    if (groups[group].empty()) continue;
    out.push_back(head_of(static_cast<Group>(group), groups[group], words));
    std::ranges::move(groups[group], std::back_inserter(out));
  }
  return out;
}

std::vector<std::string> parts_called(const PartsData& known, std::string_view name) {
  std::vector<std::string> out;
  for (const SceneBody& body : known.scene.bodies)
    if (is_called(body, name)) return {authors_name(body)};
  const std::u32string searched = search_key(name);
  if (searched.empty()) return out;
  for (BodyId body = 0; body < known.scene.bodies.size(); ++body)
    if (known.organs[body] == body && is_meant(known.scene.bodies[body], searched))
      out.push_back(authors_name(known.scene.bodies[body]));
  return out;
}

std::string rows_as_text(const std::vector<PartRow>& rows) {
  std::string out;
  for (const PartRow& row : rows) {
    out += fmt::format("{}{}{}", out.empty() ? "" : "\n", row.is_head ? "" : "  ", row.text);
    if (row.is_head) continue;
    if (row.look.hidden)
      out += ", hidden";
    else if (row.look.opacity < 1)
      out += fmt::format(", {:.0f} %", 100 * row.look.opacity);
    if (row.isolated) out += ", isolated";
    for (const PartHolder& holder : row.holders) out += ", held by " + holder.name;
  }
  return out.empty() ? "no part has this name or number" : out;
}

}  // namespace prosector
