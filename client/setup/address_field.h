#pragma once
// A field for a device's address, with a list of detected devices.

#include <span>
#include <string>

#include "client/setup/interface.h"
#include "drivers/config/found_devices.h"

namespace prosector {

/// A configuration key with a device's address, as edited.
struct AddressField {
  const char* key;
  const char* name;
  std::string text;
};

/// Draws the field. `nothing`: shown if no device was detected. Returns whether an address was entered.
bool edit_address(Interface& ui, AddressField& field, std::span<const FoundDevice> found,
                  const char* nothing);

}  // namespace prosector
