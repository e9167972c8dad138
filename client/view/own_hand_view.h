#pragma once
// How the local user's own hands and all held blades are drawn beyond their shapes: depth cues, opacity,
// edges and predicted cut lines.

#include <cstdint>
#include <optional>

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/drawn_bodies.h"
#include "client/view/hand_cues.h"
#include "client/view/user_avatars.h"
#include "client/view/view_settings.h"

namespace prosector {

/// Depth cues and opacity of the local user's hand in a draw list.
class OwnHandView {
 public:
  /// Adds depth cues for a desk user's hand (a line down to the surface, and the contact force), because desk
  /// users have no haptics. Takes the ids of new meshes from `next_mesh_id`.
  void add_cues(DrawList& list, DrawnBodies& bodies, const UserAvatars& avatars, const Replica& replica,
                const LocalUser& self, double tick, std::uint64_t& next_mesh_id);
  /// Fades a desk user's own hand and sleeve while they cover bodies that can be worked on, and a hand that
  /// holds something. Also fades the user's own items before the near plane clips them.
  void update_opacity(DrawList& list, DrawnBodies& bodies, const UserAvatars& avatars, const Replica& replica,
                      const LocalUser& self, double tick);

 private:
  HandCues cues_;
  std::optional<double> opacity_;  // of a desk user's hand, 0: invisible; nullopt: not drawn yet
};

/// Adds the edges of held blades, and predicted cut lines. Omits the line of the local desk user, because the
/// pointer gives a better one.
void add_blades(DrawList& list, DrawnBodies& bodies, const Replica& replica, const LocalUser& self,
                double tick);

}  // namespace prosector
