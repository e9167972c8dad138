#include "client/view/people.h"

#include <chrono>

#include "client/view/avatar.h"

namespace prosector {
namespace {

Appearance glove(const Vec3& color) {
  // A glove in the user's colour, pale enough that shading shows.
  return {.color = 0.35 * Vec3(0.85, 0.83, 0.8) + 0.55 * color, .roughness = 0.55, .surface = Surface::skin};
}

}  // namespace

void People::add(DrawList& list, const Replica& replica, double tick, const LocalUser& self,
                 const std::string& seen_through, std::uint64_t& next_mesh_id) {
  if (!head_) head_ = head_mesh(next_mesh_id++);
  if (self.present) {
    const auto me = replica.roster().find(self.participant);
    const Vec3 color = me == replica.roster().end() ? Vec3(Vec3::Ones()) : me->second.color;
    add_hands(list, self.participant, self.input.hands, color, next_mesh_id);
  }
  for (const auto& [id, entry] : replica.roster()) {
    const auto user = replica.user(id, tick);
    if (!user || (self.present && id == self.participant)) continue;
    add_hands(list, id, user->hands, entry.color, next_mesh_id);
    if (user->head_tracked && entry.name != seen_through)
      add_avatar(list, head_, user->head, entry.color, entry.name);
  }
}

void People::add_hands(DrawList& list, ParticipantId who, const std::array<HandPose, 2>& hands,
                       const Vec3& color, std::uint64_t& next_mesh_id) {
  if (!skins_ && skins_to_come_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    skins_ = skins_to_come_.get();
  if (!skins_) return;
  for (const std::size_t hand : {left_hand, right_hand}) {
    if (!hands[hand].tracked) continue;
    const HandSkin& skin = (*skins_)[hand];
    auto& mesh = hands_[{who, hand}];
    if (!mesh) mesh = skin.make_mesh(next_mesh_id++);
    skin.bend(*mesh, hands[hand].flexion);
    list.items.push_back({.mesh = mesh, .pose = hands[hand].pose, .appearance = glove(color)});
  }
}

}  // namespace prosector
