#pragma once
// Who looks at a session, and how.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"
#include "client/view/parts_board_view.h"
#include "client/view/parts_list.h"
#include "client/view/see_through.h"
#include "client/view/stereo_profile.h"
#include "client/view/time_bar.h"
#include "client/view/value_paint.h"
#include "common/messages.h"

namespace prosector {

/// What a viewer did to their own panel.
struct PanelLook {
  std::optional<Pose> place = {};  // where they drag it; nullopt: where everyone has it
  std::size_t first_line = 0;      // of its description that is seen
};

struct ViewSettings {
  Catalogue words = {};                                // language of what is laid over the picture
  int width = 800, height = 600;                       // pixels
  double scale = 1;                                    // pixels of a point, in which overlays are measured
  std::optional<StereoProfile> stereo;                 // nullopt: one picture
  std::optional<std::array<DrawCamera, 2>> eyes = {};  // as a headset has them; then `stereo` is not used
  std::optional<DrawCamera> window = {};               // own camera, where the screen is a window
  std::optional<SeeThrough> through = {};              // a camera's picture; then its camera is the eye
  double detail = 0;                                   // pixels, for LevelOfDetail::choose()
  bool overlay = true;
  std::optional<SectionPlane> section = {};  // that opens bodies
  PanelLook panel = {};
  bool wireframes = false;                            // of what bodies collide as
  Shown shown = Shown::none;                          // by soft bodies' colours
  std::string help;                                   // columns by tabs; empty: none
  std::string notes;                                  // lines below the session's; empty: none
  std::vector<std::string> messages = {};             // lines at the lower border, the oldest first
  std::optional<BodyId> pointed = {};                 // body to name beside the pointer
  Eigen::Vector2d pointer = Eigen::Vector2d::Zero();  // pixels from the top left
  PartsChoice parts = {};                             // what the viewer wants to see of them
  std::vector<BodyId> highlighted = {};               // bodies that are shown bright
  std::optional<PlacedPartsList> parts_board = {};    // the list of parts in the room
  const PartsList* parts_list = nullptr;              // to be drawn; null: shut
  std::vector<Vec3> cut_guide = {};                   // m: line on tissue that the desk's blade would cut
  std::optional<double> cut_depth = {};               // m that the desk's blade is set to
  std::optional<WatchedTime> time = {};               // of the recording that is watched
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
  /// Moves the hand with a pointer and feels nothing. So it is drawn where physics has it, with a ghost where
  /// it is wanted, and with cues of how far it is from things.
  bool at_desk = false;
};

}  // namespace prosector
