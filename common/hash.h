#pragma once
// Two hashes: ContentHash identifies content (assets, caches), StateHasher verifies state. Both are xxHash3,
// not cryptographic.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace prosector {

/// Hash that identifies a piece of content, such as a mesh. Equal bytes have equal hashes on every machine.
using ContentHash = std::array<std::uint8_t, 16>;

ContentHash content_hash(std::span<const std::byte> bytes);
std::string to_hex(const ContentHash& hash);
std::string to_hex(std::uint64_t hash);

/// Hasher of a simulation's state, whose bytes are added in a fixed order. Two digests are equal if and only
/// if all bits were equal, except for collisions.
class StateHasher {
 public:
  StateHasher();
  ~StateHasher();
  StateHasher(const StateHasher&) = delete;
  StateHasher& operator=(const StateHasher&) = delete;

  void add(std::span<const std::byte> bytes);
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(const T& value) { add(std::as_bytes(std::span<const T, 1>(&value, 1))); }
  /// Adds `count` contiguous numbers to the hashed state, for instance those of an Eigen vector's data().
  void add(const double* values, std::size_t count) { add(std::as_bytes(std::span(values, count))); }
  std::uint64_t digest() const;

 private:
  void* state_;
};

}  // namespace prosector
