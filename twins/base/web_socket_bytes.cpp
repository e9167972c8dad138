#include "twins/base/web_socket_bytes.h"

#include <array>
#include <boost/uuid/detail/sha1.hpp>

namespace prosector {
namespace {

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63u];
  }
  return out;
}

}  // namespace

std::optional<std::string> web_socket_answer(std::string_view request) {
  constexpr std::string_view name = "Sec-WebSocket-Key: ", guid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
  if (request.find("\r\n\r\n") == std::string_view::npos) return std::nullopt;
  const auto at = request.find(name);
  if (at == std::string_view::npos) return std::nullopt;
  const auto rest = request.substr(at + name.size());
  const std::string key = std::string(rest.substr(0, rest.find("\r\n"))) + std::string(guid);
  boost::uuids::detail::sha1 sha1;
  sha1.process_bytes(key.data(), key.size());
  unsigned int digest[5];
  sha1.get_digest(digest);
  std::vector<std::uint8_t> bytes;
  for (const unsigned int word : digest)
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  return "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Accept: " +
         base64(bytes) + "\r\n\r\n";
}

void put_web_socket_text(std::vector<std::uint8_t>& out, std::string_view text) {
  constexpr std::uint8_t whole_text = 0x81, two_bytes = 126, eight_bytes = 127;
  const std::size_t size = text.size();
  out.push_back(whole_text);
  int width = 0;
  if (size < two_bytes) {
    out.push_back(static_cast<std::uint8_t>(size));
  } else {
    width = size <= 0xffff ? 2 : 8;
    out.push_back(width == 2 ? two_bytes : eight_bytes);
  }
  for (int i = width - 1; i >= 0; --i) out.push_back(static_cast<std::uint8_t>(size >> (8 * i)));
  out.insert(out.end(), text.begin(), text.end());
}

}  // namespace prosector
