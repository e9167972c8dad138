#pragma once
// The page of the window mode: the camera that detects the user's eyes, the measured geometry, and the
// current position of the eyes.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/setup/address_field.h"
#include "client/setup/config_draft.h"
#include "client/setup/device_watch.h"
#include "client/setup/interface.h"
#include "client/setup/setup_session.h"

namespace prosector {

class WindowPage {
 public:
  void draw(Interface& ui, SetupSession& room, ConfigDraft& draft, std::int64_t now_ns);
  /// Closes the camera that detects the user's eyes, so that another program can use it.
  void close();
  bool running() const { return watch_ != nullptr; }
  const Said& said() const { return said_; }

 private:
  AddressField address_{"window.address", msg("Eye tracker"), {}};
  std::vector<FoundDevice> found_;
  std::int64_t found_ns_ = 0;
  std::unique_ptr<DeviceWatch> watch_;
  bool is_read_ = false;  // the address was read from the draft
  bool is_old_ = true;    // the draft differs from the opened camera
  Said said_;

  void look(const ConfigDraft& draft, std::int64_t now_ns);
  void change(ConfigDraft& draft, const std::vector<ConfigChange>& changes);
  void name_camera(ConfigDraft& draft);
  void draw_settings(Interface& ui, ConfigDraft& draft);
  void draw_camera(Interface& ui, ConfigDraft& draft);
  void draw_use(Interface& ui, ConfigDraft& draft);
  void draw_seen(Interface& ui, const WindowSettings& window, std::int64_t now_ns);
  static void draw_display(Interface& ui, DisplaySettings& seen);
  std::optional<Vec3> eyes(std::int64_t now_ns) const;
};

}  // namespace prosector
