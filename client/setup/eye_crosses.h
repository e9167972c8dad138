#pragma once
// Calibration of a worn display: the user aligns crosses with a mark in the room, with one eye at a time. The
// eyes' positions and frusta follow from it (SPAAM).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/setup/guided_calibration.h"
#include "client/setup/interface.h"
#include "client/setup/text_styles.h"
#include "drivers/fitting/eyes_guide.h"

namespace prosector {

/// Stereo display with the views of both eyes side by side, and the size of each view.
struct EyeDisplay {
  std::string name;
  int width = 800, height = 600;  // pixels, each eye
  bool swapped = false;           // the left eye's view is on the right
};

class EyeCrossCalibration {
 public:
  explicit EyeCrossCalibration(std::vector<EyeDisplay> displays) : displays_(std::move(displays)) {}

  /// Draws the form for calibrating a worn display by crosses that the user aligns with a mark in the room:
  /// the mark's position, display, number of crosses, start button. `said` receives error messages.
  void draw_settings_form(Interface& ui, const ClientConfig& config, Said& said);
  /// Draws the current cross, which the user aligns with a mark in the room, over the whole window. Returns
  /// the calibration's result once all crosses are done, until then nullopt. `said` receives messages.
  std::optional<GuideOutcome> draw_cross(Interface& ui, Said& said);
  bool running() const { return running_ != nullptr; }
  /// Stops a running calibration without a result, and closes the tracker.
  void close() { running_.reset(); }

 private:
  std::vector<EyeDisplay> displays_;
  std::size_t display_ = 0;
  Vec3 mark_ = {0, 1.2, -1};  // m, room
  std::size_t crosses_ = 16;  // per eye
  std::unique_ptr<GuidedCalibration> running_;
  EyesGuide* guide_ = nullptr;  // points into `running_`
  bool begun_ = false;          // started since the last frame

  void begin(const ClientConfig& config, Said& said);
  void draw_words(Interface& ui, const GuideStep& step, float left, float width, bool above, Said& said);
  std::string residuals(const Interface& ui) const;
};

}  // namespace prosector
