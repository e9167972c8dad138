#pragma once
// Encodes a tick's inputs as bytes without rounding, since a replay must get equal inputs. Little endian.

#include <cstdint>
#include <span>
#include <vector>

#include "server/session/people/session.h"

namespace prosector {

/// Encodes the inputs of a tick as bytes, without rounding. Returns no bytes for a tick without inputs.
std::vector<std::uint8_t> encode_input(const ConsumedInput& input);
/// Decodes the inputs of a tick from bytes that encode_input() returned. Throws InputError if the bytes are
/// not valid.
ConsumedInput decode_input(std::span<const std::uint8_t> bytes);

}  // namespace prosector
