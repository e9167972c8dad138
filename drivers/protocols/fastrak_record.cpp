#include "drivers/protocols/fastrak_record.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>

namespace prosector::fastrak {
namespace {

constexpr std::array<ItemRow, 9> table = {{
    {0, 0, 1, 1, 0, "space"},
    {1, 0, 2, 2, 0, "CR LF"},
    {2, 3, 21, 12, 2, "position"},
    {4, 3, 21, 12, 2, "azimuth, elevation, roll"},
    {5, 3, 21, 12, 4, "direction cosines of X"},
    {6, 3, 21, 12, 4, "direction cosines of Y"},
    {7, 3, 21, 12, 4, "direction cosines of Z"},
    {11, 4, 28, 16, 4, "quaternion"},
    {16, 0, 1, 2, 0, "stylus switch"},
}};

constexpr float max_position = 1000;  // cm or in: beyond any field that the transmitter can generate
constexpr float max_angle = 360.5f, max_cosine = 1.01f, unit_tolerance = 0.02f;

std::optional<float> read_ascii(const std::uint8_t* bytes) {
  std::array<char, number_width + 1> text{};
  std::memcpy(text.data(), bytes, number_width);
  if (text[number_width - 1] == ' ') return std::nullopt;
  for (std::size_t i = 0; i < number_width; ++i)
    if (std::strchr(" +-.0123456789", text[i]) == nullptr || text[i] == 0) return std::nullopt;
  char* end = nullptr;
  const float value = std::strtof(text.data(), &end);
  if (end != text.data() + number_width) return std::nullopt;
  return value;
}

std::optional<float> read_binary(const std::uint8_t* bytes) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | bytes[i];
  return std::bit_cast<float>(bits);
}

template <std::size_t N>
std::optional<std::array<float, N>> read_numbers(const std::uint8_t* bytes, bool binary, float limit) {
  std::array<float, N> values{};
  for (std::size_t i = 0; i < N; ++i) {
    const auto value = binary ? read_binary(bytes + 4 * i) : read_ascii(bytes + number_width * i);
    if (!value || !(std::abs(*value) <= limit)) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

bool near_unit(const std::array<float, 4>& q) {
  float norm2 = 0;
  for (const float x : q) norm2 += x * x;
  return std::abs(std::sqrt(norm2) - 1) < unit_tolerance;
}

bool read_item(const ItemRow& item, const std::uint8_t* bytes, bool binary, Record& out) {
  switch (item.code) {
    case 0:
      return bytes[0] == ' ';
    case 1:
      return bytes[0] == '\r' && bytes[1] == '\n';
    case 2:
      return (out.position = read_numbers<3>(bytes, binary, max_position)).has_value();
    case 4:
      return (out.angles = read_numbers<3>(bytes, binary, max_angle)).has_value();
    case 11:
      out.quaternion = read_numbers<4>(bytes, binary, max_cosine);
      return out.quaternion && near_unit(*out.quaternion);
    case 16: {
      if (binary && bytes[0] != ' ') return false;
      const std::uint8_t digit = bytes[binary ? 1 : 0];
      out.stylus = digit == '1';
      return digit == '0' || digit == '1';
    }
    default: {  // items 5, 6, 7: direction cosines
      auto& row = out.cosines[static_cast<std::size_t>(item.code - 5)];
      return (row = read_numbers<3>(bytes, binary, max_cosine)).has_value();
    }
  }
}

bool is_error_character(std::uint8_t c) {
  return c == ' ' || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

// Rotation from the transmitter's axes to Prosector's. Rows: Prosector's x, y, z in the transmitter's X, Y,
// Z.
const Quat& axes() {
  static const Quat q = [] {
    Mat3 m;
    m << 0, 1, 0, 0, 0, -1, -1, 0, 0;
    return Quat(m);
  }();
  return q;
}

}  // namespace

std::span<const ItemRow> item_table() {
  return table;
}

const ItemRow* find_item(int code) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const ItemRow& r) { return r.code == code; });
  return row == table.end() ? nullptr : &*row;
}

std::size_t record_width(const Format& format) {
  std::size_t width = header_width;
  for (const int code : format.items)
    if (const ItemRow* item = find_item(code))
      width += format.binary ? item->binary_width : item->ascii_width;
  return width;
}

std::optional<Record> decode(std::span<const std::uint8_t> bytes, const Format& format) {
  if (bytes.size() != record_width(format) || bytes[0] != '0') return std::nullopt;
  if (bytes[1] < '1' || bytes[1] > '4' || !is_error_character(bytes[2])) return std::nullopt;
  Record record;
  record.station = static_cast<std::uint32_t>(bytes[1] - '1');
  record.error = static_cast<char>(bytes[2]);
  std::size_t at = header_width;
  for (const int code : format.items) {
    const ItemRow* item = find_item(code);
    if (item == nullptr || !read_item(*item, bytes.data() + at, format.binary, record)) return std::nullopt;
    at += format.binary ? item->binary_width : item->ascii_width;
  }
  return record;
}

Quat rotation(const std::array<float, 3>& angles) {
  constexpr double radians = std::numbers::pi / 180;
  return Eigen::AngleAxisd(angles[0] * radians, Vec3::UnitZ()) *
         Eigen::AngleAxisd(angles[1] * radians, Vec3::UnitY()) *
         Eigen::AngleAxisd(angles[2] * radians, Vec3::UnitX());
}

std::array<double, 3> euler_angles(const Quat& q) {
  constexpr double degrees = 180 / std::numbers::pi;
  const Mat3 r = q.toRotationMatrix();
  return {std::atan2(r(1, 0), r(0, 0)) * degrees, std::asin(std::clamp(-r(2, 0), -1.0, 1.0)) * degrees,
          std::atan2(r(2, 1), r(2, 2)) * degrees};
}

Pose from_transmitter(const Pose& transmitter) {
  return {axes() * transmitter.p, (axes() * transmitter.q * axes().conjugate()).normalized()};
}

Pose to_transmitter(const Pose& device) {
  return {axes().conjugate() * device.p, (axes().conjugate() * device.q * axes()).normalized()};
}

}  // namespace prosector::fastrak
