#pragma once
// A way of looking at the session: the source of the cameras, the frame rhythm, and the place where frames
// are shown. A client with a display has exactly one.

#include <optional>
#include <string>
#include <vector>

#include "client/app/output/picture_log.h"
#include "client/app/run/viewer_context.h"
#include "client/app/terminal/controls.h"
#include "client/app/user/input_pump.h"
#include "client/render/gl_context.h"
#include "client/render/renderer.h"
#include "client/view/outlook.h"
#include "client/view/view_settings.h"

namespace prosector {

/// Text and progress that are shown while the session's data are incomplete.
struct LoadingState {
  std::string waits_for;  // missing data
  double progress = 0;    // 0 … 1
};

class ViewMode {
 public:
  explicit ViewMode(ViewerContext& client) : client_(client) {}
  ViewMode(const ViewMode&) = delete;
  ViewMode& operator=(const ViewMode&) = delete;
  virtual ~ViewMode() = default;

  /// Returns the OpenGL context in which the frames of this view mode are rendered.
  virtual GlContext& context() = 0;
  /// Returns whether the user has ended the session in the window or in the headset's menu.
  virtual bool closed() const { return false; }
  /// Returns whether each frame is shown to a user. If false, only frames that are stored in files need to be
  /// rendered.
  virtual bool is_watched() const = 0;

  /// Waits for the time of the next frame, if a headset or camera determines it. Returns whether a frame may
  /// be rendered.
  virtual bool begin_frame() { return true; }
  /// Returns whether the last begin_frame() waited for a headset or camera. If false, the caller must limit
  /// the frame rate.
  virtual bool keeps_time() const { return false; }
  /// Waits for the user's inputs that belong to the frame, such as hand poses in the same camera image. The
  /// argument sends the user's inputs; null for observers.
  virtual void wait_for_inputs(const InputPump* /*pump*/) {}
  /// Returns the outlook of the next frame: its projection and display options. Processes the window's
  /// events. Moves the user's own hands in `self` to their poses at the display time. `usual`: outlook by the
  /// client's command-line options; `pump` sends the user's inputs, null for observers.
  virtual Outlook look(InputPump* pump, LocalUser& self, const Outlook& usual) = 0;
  /// Renders a frame of the list, whose size in pixels is that of the outlook.
  virtual void render(Renderer& renderer, const DrawList& list, const Outlook& /*outlook*/) {
    renderer.draw(list);
  }
  /// Shows the rendered frame on displays to which the renderer does not copy it, such as a headset, and logs
  /// its times.
  virtual void show(Renderer& /*renderer*/, const FrameTimes& /*times*/) {}
  /// Shows the progress of loading the session's data, if a user would see it.
  virtual void show_loading(Renderer& /*renderer*/, const LoadingState& /*state*/) {}

  /// Returns the devices with which the user controls the view, for the help; empty if the view has no
  /// controls.
  virtual std::vector<ControlDevice> controls() const { return {}; }
  /// Returns the body under the mouse pointer; nullopt if there is none.
  virtual std::optional<BodyId> pointed() const { return std::nullopt; }
  /// Returns the room pose of the user's eye if no tracker reports it, as in a window; nullopt if it is
  /// unknown.
  virtual std::optional<Pose> eye() const;
  /// Returns the size of the screenshot that the user requested since the last call, as a multiple of the
  /// frame's size; 0 if none was requested.
  virtual int take_picture_request() { return 0; }
  /// Adds the measurements of this view mode, such as a headset's frame timing, to the report.
  virtual void report(ClientReport& /*report*/) const {}
  /// Returns the number of pixels per point, the unit of texts and overlays: that of the client's option,
  /// else the display's.
  double scale() const { return client_.options.display.scale.value_or(display_scale()); }

 protected:
  ViewerContext& client_;

  /// Returns the display's default number of pixels per point, for instance from the desktop's settings.
  virtual double display_scale() const { return 1; }
};

}  // namespace prosector
