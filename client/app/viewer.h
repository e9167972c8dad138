#pragma once
// What this client's user sees: from where, through whose eyes, how well, and what becomes of the pictures.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/app/client_report.h"
#include "client/app/connection.h"
#include "client/app/console.h"
#include "client/app/controls.h"
#include "client/app/figures.h"
#include "client/app/input_pump.h"
#include "client/app/panel_finger.h"
#include "client/app/parts_board.h"
#include "client/app/picture_log.h"
#include "client/app/picture_sink.h"
#include "client/app/stage.h"
#include "client/app/touch_rumble.h"
#include "client/ar/camera_view.h"
#include "client/render/quality_governor.h"
#include "client/view/message_lines.h"
#include "common/clock.h"

namespace prosector {

class Viewer {
 public:
  /// Takes what outlives the viewer. `headset_user` learns where a headset's user is, `tell` prints a line
  /// for people at the terminal. `camera` is what is looked through, or sees the eyes; null: none.
  Viewer(const ClientOptions& options, Connection& connection, ClientReport& report,
         HeadsetUser& headset_user, const std::shared_ptr<SharedCamera>& camera,
         std::function<void(const std::string&)> tell);

  /// Tells whether pictures are drawn; false: --display none.
  bool draws() const { return stage_ != nullptr; }
  bool has_desk() const { return stage_ && stage_->desk; }
  bool closed() const {
    return (has_desk() && stage_->desk->closed()) || (has_headset() && stage_->headset->closed());
  }
  /// Tells whether the last picture was drawn in the rhythm of a headset or a camera, which was waited for.
  bool keeps_time() const { return waited_for_camera_ || (has_headset() && stage_->headset->keeps_time()); }

  /// Returns the help for that role with the devices that this client has.
  std::string help(Role role, HelpColumns columns) const;
  /// Returns what to tell first to who has that role and the devices that this client has.
  std::vector<std::string> greeting(Role role) const;
  /// Names what the pointer is at, and who holds it, as the picture does; "nothing" where that is so.
  std::string pointed() const;

  /// Sets from where pictures that no desk turns are taken from now on; nullopt: as the scene has it.
  void look_from(const std::optional<LookFrom>& place) { looks_from_ = place; }
  /// Shows the line in pictures for a while.
  void say(const std::string& line, MessageKind kind) {
    messages_.say(line, seconds_since(report_.joined_ns), kind);
  }
  /// Shows in the window, if there is one, what is waited for, and how much of it is here (0 … 1).
  void draw_loading(const std::string& waits_for, double progress);
  /// Asks for the next picture in `file`.
  void take_picture(const std::filesystem::path& file);
  /// Returns the part of the anatomy that the ray meets first in the last picture.
  std::optional<BodyId> part_at(const Ray& ray);

  /// Changes what the user sees of the parts.
  void obey(const PartsOrder& order) { parts_.obey(order); }
  const PartsChoice& parts() const { return parts_; }
  /// Puts the list of parts up on a board beside a user with tracked hands, one of which asked; or takes it
  /// away.
  void call_parts(const HandInput& user, std::size_t hand);

  /// Draws the next picture where somebody sees or keeps it. `pump` carries the user's hands; null: an
  /// observer, who has none.
  void draw_if_seen(InputPump* pump);
  /// Draws the last picture, and keeps all that waits for it.
  void finish(InputPump* pump);
  /// Tells whether a picture that was asked for could not be kept.
  bool lost_pictures() const { return sink_.failed(); }
  void reload_changed_shaders();
  void tell_failures();

 private:
  const ClientOptions& options_;
  Connection& connection_;
  ClientReport& report_;
  std::function<void(const std::string&)> tell_;
  PictureSink sink_;
  std::unique_ptr<Stage> stage_;
  std::optional<QualityGovernor> governor_;  // of pictures; nullopt: their quality stays
  std::optional<HeadsetFrame> seen_;         // what a headset asked for last; nullopt: none did
  std::optional<SeeThrough> through_;        // what a camera saw last; nullopt: none is looked through
  std::optional<WindowLook> look_;           // through the screen; nullopt: it is no window
  bool waited_for_camera_ = false;
  std::int64_t due_ns_ = 0;        // when the next picture through the camera is to be drawn
  std::optional<PictureLog> log_;  // of pictures through the camera; nullopt: nobody asked for it
  PictureTimes times_;             // of the picture that is being drawn
  std::optional<LookFrom> looks_from_;
  std::string follow_;  // whose eyes to look through; empty: own
  bool full_screen_ = false;
  Figures figures_;
  MessageLines messages_;
  PartsChoice parts_;
  PanelFinger panel_finger_;
  TouchRumble rumble_;
  PartsBoard parts_board_;

  /// Tells people at the terminal and in the picture.
  void inform(const std::string& line) {
    tell_(line);
    say(line, MessageKind::news);
  }
  bool has_headset() const { return stage_ && stage_->headset; }
  void draw_through_camera(InputPump* pump);
  bool comes_too_soon();
  void look_through_camera(const SightPicture* picture);
  void wait_for_hands(const InputPump& pump, std::int64_t time_ns) const;
  bool begin_headset_frame();
  void show_in_headset();
  void draw_in_headset(InputPump* pump);
  void draw_loading_in_headset(const std::string& waits_for, double progress);
  void look_through_headset(LocalUser& self, ViewSettings& settings) const;
  void follow_eyes();
  DrawCamera window_without_desk() const;
  Image draw(InputPump* pump, bool keep);
  double touch_force(ParticipantId self);
  void use_desk(InputPump* pump, LocalUser& self, ViewSettings& settings);
  void drive_hand_at_desk(InputPump& pump, LocalUser& self, bool has_panel);
  void ask_for_time();
  void read_panel(const Replica& replica, const LocalUser& self, ViewSettings& settings);
  void work_parts_board(const Replica& replica, const LocalUser& self, ViewSettings& settings);
  void watch_time(const Replica& replica, double tick, ViewSettings& settings) const;
  double scale() const;
  Role role_of(ParticipantId participant);
  void follow_next(ParticipantId self);
  void note_picture(double seconds);
  std::vector<ControlDevice> devices() const;
  void keep_picture(int times, const LocalUser& self, ViewSettings settings);
  const DrawList& build_list(const LocalUser& self, ViewSettings& settings);
};

}  // namespace prosector
