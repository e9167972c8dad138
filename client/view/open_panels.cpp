#include "client/view/open_panels.h"

#include "client/view/shown_effort.h"

namespace prosector {

void OpenPanels::add(DrawList& list, const Replica& replica, ParticipantId self, const PanelLook& look,
                     std::uint64_t& next_mesh_id) {
  hidden_lines_ = 0;
  for (const auto& [who, panel] : replica.panels()) {
    if (panel.body >= replica.scene()->bodies.size()) continue;
    if (!view_) {
      view_.emplace(next_mesh_id);
      next_mesh_id += PanelView::meshes;
    }
    const SceneBody& part = replica.scene()->bodies[panel.body];
    Panel seen = panel;
    if (who == self) {
      hidden_lines_ = view_->hidden_lines(part);
      seen.pose = look.place.value_or(panel.pose);
    }
    view_->add(list, seen, part, shown_effort(replica, panel.body, self), who == self ? look.first_line : 0);
  }
}

}  // namespace prosector
