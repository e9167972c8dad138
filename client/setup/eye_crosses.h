#pragma once
// Crosses that a person lays over a mark in the room with each eye alone, in the display that is worn. Where
// the eyes are in it, and what they see, follows (SPAAM).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/setup/guided_calibration.h"
#include "client/setup/interface.h"
#include "client/setup/words.h"
#include "drivers/fitting/eyes_guide.h"

namespace prosector {

/// A display with two pictures side by side.
struct EyeDisplay {
  std::string name;
  int width = 800, height = 600;  // pixels, each eye
  bool swapped = false;           // the left eye's picture is on the right
};

class EyeCrosses {
 public:
  explicit EyeCrosses(std::vector<EyeDisplay> displays) : displays_(std::move(displays)) {}

  /// Shows what must be said before, and begins.
  void draw_wishes(Interface& ui, const ClientConfig& config, Said& said);
  /// Shows the present cross over the whole picture. Returns what came out once all are done.
  std::optional<GuideOutcome> draw_cross(Interface& ui, Said& said);
  bool running() const { return running_ != nullptr; }
  /// Lets the device go.
  void close() { running_.reset(); }

 private:
  std::vector<EyeDisplay> displays_;
  std::size_t display_ = 0;
  Vec3 mark_ = {0, 1.2, -1};  // m, room
  std::size_t crosses_ = 16;  // of each eye
  std::unique_ptr<GuidedCalibration> running_;
  EyesGuide* guide_ = nullptr;  // of `running_`
  bool begun_ = false;          // since the last picture

  void begin(const ClientConfig& config, Said& said);
  void draw_words(Interface& ui, const GuideStep& step, float left, float width, bool above, Said& said);
  std::string residuals(const Interface& ui) const;
};

}  // namespace prosector
