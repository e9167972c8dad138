#pragma once
// Replica, own hand and camera → DrawList: everything that a person sees, without any GL.

#include <array>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/replica/replica.h"
#include "client/view/draw_list.h"
#include "client/view/hand_mesh.h"
#include "client/view/panel_view.h"
#include "client/view/pick.h"
#include "client/view/soft_body_mesh.h"
#include "client/view/stereo_profile.h"
#include "client/view/value_paint.h"
#include "client/view/wireframe.h"

namespace prosector {

struct ViewSettings {
  int width = 800, height = 600;        // pixels
  double scale = 1;                     // pixels of a point, in which overlays are measured
  std::optional<StereoProfile> stereo;  // nullopt: one picture
  bool overlay = true;
  bool wireframes = false;          // of what bodies collide as
  Shown shown = Shown::none;        // by soft bodies' colours
  std::string notes;                // lines below the session's; empty: none
  std::vector<std::string> insets;  // names of users whose views are seen small; not in stereo
  std::string follow;               // name of a participant; empty: own camera
  std::optional<Pose>
      eye;  // own camera, for instance from the desk; nullopt: tracked head, else the scene's camera
};

/// The person at this client, as their own devices have them right now.
struct LocalUser {
  ParticipantId participant = 0;
  HandInput input;
  bool present = false;  // false: an observer, who has no hands
};

class SceneView {
 public:
  /// Rebuilds the list for the replica's `tick`. Deformed surfaces are refreshed only when they moved.
  const DrawList& build(Replica& replica, double tick, const LocalUser& self, const ViewSettings& settings);

  /// The part of the anatomy that the ray meets first in the list built last.
  std::optional<BodyId> part_at(const Ray& ray) const;

 private:
  std::map<BodyId, std::shared_ptr<DrawMesh>> meshes_;  // of rigid bodies
  std::map<BodyId, SoftBodyMesh> soft_meshes_;
  std::map<std::uint64_t, PaintedMesh> painted_;  // by the id of the mesh that is painted
  std::map<std::pair<ParticipantId, std::size_t>, std::shared_ptr<DrawMesh>> hands_;
  // Made at once, on a thread of its own, so that no frame waits when the first hand comes.
  std::future<std::array<HandSkin, 2>> skins_to_come_ = std::async(std::launch::async, make_hand_skins);
  std::optional<std::array<HandSkin, 2>> skins_;
  std::vector<DrawItem> room_;
  std::shared_ptr<const DrawMesh> head_, shaft_;
  std::optional<PanelView> panel_view_;
  std::map<BodyId, Edges> wires_;
  std::map<BodyId, std::uint64_t> wire_shapes_;             // SoftReplica::shape() that wires_ are of
  std::vector<std::pair<BodyId, std::size_t>> part_items_;  // of list_.items, the bodies' that are parts
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
  void add_users(const Replica& replica, double tick, const LocalUser& self, const std::string& seen_through);
  void add_hand(ParticipantId who, std::size_t hand, const HandPose& pose, const Vec3& color);
  void add_figures(const Replica& replica);
  void add_overlay(const Replica& replica, const LocalUser& self, const ViewSettings& settings);
  void add_contact(const Replica& replica, ParticipantId who);
};

}  // namespace prosector
