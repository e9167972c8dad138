#include "drivers/protocols/space_mouse_records.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace prosector::space_mouse {
namespace {

constexpr std::int32_t most_push = 10'000, most_period_ms = 1'000'000'000, most_button = 255;

}  // namespace

std::optional<Record> decode(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != record_width) return std::nullopt;
  std::array<std::uint8_t, record_width> copy{};
  std::ranges::copy(bytes, copy.begin());
  const auto numbers = std::bit_cast<std::array<std::int32_t, 8>>(copy);
  Record out;
  out.kind = numbers[0];
  if (out.kind == motion) {
    for (std::size_t i = 0; i < axes; ++i) {
      if (numbers[1 + i] > most_push || numbers[1 + i] < -most_push) return std::nullopt;
      out.push[i] = numbers[1 + i];
    }
    out.period_ms = numbers[7];
    if (out.period_ms < 0 || out.period_ms > most_period_ms) return std::nullopt;
  } else if (out.kind == press || out.kind == release) {
    out.button = numbers[1];
    if (out.button < 0 || out.button > most_button) return std::nullopt;
  } else {
    return std::nullopt;
  }
  return out;
}

std::array<std::uint8_t, record_width> encode(const Record& record) {
  std::array<std::int32_t, 8> numbers{record.kind};
  if (record.kind == motion) {
    std::ranges::copy(record.push, numbers.begin() + 1);
    numbers[7] = record.period_ms;
  } else {
    numbers[1] = record.button;
  }
  return std::bit_cast<std::array<std::uint8_t, record_width>>(numbers);
}

}  // namespace prosector::space_mouse
