#pragma once
// Server side of a WebSocket as bytes, for twins that send texts and ignore received ones.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// Returns a WebSocket server's response to a client's handshake request. Returns nothing while the request
/// is incomplete or invalid.
std::optional<std::string> web_socket_answer(std::string_view request);

/// Appends a text, encoded as one unmasked WebSocket frame, to the bytes that a server sends.
void put_web_socket_text(std::vector<std::uint8_t>& out, std::string_view text);

}  // namespace prosector
