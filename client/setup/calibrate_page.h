#pragma once
// The page of calibrations: what to calibrate, step by step, and what came out.

#include <memory>
#include <string>
#include <vector>

#include "client/setup/config_draft.h"
#include "client/setup/guided_calibration.h"
#include "client/setup/interface.h"
#include "client/setup/words.h"

namespace prosector {

class CalibratePage {
 public:
  void draw(Interface& ui, ConfigDraft& draft);
  /// Lets the device go.
  void close() { running_.reset(); }
  bool running() const { return running_ != nullptr; }
  const Said& said() const { return said_; }

 private:
  CalibrationWishes wishes_ = {
      .points = {{0, 0.9, 0}, {0.4, 0.9, 0}, {0, 0.9, 0.4}, {0.4, 0.9, 0.4}},
      .grid = {.low = {-0.4, 0.9, -0.4}, .high = {0.4, 1.5, 0.4}, .orientation = {}}};
  std::size_t chosen_ = 0;
  std::unique_ptr<GuidedCalibration> running_;
  std::vector<std::string> outcome_;  // of the last one
  Said said_;

  void draw_choice(Interface& ui);
  void draw_wishes(Interface& ui, ConfigDraft& draft);
  void draw_running(Interface& ui, ConfigDraft& draft);
  void begin(const ConfigDraft& draft);
  void finish(ConfigDraft& draft);
};

}  // namespace prosector
