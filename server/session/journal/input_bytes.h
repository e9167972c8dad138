#pragma once
// Encodes a tick's inputs as bytes without rounding, since a replay must get equal inputs. Little endian.

#include <cstdint>
#include <span>
#include <vector>

#include "server/session/people/session.h"

namespace prosector {

/// Encodes an input; empty for a tick that consumed nothing.
std::vector<std::uint8_t> encode_input(const ConsumedInput& input);
/// Decodes an input. Throws InputError when the bytes are not a valid input.
ConsumedInput decode_input(std::span<const std::uint8_t> bytes);

}  // namespace prosector
