#include "common/valid_text.h"

#include "common/ids.h"

namespace prosector {
namespace {

/// Decodes one code point at `i` and advances past it. Returns −1 for invalid UTF-8 (RFC 3629: overlong
/// forms, surrogates and values above U+10FFFF are refused).
long next_code_point(std::string_view text, std::size_t& i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char lead = byte(i);
  if (lead < 0x80) return text[i++];
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || i + length > text.size()) return -1;
  long code = lead & (0x7f >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xc0) != 0x80) return -1;
    code = (code << 6) | (byte(i + k) & 0x3f);
  }
  i += length;
  constexpr long smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < smallest[length] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return -1;
  return code;
}

bool is_control(long code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0);
}

bool printable(std::string_view text, bool lines) {
  for (std::size_t i = 0; i < text.size();) {
    const long code = next_code_point(text, i);
    if (code < 0) return false;
    if (is_control(code) && !(lines && (code == '\n' || code == '\t'))) return false;
  }
  return true;
}

}  // namespace

bool valid_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();)
    if (next_code_point(text, i) < 0) return false;
  return true;
}

bool valid_name(std::string_view name) {
  return !name.empty() && name.size() <= max_name_length && printable(name, false);
}

bool valid_text(std::string_view text) {
  return text.size() <= max_text_length && printable(text, true);
}

}  // namespace prosector
