#pragma once
// State as bytes: numbers in a fixed order, read back with every size checked.

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "common/error.h"
#include "common/math.h"

namespace prosector {

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
  void add(const std::string& s) {
    add(static_cast<std::uint64_t>(s.size()));
    raw(s.data(), s.size());
  }
  void raw(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// A reader of bytes, which throws InputError at their end and for numbers that aren't finite.
class ByteReader {
 public:
  ByteReader(std::span<const std::uint8_t> bytes, std::string what) : bytes_(bytes), what_(std::move(what)) {}

  template <class T>
  T number() {
    T value;
    raw(&value, sizeof value);
    if constexpr (std::is_floating_point_v<T>) require(std::isfinite(value), "a number that isn't finite");
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
    require(v.allFinite(), "a vector that isn't finite");
    return v;
  }
  Pose pose() {
    Pose out;
    out.p = vector();
    raw(out.q.coeffs().data(), sizeof(double) * 4);
    require(out.q.coeffs().allFinite() && std::abs(out.q.norm() - 1) < 1e-6,
            "an orientation that isn't a unit quaternion");
    return out;
  }
  VecX vector(Eigen::Index expected) {
    require(number<std::uint64_t>() == static_cast<std::uint64_t>(expected), "a vector of another size");
    VecX v(expected);
    raw(v.data(), sizeof(double) * static_cast<std::size_t>(expected));
    require(v.allFinite(), "a vector that isn't finite");
    return v;
  }
  std::size_t count(std::size_t limit) {
    const auto n = number<std::uint64_t>();
    require(n <= limit, "a count beyond its limit");
    return static_cast<std::size_t>(n);
  }
  void require(bool good, const char* problem) const {
    if (!good) throw InputError(what_ + ": " + problem + " before byte " + std::to_string(at_));
  }
  bool done() const { return at_ == bytes_.size(); }

 private:
  void raw(void* to, std::size_t size) {
    require(bytes_.size() - at_ >= size, "ends too early");
    // Not memcpy, which must not be given the null pointer of an empty vector.
    std::copy_n(bytes_.data() + at_, size, static_cast<std::uint8_t*>(to));
    at_ += size;
  }

  std::span<const std::uint8_t> bytes_;
  std::string what_;
  std::size_t at_ = 0;
};

}  // namespace prosector
