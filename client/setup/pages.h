#pragma once
// The set-up window's pages, and the message below them.

#include "client/setup/calibrate_page.h"
#include "client/setup/camera_page.h"
#include "client/setup/checks_page.h"
#include "client/setup/devices_page.h"
#include "client/setup/display_page.h"
#include "client/setup/enter_page.h"
#include "client/setup/glove_live.h"
#include "client/setup/interface.h"
#include "client/setup/setup_session.h"
#include "client/setup/tracker_range.h"
#include "client/setup/window_page.h"

namespace prosector {

class Pages {
 public:
  Pages(SetupSession& room, ConfigDraft& draft, std::function<MachineCheck()> measure_pictures,
        std::vector<EyeDisplay> displays)
      : room_(room), draft_(draft), pictures_(std::move(displays)), checks_(std::move(measure_pictures)) {}

  void draw(Interface& ui);
  const Said& said() const { return *said_; }
  /// Returns whether the open page must be redrawn without user input, because it shows live data of a device
  /// or a running calibration.
  bool lively() const {
    return devices_.open() || tracker_.running() || glove_.running() || camera_.running() ||
           window_.running() || pictures_.running();
  }
  /// Returns the monitor on which the set-up window must be full screen during a calibration of the eyes,
  /// counted from 0. Returns nullopt if it stays a window.
  std::optional<int> full_screen() const;

 private:
  SetupSession& room_;
  ConfigDraft& draft_;
  const Said* said_ = &room_.said();  // of the open page
  EnterPage enter_;
  DevicesPage devices_;
  CalibratePage tracker_{"Tracker", std::make_unique<TrackerRangePanel>(), tracker_procedures()};
  CalibratePage glove_{"Glove", std::make_unique<GloveTestPanel>(), glove_procedures()};
  CameraPage camera_;
  WindowPage window_;
  PicturesPage pictures_;
  ChecksPage checks_;

  void draw_tabs(Interface& ui);
};

}  // namespace prosector
