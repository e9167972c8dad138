#pragma once
// Storage for the sequences of one outgoing sample, freed as a whole.

#include <cstddef>
#include <memory_resource>
#include <new>
#include <type_traits>

namespace prosector {

class WireArena {
 public:
  /// Returns `count` value-initialised elements, which exist as long as the arena; nullptr if `count` is 0.
  template <class T>
  T* make(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    if (count == 0) return nullptr;
    T* first = static_cast<T*>(memory_.allocate(count * sizeof(T), alignof(T)));
    for (std::size_t i = 0; i < count; ++i) new (first + i) T{};
    return first;
  }

 private:
  std::pmr::monotonic_buffer_resource memory_;
};

}  // namespace prosector
