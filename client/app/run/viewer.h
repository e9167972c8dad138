#pragma once
// Rendering of a client: frames, their quality and storage. The view mode determines how the scene is seen.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/desk/panel_finger.h"
#include "client/app/desk/parts_board.h"
#include "client/app/run/frame_output.h"
#include "client/app/run/stage.h"
#include "client/app/terminal/controls.h"
#include "client/app/user/input_pump.h"
#include "client/render/quality_governor.h"

namespace prosector {

class Viewer {
 public:
  /// Creates the viewer; the arguments must outlive it. `headset_user` receives a headset user's poses;
  /// `tell` prints a line in the terminal. `camera`: for augmented reality or eye tracking; null: none.
  Viewer(const ClientOptions& options, Connection& connection, ClientReport& report,
         HeadsetUser& headset_user, const std::shared_ptr<SharedCamera>& camera,
         std::function<void(const std::string&)> tell);

  bool closed() const { return stage_ && stage_->mode->closed(); }
  /// Reports whether the last frame was paced by the view mode, which waited for a headset or a camera.
  bool keeps_time() const { return stage_ && stage_->mode->keeps_time(); }

  /// Returns the help for a role with the devices of this client; empty without a window.
  std::string help(Role role, HelpColumns columns) const;
  /// Returns the first hints for a role with the devices of this client; empty without a window.
  std::vector<std::string> greeting(Role role) const;
  /// Returns the name of the body under the pointer and its holders, as the frame labels it; "nothing" if
  /// there is none.
  std::string pointed() const;

  /// Sets the camera pose of frames without a desk; nullopt: the scene's camera.
  void look_from(const std::optional<LookFrom>& place) { client_.looks_from = place; }
  /// Shows a line in the frames for a while.
  void say(const std::string& line, MessageKind kind) { client_.say(line, kind); }
  /// Shows in the window or headset, if any, what data is missing and how much has arrived (0 … 1).
  void draw_loading(const std::string& waits_for, double progress);
  /// Requests a screenshot of the next frame in `file`.
  void take_picture(const std::filesystem::path& file);
  /// Returns the first part of the anatomy that a ray hits in the last frame.
  std::optional<BodyId> part_at(const Ray& ray);

  /// Changes the display of parts.
  void obey(const PartsOrder& order) { client_.parts.obey(order); }
  const PartsChoice& parts() const { return client_.parts; }
  /// Opens or closes the board with the list of parts next to a user with tracked hands; `hand`: the hand
  /// that asked.
  void call_parts(const HandInput& user, std::size_t hand);

  /// Renders the next frame if it is displayed or stored. `pump` carries the user's hands; null for
  /// observers.
  void draw_if_seen(InputPump* pump);
  /// Renders the last frame if a screenshot waits for it, and writes all pending output.
  void finish(InputPump* pump);
  /// Reports whether a requested image could not be written.
  bool lost_pictures() const { return sink_.failed(); }
  void reload_changed_shaders();
  void tell_failures();

 private:
  ViewerContext client_;
  ClientReport& report_;
  FrameOutput sink_;
  std::unique_ptr<Stage> stage_;             // null with --display none
  std::optional<QualityGovernor> governor_;  // automatic quality; nullopt: fixed quality
  FrameTimes times_;                         // of the current frame
  PanelFinger panel_finger_;
  PartsBoard parts_board_;

  Image draw(InputPump* pump, bool keep);
  Outlook usual_outlook() const;
  ViewSettings view_settings(InputPump* pump, LocalUser& self);
  const DrawList& build_list(const LocalUser& self, ViewSettings& settings);
  void read_panel(const Replica& replica, const LocalUser& self, ViewSettings& settings);
  void work_parts_board(const Replica& replica, const LocalUser& self, ViewSettings& settings);
  void show_playback_time(const Replica& replica, double tick, ViewSettings& settings) const;
  void record_frame_time(double seconds);
  void keep_picture(int times, const LocalUser& self, ViewSettings settings);
};

}  // namespace prosector
