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

/// Text and progress shown before the session's data are complete.
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

  /// Returns the context that renders the frames.
  virtual GlContext& context() = 0;
  /// Reports whether the user has ended the session in the window or headset.
  virtual bool closed() const { return false; }
  /// Reports whether each frame is shown to a user; false: only stored frames need to be rendered.
  virtual bool is_watched() const = 0;

  /// Waits for the next frame, if the mode has its own rhythm. Returns whether a frame may be rendered.
  virtual bool begin_frame() { return true; }
  /// Reports whether the last begin_frame() waited for the mode's own rhythm.
  virtual bool keeps_time() const { return false; }
  /// Waits for the inputs that belong to the frame; `pump` is null for observers.
  virtual void wait_for_inputs(const InputPump* /*pump*/) {}
  /// Returns how the frame is seen, and moves the user's own hands to where they are seen then. Processes the
  /// window's events. `usual`: outlook by the client's options.
  virtual Outlook look(InputPump* pump, LocalUser& self, const Outlook& usual) = 0;
  /// Renders a frame of the outlook's size.
  virtual void render(Renderer& renderer, const DrawList& list, const Outlook& /*outlook*/) {
    renderer.draw(list);
  }
  /// Shows the rendered frame where the context does not, and logs its times.
  virtual void show(Renderer& /*renderer*/, const FrameTimes& /*times*/) {}
  /// Shows the loading progress, if a user would see it.
  virtual void show_loading(Renderer& /*renderer*/, const LoadingState& /*state*/) {}

  /// Returns the devices with which the user controls the view; empty: the mode has no controls.
  virtual std::vector<ControlDevice> controls() const { return {}; }
  /// Returns the body under the pointer.
  virtual std::optional<BodyId> pointed() const { return std::nullopt; }
  /// Returns the eye of a user without a tracked head; nullopt: unknown.
  virtual std::optional<Pose> eye() const;
  /// Returns the scale of the screenshot requested since the last call, relative to the frame; 0: none.
  virtual int take_picture_request() { return 0; }
  /// Adds the mode's measurements.
  virtual void report(ClientReport& /*report*/) const {}
  /// Returns the number of pixels per point.
  double scale() const { return client_.options.scale.value_or(display_scale()); }

 protected:
  ViewerContext& client_;

  /// Returns the display's own number of pixels per point.
  virtual double display_scale() const { return 1; }
};

}  // namespace prosector
