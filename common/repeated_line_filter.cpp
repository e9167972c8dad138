#include "common/repeated_line_filter.h"

#include <fmt/format.h>

#include <utility>

namespace prosector {

std::string line_kind(std::string line) {
  std::erase_if(line, [](char c) { return c >= '0' && c <= '9'; });
  return line;
}

std::optional<std::string> RepeatedLineFilter::admit(const std::string& line, double now) {
  if (kinds_.size() >= most_kinds) kinds_.clear();
  const auto [found, is_new] = kinds_.try_emplace(line_kind(line), Kind{now});
  Kind& kind = found->second;
  if (!is_new && now - kind.printed < seconds_) {
    ++kind.left_out;
    return std::nullopt;
  }
  kind.printed = now;
  const std::size_t left_out = std::exchange(kind.left_out, 0);
  return left_out == 0 ? line : fmt::format("{} (and {} similar)", line, left_out);
}

}  // namespace prosector
