#pragma once
// Decoder of Polhemus FASTRAK data records: output items, their widths and their formats. After the FASTRAK
// manual, revision G (2012).

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector::fastrak {

/// One row of the table of output items that a FASTRAK record may contain, such as position or quaternion:
/// item code, number of values and widths.
struct ItemRow {
  int code;
  std::size_t numbers;       // count of numbers in the item
  std::size_t ascii_width;   // bytes of the whole item
  std::size_t binary_width;  // bytes of the whole item
  int decimals;              // of each number in ASCII
  const char* name;
};
std::span<const ItemRow> item_table();
/// Returns the row of the table of FASTRAK output items with this item code, or nullptr if the code is
/// unknown.
const ItemRow* find_item(int code);

inline constexpr std::size_t max_items = 32;
inline constexpr std::size_t number_width = 7;  // characters per ASCII number
inline constexpr std::size_t header_width = 3;  // '0', station, error character

struct Format {
  bool binary = false;
  std::vector<int> items = {2, 4, 1};  // output list; here the device's default
};
std::size_t record_width(const Format& format);

/// One decoded data record of a FASTRAK tracker: a receiver's number, error character and measured values.
/// The device's frames are right-handed with +X forward, +Y right, +Z down; angles are in degrees.
struct Record {
  std::uint32_t station = 0;  // 0-based
  char error = ' ';
  std::optional<std::array<float, 3>> position;                // the device's units
  std::optional<std::array<float, 3>> angles;                  // azimuth, elevation, roll
  std::array<std::optional<std::array<float, 3>>, 3> cosines;  // rows of the rotation matrix
  std::optional<std::array<float, 4>> quaternion;              // scalar first
  std::optional<bool> stylus;
};

/// Decodes one FASTRAK record of exactly record_width(format) bytes. Returns nothing unless header and
/// separators are valid, numbers are finite and in range, and the quaternion has nearly unit length.
std::optional<Record> decode(std::span<const std::uint8_t> bytes, const Format& format);

/// Returns the rotation R = Rz(azimuth)·Ry(elevation)·Rx(roll) for the FASTRAK angles azimuth, elevation,
/// roll in degrees.
Quat rotation(const std::array<float, 3>& angles);
/// Computes the FASTRAK angles azimuth, elevation, roll of a rotation, so that rotation() restores it.
/// Azimuth and roll are in (−180, 180], elevation in [−90, 90] degrees.
std::array<double, 3> euler_angles(const Quat& q);

/// Maps a pose from the FASTRAK transmitter's axes (+X forward, +Y right, +Z down) to Prosector's axes (x
/// right, y up, −z forward) by x′ = Y, y′ = −Z, z′ = −X. Rotations are conjugated with the same mapping.
Pose from_transmitter(const Pose& transmitter);
Pose to_transmitter(const Pose& device);

}  // namespace prosector::fastrak
