#include "common/draft/toml_text.h"

#include <fmt/format.h>

namespace prosector {

std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += fmt::format("\\{}", c);
    else if (byte < 0x20 || byte == 0x7f)
      out += fmt::format("\\u{:04x}", byte);
    else
      out += c;
  }
  return out + '"';
}

std::string toml_number(double x) {
  return fmt::format("{:.5g}", x == 0 ? 0 : x);  // no -0
}

std::string toml_numbers(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", toml_number(v[0]), toml_number(v[1]), toml_number(v[2]));
}

}  // namespace prosector
