#pragma once
// Bit packing of integers of 0–32 bits without gaps, least significant bits first.

#include <cstdint>
#include <span>

#include "common/assert.h"

namespace prosector {

class BitWriter {
 public:
  /// Starts to write at the first bit of `bytes`, which must be zeroed and large enough for all values to be
  /// written.
  explicit BitWriter(std::span<std::uint8_t> bytes) : bytes_(bytes) {}

  void put(std::uint32_t value, unsigned bits) {
    PROSECTOR_ASSERT(bits <= 32 && position_ + bits <= 8 * bytes_.size());
    for (unsigned done = 0; done < bits;) {
      const unsigned offset = position_ % 8;
      const unsigned take = bits - done < 8 - offset ? bits - done : 8 - offset;
      const std::uint32_t piece = (value >> done) & ((1u << take) - 1);
      bytes_[position_ / 8] = static_cast<std::uint8_t>(bytes_[position_ / 8] | piece << offset);
      position_ += take;
      done += take;
    }
  }

 private:
  std::span<std::uint8_t> bytes_;
  std::size_t position_ = 0;  // bits
};

class BitReader {
 public:
  /// Starts to read at the first bit of `bytes`, which must contain all values to be read.
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint32_t get(unsigned bits) {
    PROSECTOR_ASSERT(bits <= 32 && position_ + bits <= 8 * bytes_.size());
    std::uint32_t value = 0;
    for (unsigned done = 0; done < bits;) {
      const unsigned offset = position_ % 8;
      const unsigned take = bits - done < 8 - offset ? bits - done : 8 - offset;
      const std::uint32_t piece =
          (static_cast<std::uint32_t>(bytes_[position_ / 8]) >> offset) & ((1u << take) - 1);
      value |= piece << done;
      position_ += take;
      done += take;
    }
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;  // bits
};

}  // namespace prosector
