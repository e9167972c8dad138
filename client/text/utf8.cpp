#include "client/text/utf8.h"

#include <cstddef>
#include <cstdint>

namespace prosector {
namespace {

/// A lead byte's properties: the number of following bytes, and the range of the second byte. The range
/// excludes overlong forms, surrogates and values above U+10FFFF (Unicode 15, table 3-7).
struct Lead {
  std::size_t more;  // number of following bytes
  char32_t bits;     // of the lead byte
  unsigned char least = 0x80, most = 0xBF;
};

/// Returns the lead's properties; for an invalid lead byte, no following bytes and the replacement character.
Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {0, byte};
  if (byte < 0xC2 || byte > 0xF4) return {0, replacement_character};
  if (byte < 0xE0) return {1, static_cast<char32_t>(byte & 0x1F)};
  if (byte < 0xF0) {
    Lead lead{2, static_cast<char32_t>(byte & 0x0F)};
    if (byte == 0xE0) lead.least = 0xA0;
    if (byte == 0xED) lead.most = 0x9F;
    return lead;
  }
  Lead lead{3, static_cast<char32_t>(byte & 0x07)};
  if (byte == 0xF0) lead.least = 0x90;
  if (byte == 0xF4) lead.most = 0x8F;
  return lead;
}

/// Removes one character from the text and returns it. Of an ill-formed sequence, removes its longest valid
/// beginning.
char32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const Lead lead = lead_of(byte(0));
  char32_t character = lead.bits;
  std::size_t used = 1;
  bool whole = true;
  for (; used <= lead.more; ++used) {
    const unsigned char least = used == 1 ? lead.least : 0x80, most = used == 1 ? lead.most : 0xBF;
    whole = used < text.size() && byte(used) >= least && byte(used) <= most;
    if (!whole) break;
    character = character << 6 | (byte(used) & 0x3FU);
  }
  text.remove_prefix(used);
  return whole ? character : replacement_character;
}

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0);
}

}  // namespace

std::u32string characters_of(std::string_view utf8) {
  std::u32string out;
  out.reserve(utf8.size());
  while (!utf8.empty()) {
    if (utf8.starts_with("\r\n")) utf8.remove_prefix(1);
    const char32_t c = take_character(utf8);
    out += is_control(c) && c != U'\n' && c != U'\t' ? replacement_character : c;
  }
  return out;
}

std::string utf8_of(std::u32string_view characters) {
  std::string out;
  const auto add = [&](char32_t bits) { out += static_cast<char>(static_cast<unsigned char>(bits)); };
  for (char32_t c : characters) {
    if (c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) c = replacement_character;
    const int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr char32_t marks[] = {0, 0xC0, 0xE0, 0xF0};
    add(marks[more] | c >> (6 * more));
    for (int k = more - 1; k >= 0; --k) add(0x80 | (c >> (6 * k) & 0x3F));
  }
  return out;
}

}  // namespace prosector
