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
  /// Creates the viewer, which renders the session's frames; the arguments must outlive it. `headset_user`
  /// receives a headset user's poses; `print_line` prints a line in the terminal. `camera`: for augmented
  /// reality or eye tracking; null: none.
  Viewer(const ClientOptions& options, Connection& connection, ClientReport& report,
         HeadsetUser& headset_user, const std::shared_ptr<SharedCamera>& camera,
         std::function<void(const std::string&)> print_line);

  bool closed() const { return stage_ && stage_->mode->closed(); }
  /// Returns whether the last draw_if_seen() waited for a headset or a camera. If false, the caller must
  /// limit the frame rate.
  bool keeps_time() const { return stage_ && stage_->mode->keeps_time(); }

  /// Returns the help text on all controls that a user with this role has with the client's devices; empty
  /// without a window.
  std::string help(Role role, HelpColumns columns) const;
  /// Returns the first hints on how to use the client, for a user with this role and the client's devices;
  /// empty without a window.
  std::vector<std::string> greeting(Role role) const;
  /// Returns the name of the body under the mouse pointer and the participants that hold it, as the frame
  /// labels it; "nothing" if there is none.
  std::string pointed() const;

  /// Sets the camera pose of frames that are rendered without a window; nullopt: the scene's camera.
  void look_from(const std::optional<LookFrom>& place) { client_.looks_from = place; }
  /// Shows a message line in the frames for its reading time.
  void say(const std::string& line, MessageKind kind) { client_.say(line, kind); }
  /// Shows in the window or headset, if any, which data of the session are missing and how much has arrived
  /// (0 … 1).
  void draw_loading(const std::string& waits_for, double progress);
  /// Requests that the next frame is stored as a screenshot in `file`.
  void take_picture(const std::filesystem::path& file);
  /// Returns the anatomical part that a ray (world frame) meets first in the last frame; nullopt if it meets
  /// none.
  std::optional<BodyId> part_at(const Ray& ray);

  /// Changes how this viewer sees anatomical parts, for instance hides one.
  void obey(const PartsOrder& order) { client_.parts.obey(order); }
  const PartsChoice& parts() const { return client_.parts; }
  /// Opens the board with the list of parts next to a user with tracked hands, or closes it. `hand`: the hand
  /// whose gesture requested it.
  void call_parts(const HandInput& user, std::size_t hand);

  /// Renders the next frame if it is shown to a user or stored in a file. `pump` sends the user's inputs and
  /// holds their latest hand poses; null for observers.
  void draw_if_seen(InputPump* pump);
  /// Renders the session's last frame if screenshots wait for it, and writes all pending files and error
  /// messages. `pump`: see draw_if_seen().
  void finish(InputPump* pump);
  /// Returns whether a requested screenshot, video or contact sheet could not be written.
  bool lost_pictures() const { return sink_.failed(); }
  void reload_changed_shaders();
  void print_failures();

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
