#pragma once
// A message's values as bytes, to compare messages.

#include <string>

#include "idl/message.h"

namespace prosector::test {

/// Returns the bytes of all values of the message, in one order.
std::string as_wire_bytes(const Message& message);

}  // namespace prosector::test
