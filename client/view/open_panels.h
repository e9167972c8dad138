#pragma once
// The open panels of all users in a draw list.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/outlook.h"
#include "client/view/panel_view.h"
#include "common/ids.h"

namespace prosector {

class OpenPanels {
 public:
  /// Adds the open panels of all users to the list. `self`: the local user, whose panel has the pose and
  /// scroll position of `look`. Takes the ids of new meshes from `next_mesh_id`.
  void add(DrawList& list, const Replica& replica, ParticipantId self, const PanelLook& look,
           std::uint64_t& next_mesh_id);
  /// Returns the number of lines of the part's description that do not fit on the panel of the local user,
  /// and must be scrolled.
  std::size_t hidden_lines() const { return hidden_lines_; }

 private:
  std::optional<PanelView> view_;  // nullopt: no panel was shown yet
  std::size_t hidden_lines_ = 0;
};

}  // namespace prosector
