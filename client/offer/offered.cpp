#include "client/offer/offered.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "client/view/held_bodies.h"

namespace prosector {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.';
}

/// Shortens the name so that its ending fits.
std::string fitted(const std::string& name, const std::string& ending) {
  return name.substr(0, longest_offered_name - ending.size()) + ending;
}

}  // namespace

std::vector<Offered> offered(const Replica& replica, double tick) {
  std::vector<Offered> out;
  std::set<BodyId> held;
  for (const auto& [id, entry] : replica.roster()) {
    const auto user = replica.user(id, tick);
    if (!user) continue;
    if (user->head_tracked) out.push_back({entry.name + ".head", user->head});
    for (const std::size_t hand : {left_hand, right_hand}) {
      if (user->hands[hand].tracked)
        out.push_back({entry.name + (hand == left_hand ? ".left" : ".right"), user->hands[hand].pose});
      for (const BodyId body : held_by(replica, {id, static_cast<std::uint8_t>(hand)}))
        if (replica.bodies().rigid(body) != nullptr && held.insert(body).second)
          out.push_back({replica.scene()->bodies[body].name, replica.rigid_pose(body, tick)});
    }
  }
  make_names_valid(out);
  return out;
}

void make_names_valid(std::vector<Offered>& all) {
  std::set<std::string> taken;
  for (Offered& thing : all) {
    std::ranges::replace_if(
        thing.name, [](char c) { return !is_plain(c); }, '_');
    const std::size_t dot = std::min(thing.name.rfind('.'), thing.name.size());
    const std::string whose = thing.name.substr(0, dot), what = thing.name.substr(dot);
    const std::string ending = what.size() < longest_offered_name / 2 ? what : "";
    std::string name = fitted(whose, ending);
    for (int k = 2; !taken.insert(name).second; ++k) name = fitted(whose, fmt::format("-{}{}", k, ending));
    thing.name = name;
  }
}

}  // namespace prosector
