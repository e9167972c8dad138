#pragma once
// Replica, own hand and camera → DrawList: everything that a person sees, without any GL.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/level_of_detail.h"
#include "client/view/panel_view.h"
#include "client/view/people.h"
#include "client/view/pick.h"
#include "client/view/soft_body_mesh.h"
#include "client/view/value_paint.h"
#include "client/view/view_settings.h"
#include "client/view/wireframe.h"

namespace prosector {

class SceneView {
 public:
  /// Rebuilds the list for the replica's `tick`. Deformed surfaces are refreshed only when they moved.
  const DrawList& build(Replica& replica, double tick, const LocalUser& self, const ViewSettings& settings);

  /// Returns the part of the anatomy that the ray meets first in the list built last.
  std::optional<BodyId> part_at(const Ray& ray) const;

 private:
  std::map<BodyId, std::shared_ptr<DrawMesh>> meshes_;  // of rigid bodies
  std::map<BodyId, SoftBodyMesh> soft_meshes_;
  std::map<std::uint64_t, PaintedMesh> painted_;  // by the id of the mesh that is painted
  People people_;
  std::vector<DrawItem> room_;
  std::shared_ptr<const DrawMesh> shaft_;
  std::optional<PanelView> panel_view_;
  std::map<BodyId, Edges> wires_;
  std::map<BodyId, std::uint64_t> wire_shapes_;             // SoftReplica::shape() that wires_ are of
  std::vector<std::pair<BodyId, std::size_t>> part_items_;  // of list_.items, the bodies' that are parts
  LevelOfDetail level_of_detail_;
  std::uint64_t next_mesh_id_ = 1;
  DrawList list_;

  void place_cameras(const Replica& replica, double tick, const LocalUser& self,
                     const ViewSettings& settings);
  void add_insets(const Replica& replica, double tick, const ViewSettings& settings);
  void add_room();
  void place_lights(const Replica& replica, double tick);
  void add_bodies(Replica& replica, double tick, Shown shown);
  void paint(DrawItem& item, Shown shown, const BodyStatus* status);
  SoftBodyMesh& follow_soft(SoftReplica& soft, BodyId body, double tube_diameter, double tick, double dt);
  void add_light_shaft(const DrawItem& item);
  void add_wireframes(Replica& replica, double tick);
  void add_panels(const Replica& replica);
  void add_body_figures(const Replica& replica);
};

}  // namespace prosector
