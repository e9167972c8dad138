#pragma once
// Colours that show a quantity on the soft bodies of a draw list.

#include <cstdint>
#include <map>
#include <vector>

#include "client/replica/replica.h"
#include "client/view/auto_range.h"
#include "client/view/draw_list.h"
#include "client/view/drawn_bodies.h"
#include "client/view/value_paint.h"
#include "common/status_messages.h"

namespace prosector {

/// Colours all soft bodies of a draw list by one scale. Caches the coloured copies of their meshes.
class ValuePainter {
 public:
  /// Colours the soft bodies of the list by the quantity `shown`, which is not Shown::none. Takes the ids of
  /// new meshes from `next_mesh_id`. Returns the colour scale, for the legend. The upper limit of the
  /// strain's scale adapts to the strains of all soft bodies.
  ValueScale paint(DrawList& list, const DrawnBodies& bodies, const Replica& replica, Shown shown,
                   std::uint64_t& next_mesh_id);

 private:
  std::map<std::uint64_t, PaintedMesh> painted_;  // by the source mesh's id
  AutoRange strain_range_{0.01};

  double strain_limit(const DrawList& list, const std::vector<DrawnBodies::Item>& items,
                      std::uint64_t& next_mesh_id);
  void paint(DrawItem& item, const ValueScale& scale, Shown shown, const BodyStatus* status,
             std::uint64_t& next_mesh_id);
  PaintedMesh& painted_of(const DrawMesh& mesh, std::uint64_t& next_mesh_id);
};

}  // namespace prosector
