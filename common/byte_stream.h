#pragma once
// Serialisation of plain data: numbers in a fixed order as they are in memory, little endian. Reading checks
// every size. Used by checkpoints, journals, assets and caches.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/error.h"
#include "common/math.h"

namespace prosector {

static_assert(std::endian::native == std::endian::little, "what is written is little endian");

class ByteWriter {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(const T& value) { raw(&value, sizeof value); }
  void add(const Vec3& v) { raw(v.data(), sizeof(double) * 3); }
  void add(const Quat& q) { raw(q.coeffs().data(), sizeof(double) * 4); }
  void add(const Pose& pose) {
    add(pose.p);
    add(pose.q);
  }
  void add(const VecX& v) {
    add(static_cast<std::uint64_t>(v.size()));
    raw(v.data(), sizeof(double) * static_cast<std::size_t>(v.size()));
  }
  void add(const std::string& s) { add_all(s); }
  /// Appends the number of values (u64), then the values of a vector or string as they are in memory. The
  /// value type must be plain data.
  template <class Values>
  void add_all(const Values& values) {
    add(static_cast<std::uint64_t>(values.size()));
    raw(values.data(), values.size() * sizeof(typename Values::value_type));
  }
  void raw(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }
  void reserve(std::size_t size) { bytes_.reserve(size); }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reader of serialised bytes. Throws InputError, whose text begins with `what`, when the data ends too early
/// or a value is invalid.
class ByteReader {
 public:
  ByteReader(std::span<const std::uint8_t> bytes, std::string what) : bytes_(bytes), what_(std::move(what)) {}

  /// Returns the next value of type T from its bytes, without checks: a floating-point number may be NaN.
  template <class T>
  T bits() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    raw(&value, sizeof value);
    return value;
  }
  /// Returns the next number of type T. Throws InputError if it is a floating-point number that is not
  /// finite.
  template <class T>
  T number() {
    const T value = bits<T>();
    if constexpr (std::is_floating_point_v<T>) require(std::isfinite(value), "a number is not finite");
    return value;
  }
  bool flag() {
    const auto value = number<std::uint8_t>();
    require(value <= 1, "a flag that is neither 0 nor 1");
    return value == 1;
  }
  Vec3 vector() {
    Vec3 v;
    raw(v.data(), sizeof(double) * 3);
    require(v.allFinite(), "a vector is not finite");
    return v;
  }
  Pose pose() {
    Pose out;
    out.p = vector();
    raw(out.q.coeffs().data(), sizeof(double) * 4);
    require(out.q.coeffs().allFinite() && std::abs(out.q.norm() - 1) < 1e-6,
            "an orientation is not a unit quaternion");
    return out;
  }
  VecX vector(Eigen::Index expected) {
    require(number<std::uint64_t>() == static_cast<std::uint64_t>(expected), "a vector has the wrong size");
    VecX v(expected);
    raw(v.data(), sizeof(double) * static_cast<std::size_t>(expected));
    require(v.allFinite(), "a vector is not finite");
    return v;
  }
  /// Returns the next count (u64). Throws InputError if it exceeds `limit`.
  std::size_t count(std::size_t limit) {
    const auto n = number<std::uint64_t>();
    require(n <= limit, "a count beyond its limit");
    return static_cast<std::size_t>(n);
  }
  /// Returns the next count (u32), that of records of at least `size` bytes each. Throws InputError if they
  /// exceed the remaining bytes, so that a false count can't cause a large allocation.
  std::uint32_t records(std::size_t size) {
    const auto n = bits<std::uint32_t>();
    require(n <= left() / size, "more records than fit");
    return n;
  }
  /// Returns the next `size` bytes. Throws InputError if fewer are left.
  std::span<const std::uint8_t> block(std::size_t size) {
    require(left() >= size, "truncated");
    const auto out = bytes_.subspan(at_, size);
    at_ += size;
    return out;
  }
  /// Reads a vector or string that ByteWriter::add_all() wrote: the number of values (u64), then the values.
  template <class Values>
  void read_all(Values& values) {
    using T = typename Values::value_type;
    const auto n = bits<std::uint64_t>();
    require(n <= left() / sizeof(T), "more values than fit");
    values.resize(static_cast<std::size_t>(n));
    raw(values.data(), values.size() * sizeof(T));
  }
  void require(bool good, const char* problem) const {
    if (!good) throw InputError(what_ + ": " + problem + " before byte " + std::to_string(at_));
  }
  bool done() const { return at_ == bytes_.size(); }
  void end() const { require(done(), "unexpected data at the end"); }

 private:
  std::size_t left() const { return bytes_.size() - at_; }
  void raw(void* to, std::size_t size) {
    const auto from = block(size);
    // Not memcpy: an empty vector's data() may be a null pointer, which memcpy must not be given.
    std::copy_n(from.data(), size, static_cast<std::uint8_t*>(to));
  }

  std::span<const std::uint8_t> bytes_;
  std::string what_;
  std::size_t at_ = 0;
};

}  // namespace prosector
