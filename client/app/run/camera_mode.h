#pragma once
// Augmented reality: the scene over a camera's images, in the camera's rhythm, on a desk's window or
// offscreen.

#include <memory>
#include <optional>

#include "client/app/output/picture_log.h"
#include "client/app/run/screen_mode.h"
#include "client/ar/camera_sight.h"
#include "client/view/see_through.h"

namespace prosector {

class CameraMode : public GuidedMode {
 public:
  /// Starts to detect boards of tags in the camera's images. The scene is drawn over these images, and shown
  /// by `screen`. Throws InputError if a file of the configuration, or the log of frame times, can't be
  /// opened.
  CameraMode(ViewerContext& client, std::unique_ptr<ScreenMode> screen,
             const std::shared_ptr<SharedCamera>& camera);

  /// Waits up to 100 ms for the camera's next image. Returns whether to render a frame with it; false for
  /// images that are skipped to respect --fps.
  bool begin_frame() override;
  bool keeps_time() const override { return waited_; }
  /// Waits for the hand poses that trackers detect in the same camera image, up to about 0.3 s. Does nothing
  /// without tracking devices.
  void wait_for_inputs(const InputPump* pump) override;
  Outlook look(InputPump* pump, LocalUser& self, const Outlook& usual) override;
  void show(Renderer& renderer, const FrameTimes& times) override;
  void show_loading(Renderer& renderer, const LoadingState& state) override;

 private:
  std::optional<FoundPhantom> phantom_;  // calibrated phantom; nullopt: none
  std::unique_ptr<CameraSight> sight_;
  std::optional<PictureLog> log_;  // nullopt: not requested
  std::shared_ptr<const UndistortedImage> image_;
  std::optional<CameraOverlay> overlay_;  // nullopt: no frame yet
  bool waited_ = false;
  std::int64_t due_ns_ = 0;  // when the next frame is due

  std::optional<ObjectBoard> take_phantom();
  bool should_skip_frame();
  void update_overlay();
  void wait_for_hands(const InputPump& pump, std::int64_t time_ns) const;
};

}  // namespace prosector
