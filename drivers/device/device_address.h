#pragma once
// Parser of addresses DRIVER:PATH for a table of drivers.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/error.h"
#include "drivers/device/device.h"

namespace prosector {

/// Splits an address "DRIVER:PATH" into driver and path. `thing` ("device" or "arm") names the kind of
/// address in error messages. Throws InputError for a driver that is not in `rows` (listing the known ones)
/// or a missing path.
template <class Row>
DeviceAddress split_address(const char* thing, const std::string& address, const std::vector<Row>& rows) {
  const auto colon = address.find(':');
  const DeviceAddress parsed = {address.substr(0, colon),
                                colon == std::string::npos ? "" : address.substr(colon + 1)};
  std::string known;
  for (const Row& row : rows) known += fmt::format("{}{}", known.empty() ? "" : ", ", row.name);
  if (std::none_of(rows.begin(), rows.end(), [&](const Row& row) { return parsed.driver == row.name; }))
    throw InputError(fmt::format("{} '{}': unknown driver '{}'; known: {} (DRIVER:PATH)", thing, address,
                                 parsed.driver, known));
  if (parsed.path.empty())
    throw InputError(
        fmt::format("{} '{}': a path must follow, as in {}:PATH", thing, address, parsed.driver));
  return parsed;
}

}  // namespace prosector
