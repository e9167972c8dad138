#pragma once
// The server's side of a WebSocket as bytes, for twins that send texts and heed none.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

/// Returns the answer to a client's request to speak WebSocket; nothing while it is not whole, or is none.
std::optional<std::string> web_socket_answer(std::string_view request);

/// Appends a text as one frame.
void put_web_socket_text(std::vector<std::uint8_t>& out, std::string_view text);

}  // namespace prosector
