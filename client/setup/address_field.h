#pragma once
// A field for a device's address, with a list of detected devices.

#include <span>
#include <string>

#include "client/setup/interface.h"
#include "drivers/config/found_devices.h"

namespace prosector {

/// Text field for a configuration key with a device's address: the key, its label, and the text as edited.
struct AddressField {
  const char* key;
  const char* name;
  std::string text;
};

/// Draws the text field for a device's address, with a list of the detected devices `found` to choose from.
/// `nothing`: text shown in the list if no device was detected. Returns whether the user entered or chose an
/// address.
bool edit_address(Interface& ui, AddressField& field, std::span<const FoundDevice> found,
                  const char* nothing);

}  // namespace prosector
