#pragma once
// A field for a device's address, with what is plugged in behind an arrow.

#include <span>
#include <string>

#include "client/setup/interface.h"
#include "drivers/found_devices.h"

namespace prosector {

/// A key that names a device, as it is typed.
struct AddressField {
  const char* key;
  const char* name;
  std::string text;
};

/// Shows it. `nothing`: what is said where nothing is plugged in. Returns whether something was named.
bool edit_address(Interface& ui, AddressField& field, std::span<const FoundDevice> found,
                  const char* nothing);

}  // namespace prosector
