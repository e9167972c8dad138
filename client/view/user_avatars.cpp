#include "client/view/user_avatars.h"

#include <chrono>

#include "client/view/hand_nails.h"

namespace prosector {
namespace {

Appearance glove(const Vec3& color) {
  // A glove in the user's colour, pale enough that shading shows.
  return {.color = 0.35 * Vec3(0.85, 0.83, 0.8) + 0.55 * color, .roughness = 0.55, .surface = Surface::skin};
}

// m between hand and target: minimum distance at which the target is shown.
constexpr double ghost_from = 0.01;
constexpr double ghost_opacity = 0.25;
constexpr double own_sleeve_opacity = 0.15;  // of the user whose eyes the view uses

/// Marks the user's own hand as a real object in the camera image.
void mark_as_real(DrawItem& item) {
  item.showing = ItemRole::real;
  item.appearance = {};
}

Vec3 color_of(const Replica& replica, ParticipantId who) {
  const auto entry = replica.roster().find(who);
  return entry == replica.roster().end() ? Vec3(Vec3::Ones()) : entry->second.color;
}

}  // namespace

void UserAvatars::take_shapes(std::uint64_t& next_mesh_id) {
  const auto is_there = [](const auto& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  if (shapes_ || !is_there(skins_to_come_) || !is_there(figure_to_come_)) return;
  shapes_.emplace(Shapes{skins_to_come_.get(), FigureMeshes(figure_to_come_.get(), next_mesh_id)});
  next_mesh_id += FigureMeshes::meshes;
}

void UserAvatars::add(DrawList& list, const Replica& replica, double tick, const LocalUser& self,
                      const ViewSettings& settings, std::uint64_t& next_mesh_id) {
  own_hands_.clear();
  own_sleeves_.clear();
  take_shapes(next_mesh_id);
  if (!shapes_) return;
  if (self.present) add_self(list, replica, tick, self, settings, next_mesh_id);
  for (const auto& [id, entry] : replica.roster()) {
    const auto user = replica.user(id, tick);
    if (!user || (self.present && id == self.participant)) continue;
    add_hands(list, id, user->hands, entry.color, next_mesh_id);
    add_figure(list, *user, entry, entry.name == settings.follow);
  }
}

void UserAvatars::add_figure(DrawList& list, const UserState& user, const RosterEntry& entry,
                             bool is_seen_through) {
  add_forearms(list, user.hands, user.head_tracked ? std::optional(user.head) : std::nullopt, entry.color,
               is_seen_through ? own_sleeve_opacity : 1);
  if (user.head_tracked && !is_seen_through)
    add_avatar(list, shapes_->figure, user.head, entry.color, entry.name);
}

/// Adds sleeves behind tracked wrists. `head`: the user's head, from which the elbows' positions follow.
void UserAvatars::add_forearms(DrawList& list, const std::array<HandPose, 2>& hands,
                               const std::optional<Pose>& head, const Vec3& color, double opacity) const {
  const std::size_t sleeves = list.items.size();
  for (const std::size_t hand : {left_hand, right_hand}) {
    if (!hands[hand].tracked) continue;
    const Pose& wrist = hands[hand].pose;
    // Without a head pose, the forearm is straight.
    add_forearm(list, shapes_->figure, head ? forearm_behind(wrist, bust_below(*head), hand) : wrist, color);
  }
  for (std::size_t k = sleeves; k < list.items.size(); ++k) list.items[k].opacity = opacity;
}

void UserAvatars::add_self(DrawList& list, const Replica& replica, double tick, const LocalUser& self,
                           const ViewSettings& settings, std::uint64_t& next_mesh_id) {
  const Vec3 color = color_of(replica, self.participant);
  const auto physical = self.at_desk ? replica.user(self.participant, tick) : std::nullopt;
  const HandPose& target = self.input.hands[right_hand];
  const std::optional<Pose> head = self.input.head_tracked ? std::optional(self.input.head) : std::nullopt;
  const bool own_eyes = head && !settings.eye && settings.follow.empty();
  if (settings.through() != nullptr && !self.at_desk) {
    const std::size_t hands = list.items.size();
    add_hands(list, self.participant, self.input.hands, color, next_mesh_id);
    for (std::size_t k = hands; k < list.items.size(); ++k) mark_as_real(list.items[k]);
    return;
  }
  const bool is_physical = physical && physical->hands[right_hand].tracked;
  const std::array<HandPose, 2>& hands = is_physical ? physical->hands : self.input.hands;
  const auto indices = [&](std::size_t from) {
    std::vector<std::size_t> out;
    for (std::size_t k = from; k < list.items.size(); ++k) out.push_back(k);
    return out;
  };
  const std::size_t first_hand = list.items.size();
  add_hands(list, self.participant, hands, color, next_mesh_id);
  own_hands_ = indices(first_hand);
  const std::size_t first_sleeve = list.items.size();
  add_forearms(list, hands, head, color, own_eyes || self.at_desk ? own_sleeve_opacity : 1);
  own_sleeves_ = indices(first_sleeve);
  if (is_physical && (hands[right_hand].pose.p - target.pose.p).norm() > ghost_from) {
    add_ghost(list, target, color, next_mesh_id);
    own_hands_.push_back(list.items.size() - 1);
  }
}

void UserAvatars::add_ghost(DrawList& list, const HandPose& hand, const Vec3& color,
                            std::uint64_t& next_mesh_id) {
  const HandSkin& skin = shapes_->skins[right_hand];
  if (!ghost_) ghost_ = make_hand_mesh(skin, next_mesh_id++);
  bend_hand(skin, *ghost_, hand.flexion);
  list.items.push_back({.mesh = ghost_,
                        .pose = hand.pose,
                        .appearance = glove(color),
                        .casts_shadow = false,
                        .opacity = ghost_opacity});
}

void UserAvatars::add_hands(DrawList& list, ParticipantId who, const std::array<HandPose, 2>& hands,
                            const Vec3& color, std::uint64_t& next_mesh_id) {
  for (const std::size_t hand : {left_hand, right_hand}) {
    if (!hands[hand].tracked) continue;
    const HandSkin& skin = shapes_->skins[hand];
    HandMeshes& meshes = hands_[{who, hand}];
    if (!meshes.skin) {
      meshes.skin = make_hand_mesh(skin, next_mesh_id++);
      meshes.nails = make_nails(hand, next_mesh_id++);
    }
    bend_hand(skin, *meshes.skin, hands[hand].flexion);
    bend_nails(hand, hands[hand].flexion, *meshes.nails);
    const Pose& wrist = hands[hand].pose;
    list.items.push_back({.mesh = meshes.skin, .pose = wrist, .appearance = glove(color)});
    list.items.push_back({.mesh = meshes.nails, .pose = wrist, .appearance = nail_look(glove(color))});
  }
}

}  // namespace prosector
