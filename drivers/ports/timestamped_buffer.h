#pragma once
// Buffer of unparsed bytes with the times at which they were read.

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace prosector {

class TimestampedBuffer {
 public:
  void append(std::span<const std::uint8_t> bytes, std::int64_t time_ns);
  std::span<const std::uint8_t> bytes() const { return std::span(bytes_).subspan(begin_); }
  /// Returns the time in ns at which the first byte of bytes() was read from the device; 0 if there is none.
  std::int64_t time_ns() const;
  void drop(std::size_t count);
  void clear();

 private:
  struct Mark {
    std::uint64_t end;  // stream offset after the chunk
    std::int64_t time_ns;
  };
  std::vector<std::uint8_t> bytes_;
  std::size_t begin_ = 0;       // first unread byte of bytes_
  std::uint64_t consumed_ = 0;  // stream offset of that byte
  std::uint64_t appended_ = 0;  // stream offset after the last byte
  std::deque<Mark> marks_;
};

}  // namespace prosector
