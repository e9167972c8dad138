#pragma once
// The page of trackers, gloves and arms: detected devices, their live data, and the assignment of receivers.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/setup/address_field.h"
#include "client/setup/config_draft.h"
#include "client/setup/device_watch.h"
#include "client/setup/interface.h"
#include "client/setup/text_styles.h"

namespace prosector {

class DevicesPage {
 public:
  void draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  /// Closes the devices that the page has opened, so that another program can use them.
  void close() { watch_.reset(); }
  bool open() const { return watch_ != nullptr; }
  const Said& said() const { return said_; }

 private:
  std::array<AddressField, 4> fields_ = {{{"tracker.address", msg("Tracker"), {}},
                                          {"glove.right.address", msg("Right glove"), {}},
                                          {"glove.left.address", msg("Left glove"), {}},
                                          {"arm.address", msg("Arm"), {}}}};
  std::unique_ptr<DeviceWatch> watch_;
  std::vector<FoundDevice> found_;
  std::int64_t found_ns_ = 0;
  std::size_t shown_ = 0;                // index of the shown device
  std::optional<StationRole> assigned_;  // role to assign to the receiver that is moved …
  std::int64_t assigned_until_ns_ = 0;   // … until this time
  Said said_;

  void look(const ConfigDraft& draft, std::int64_t now_ns);
  void change(ConfigDraft& draft, const std::vector<ConfigChange>& changes, const std::string& done);
  void assign(const Interface& ui, ConfigDraft& draft, StationRole role, std::uint32_t station);
  void free_role(const Interface& ui, ConfigDraft& draft, StationRole role);
  void draw_addresses(Interface& ui, ConfigDraft& draft);
  void draw_status(Interface& ui);
  void draw_device(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  void draw_roles(Interface& ui, ConfigDraft& draft, const WatchedDevice& tracker, std::int64_t now_ns);
};

}  // namespace prosector
