#pragma once
// Makes the DrawList, all that a user sees, from the replica, the user's own hands and the camera. Without
// any GL.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/replica/replica.h"
#include "client/replica/stroke_figures.h"
#include "client/view/body_wireframes.h"
#include "client/view/cut_lines.h"
#include "client/view/draw_list.h"
#include "client/view/drawn_bodies.h"
#include "client/view/level_of_detail.h"
#include "client/view/open_panels.h"
#include "client/view/own_hand_view.h"
#include "client/view/part_labels.h"
#include "client/view/parts_board_view.h"
#include "client/view/pick.h"
#include "client/view/real_objects.h"
#include "client/view/section.h"
#include "client/view/soft_body_mesh.h"
#include "client/view/user_avatars.h"
#include "client/view/value_painter.h"
#include "client/view/view_settings.h"

namespace prosector {

class SceneView {
 public:
  /// Rebuilds the draw list of everything that the user sees at the replica's `tick`, and returns it. Meshes
  /// of deformed bodies are updated only if the bodies moved. The list is valid until the next call.
  const DrawList& build(Replica& replica, double tick, const LocalUser& self, const ViewSettings& settings);

  /// Returns the anatomical part that the ray meets first, as drawn by the last build(); nullopt: none.
  std::optional<BodyId> part_at(const Ray& ray) { return bodies_.part_at(list_, ray); }
  /// Returns the point at which the ray first meets a body as drawn by the last build(), ignoring the bodies
  /// of `without`; nullopt if it meets none.
  std::optional<Picked> surface_at(const Ray& ray, const std::vector<BodyId>& without = {}) {
    return bodies_.surface_at(list_, ray, without);
  }
  /// Returns the number of lines of the part's description that do not fit on the panel of the local user,
  /// and must be scrolled.
  std::size_t hidden_panel_lines() const { return panels_.hidden_lines(); }
  /// Returns the bounding box of a body as drawn by the last build(), m, world frame; an empty box if the
  /// body is not drawn.
  Eigen::AlignedBox3d box_of(BodyId body) const { return bodies_.box_of(list_, body); }

 private:
  std::map<BodyId, std::shared_ptr<DrawMesh>> meshes_;  // of rigid bodies
  std::map<BodyId, SoftBodyMesh> soft_meshes_;
  ValuePainter value_painter_;
  UserAvatars people_;
  std::vector<DrawItem> room_;
  RealObjects real_objects_;
  std::shared_ptr<const DrawMesh> shaft_;
  OwnHandView own_hand_;
  CutLines cut_lines_;
  StrokeTracker strokes_;
  OpenPanels panels_;
  std::optional<PartsBoardView> parts_board_;  // nullopt: not shown yet
  BodyWireframes wireframes_;
  DrawnBodies bodies_;
  SectionCaps section_caps_;
  LevelOfDetail level_of_detail_;
  PartLabels part_labels_;
  std::uint64_t next_mesh_id_ = 1;
  DrawList list_;

  void place_cameras(const Replica& replica, double tick, const LocalUser& self,
                     const ViewSettings& settings);
  void add_insets(const Replica& replica, double tick, const ViewSettings& settings);
  void add_room(ItemRole showing);
  void place_lights(const Replica& replica, double tick);
  void add_bodies(Replica& replica, double tick, const ViewSettings& settings);
  void close_section();
  SoftBodyMesh& follow_soft(SoftReplica& soft, BodyId body, double tube_diameter, double tick, double dt);
  void add_stroke_figures(const Replica& replica, const LocalUser& self, double tick,
                          const ViewSettings& settings);
  void add_light_shaft(const DrawItem& item);
  void add_body_figures(const Replica& replica);
  void add_part_labels(const Replica& replica, const ViewSettings& settings);
};

}  // namespace prosector
