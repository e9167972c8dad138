#pragma once
// Triple buffer: passes the latest value from one thread to another. Neither thread ever waits.

#include <array>
#include <atomic>
#include <cstdint>

namespace prosector {

template <class T>
class TripleBuffer {
 public:
  /// Publishes a value for the reading thread without waiting. Only one thread may call it.
  void write(const T& value) {
    slots_[back_] = value;
    back_ = between_.exchange(static_cast<std::uint8_t>(back_ | fresh)) & slot;
  }
  /// Returns the latest published value without waiting, or T() if none was published. Only one thread may
  /// call it.
  const T& read() {
    if ((between_.load() & fresh) != 0) front_ = between_.exchange(front_) & slot;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t slot = 3, fresh = 4;

  std::array<T, 3> slots_{};
  std::uint8_t front_ = 0, back_ = 1;  // slots of the reader and of the writer
  std::atomic<std::uint8_t> between_ = 2;
};

}  // namespace prosector
