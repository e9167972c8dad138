#pragma once
// Users as they are seen: hands in their colours, and heads with names.

#include <array>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/replica/replica.h"
#include "client/view/avatar.h"
#include "client/view/draw_list.h"
#include "client/view/hand_mesh.h"
#include "client/view/view_settings.h"

namespace prosector {

class People {
 public:
  /// Adds everyone as the server has them. Oneself is as one's own devices have one, which is faster and
  /// where one feels it. Whoever sits at a desk feels nothing, and is as the server has them, too. Whoever is
  /// followed has no head. Through a camera, one's own hands are real. Sleeves of whoever's eyes see are half
  /// transparent, as they come from the eye and hide what the hand works at. Meshes get ids from
  /// `next_mesh_id` on. Nobody is added before the shapes of hands, sleeves and heads are all made.
  void add(DrawList& list, const Replica& replica, double tick, const LocalUser& self,
           const ViewSettings& settings, std::uint64_t& next_mesh_id);
  /// Returns which of the list's items are one's own hands with their nails, and one's sleeves.
  const std::vector<std::size_t>& own_hands() const { return own_hands_; }
  const std::vector<std::size_t>& own_sleeves() const { return own_sleeves_; }

 private:
  struct HandMeshes {
    std::shared_ptr<DrawMesh> skin, nails;
  };
  std::map<std::pair<ParticipantId, std::size_t>, HandMeshes> hands_;
  std::shared_ptr<DrawMesh> ghost_;
  /// What all people are made of.
  struct Shapes {
    std::array<HandSkin, 2> skins;
    FigureMeshes figure;
  };
  // Made at once, on threads of their own, so that no frame waits when the first person comes.
  std::future<std::array<HandSkin, 2>> skins_to_come_ = std::async(std::launch::async, make_hand_skins);
  std::future<FigureSurfaces> figure_to_come_ = std::async(std::launch::async, make_figure_surfaces);
  std::optional<Shapes> shapes_;
  std::vector<std::size_t> own_hands_, own_sleeves_;

  void take_shapes(std::uint64_t& next_mesh_id);
  void add_figure(DrawList& list, const UserState& user, const RosterEntry& entry, bool is_seen_through);
  void add_forearms(DrawList& list, const std::array<HandPose, 2>& hands, const std::optional<Pose>& head,
                    const Vec3& color, double opacity) const;
  void add_self(DrawList& list, const Replica& replica, double tick, const LocalUser& self,
                const ViewSettings& settings, std::uint64_t& next_mesh_id);
  void add_ghost(DrawList& list, const HandPose& hand, const Vec3& color, std::uint64_t& next_mesh_id);
  void add_hands(DrawList& list, ParticipantId who, const std::array<HandPose, 2>& hands, const Vec3& color,
                 std::uint64_t& next_mesh_id);
};

}  // namespace prosector
