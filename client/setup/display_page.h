#pragma once
// The page of display settings: window, full screen or stereo; quality; and eye distances.

#include <optional>
#include <string>
#include <vector>

#include "client/setup/config_draft.h"
#include "client/setup/eye_crosses.h"
#include "client/setup/eye_ruler.h"
#include "client/setup/interface.h"
#include "client/setup/setup_session.h"

namespace prosector {

class PicturesPage {
 public:
  /// Creates the page. `displays` are the side-by-side stereo displays among which the user can choose.
  explicit PicturesPage(std::vector<EyeDisplay> displays);

  void draw(Interface& ui, SetupSession& room, ConfigDraft& draft);
  /// Stops a running calibration of the eyes, and closes its device.
  void close() { crosses_.close(); }
  bool running() const { return crosses_.running(); }
  const Said& said() const { return said_; }

 private:
  std::vector<std::string> profiles_;
  bool by_crosses_ = false;
  EyeRuler ruler_;
  EyeCrossCalibration crosses_;
  std::vector<std::string> outcome_;  // of the last measurement
  Said said_;

  void draw_seen(Interface& ui, DisplaySettings& seen);
  void draw_eyes(Interface& ui, ConfigDraft& draft);
  void measure(Interface& ui, ConfigDraft& draft);
  void draw_outcome(Interface& ui);
};

}  // namespace prosector
