#pragma once
// How a frame is seen: cameras, and what the viewer's mouse and keyboard show in it. A view mode returns it.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/view/draw_list.h"
#include "client/view/parts_list.h"
#include "client/view/see_through.h"
#include "client/view/stereo_profile.h"
#include "client/view/value_paint.h"
#include "common/ids.h"
#include "common/math.h"

namespace prosector {

/// Local changes of a viewer to their own panel, which other participants do not see: its pose while it is
/// dragged, and the scroll position.
struct PanelLook {
  std::optional<Pose> place = {};  // pose while it is dragged; nullopt: the shared pose
  std::size_t first_line = 0;      // first visible line of its description
};

/// Projection with a single camera at the viewer's eye.
struct Mono {};
/// Projection for a headset: the cameras of both eyes, side by side in the frame.
struct HeadsetEyes {
  std::array<DrawCamera, 2> cameras;
};
/// Projection for tracked eyes in front of a screen that acts as a window into the room (window_view.h).
struct WindowCamera {
  DrawCamera camera;
};
/// Projection of the scene into the frame. A StereoProfile means one view for each of the viewer's eyes, side
/// by side in the frame; a CameraOverlay, a view drawn over a camera's image.
using Projection = std::variant<Mono, StereoProfile, HeadsetEyes, WindowCamera, CameraOverlay>;

/// Flags for the overlays and surroundings that suit a kind of projection, such as a headset or a camera
/// image.
struct Overlays {
  bool insets = true;        // views of other users
  bool over_frame = true;    // texts over the whole frame; false: they are placed in the room
  bool virtual_room = true;  // the room; false: the camera's image surrounds the scene
};
Overlays overlays_of(const Projection& projection);

struct Outlook {
  int width = 800, height = 600;  // pixels
  double scale = 1;               // pixels per point; overlays are measured in points
  Projection projection = {};
  std::optional<Pose> eye = {};  // own eye, for instance of the desk; nullopt: tracked head, else the scene's
  std::string follow = {};       // participant whose view is shown; empty: own camera
  std::optional<SectionPlane> section = {};  // opens bodies
  PanelLook panel = {};
  bool wireframes = false;                            // of the collision shapes
  Shown shown = Shown::none;                          // quantity shown by soft bodies' colours
  std::string help = {};                              // columns separated by tabs; empty: none
  std::string notes = {};                             // lines below those of the session; empty: none
  std::optional<BodyId> pointed = {};                 // body to name at the pointer
  bool has_pointer = false;                           // a mouse or gamepad moves a pointer
  Eigen::Vector2d pointer = Eigen::Vector2d::Zero();  // pixels from the top left
  std::vector<BodyId> highlighted = {};               // bodies that are highlighted
  const PartsList* parts_list = nullptr;              // list of parts in the view; null: closed
  std::vector<Vec3> cut_guide = {};                   // m: line on tissue that the desk's blade would cut
  std::optional<double> cut_depth = {};               // m: cutting depth of the desk's blade
  std::optional<std::uint64_t> sought_tick = {};      // requested tick of a recording, not displayed yet

  /// Returns the camera image over which the scene is drawn; null if the projection is another one.
  const CameraOverlay* through() const { return std::get_if<CameraOverlay>(&projection); }
};

}  // namespace prosector
