#pragma once
// Users as they are seen: hands in their colours, and heads with names.

#include <array>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/hand_mesh.h"
#include "client/view/view_settings.h"

namespace prosector {

class People {
 public:
  /// Adds everyone as the server has them, but oneself as one's own devices have one: that is faster, and is
  /// where one feels it. Whoever is named `seen_through` has no head. Meshes get ids from `next_mesh_id` on.
  void add(DrawList& list, const Replica& replica, double tick, const LocalUser& self,
           const std::string& seen_through, std::uint64_t& next_mesh_id);

 private:
  std::map<std::pair<ParticipantId, std::size_t>, std::shared_ptr<DrawMesh>> hands_;
  // Made at once, on a thread of its own, so that no frame waits when the first hand comes.
  std::future<std::array<HandSkin, 2>> skins_to_come_ = std::async(std::launch::async, make_hand_skins);
  std::optional<std::array<HandSkin, 2>> skins_;
  std::shared_ptr<const DrawMesh> head_;

  void add_hands(DrawList& list, ParticipantId who, const std::array<HandPose, 2>& hands, const Vec3& color,
                 std::uint64_t& next_mesh_id);
};

}  // namespace prosector
