#pragma once
// The set-up window's pages, and what is said below them.

#include "client/setup/anteroom.h"
#include "client/setup/calibrate_page.h"
#include "client/setup/camera_page.h"
#include "client/setup/checks_page.h"
#include "client/setup/devices_page.h"
#include "client/setup/enter_page.h"
#include "client/setup/glove_live.h"
#include "client/setup/interface.h"
#include "client/setup/pictures_page.h"
#include "client/setup/tracker_range.h"
#include "client/setup/window_page.h"

namespace prosector {

class Pages {
 public:
  Pages(Anteroom& room, ConfigDraft& draft, std::function<MachineCheck()> measure_pictures,
        std::vector<EyeDisplay> displays)
      : room_(room), draft_(draft), pictures_(std::move(displays)), checks_(std::move(measure_pictures)) {}

  void draw(Interface& ui);
  const Said& said() const { return *said_; }
  /// Tells whether something is shown that goes on by itself.
  bool lively() const {
    return devices_.open() || tracker_.running() || glove_.running() || camera_.running() ||
           window_.running() || pictures_.running();
  }
  /// Returns the screen to fill now, from 0; none: a window.
  std::optional<int> full_screen() const;

 private:
  Anteroom& room_;
  ConfigDraft& draft_;
  const Said* said_ = &room_.said();  // of the page that is open
  EnterPage enter_;
  DevicesPage devices_;
  CalibratePage tracker_{"Tracker", std::make_unique<TrackerRange>(), tracker_procedures()};
  CalibratePage glove_{"Glove", std::make_unique<GloveLive>(), glove_procedures()};
  CameraPage camera_;
  WindowPage window_;
  PicturesPage pictures_;
  ChecksPage checks_;
};

}  // namespace prosector
