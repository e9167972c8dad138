#pragma once
// Avatars of users: hands in their colours, and heads with names.

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

class UserAvatars {
 public:
  /// Adds hands, sleeves and heads of all users at the state that the server reports.
  ///
  /// The local user's hands come from the local devices instead, which have less latency and match the
  /// haptics. A desk user (with a pointer instead of tracked hands) feels nothing and is drawn at the
  /// server's state, too. The head of a user whose view is followed is omitted. Over a camera image, the
  /// local user's hands are real and only occlude. Sleeves of the user whose eyes the view uses are half
  /// transparent, because they would hide the workspace.
  ///
  /// Takes the ids of new meshes from `next_mesh_id`. Adds nobody until background threads have computed the
  /// shapes.
  void add(DrawList& list, const Replica& replica, double tick, const LocalUser& self,
           const ViewSettings& settings, std::uint64_t& next_mesh_id);
  /// Returns the indices, in the draw list, of the items of the local user's hands with nails; own_sleeves()
  /// returns those of the sleeves.
  const std::vector<std::size_t>& own_hand_items() const { return own_hands_; }
  const std::vector<std::size_t>& own_sleeves() const { return own_sleeves_; }

 private:
  struct HandMeshes {
    std::shared_ptr<DrawMesh> skin, nails;
  };
  std::map<std::pair<ParticipantId, std::size_t>, HandMeshes> hands_;
  std::shared_ptr<DrawMesh> ghost_;
  /// Shapes of hands and figures, which all avatars share.
  struct Shapes {
    std::array<HandSkin, 2> skins;
    FigureMeshes figure;
  };
  // Made on separate threads from the start, so that no frame waits when the first user joins.
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
