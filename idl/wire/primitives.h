#pragma once
// Conversions shared by several wire structs.

#include <cstring>
#include <limits>
#include <string>

#include "common/assert.h"
#include "common/hash.h"
#include "common/ids.h"
#include "idl/wire/convert.h"

namespace prosector {

template <std::size_t N>
void to_wire(const std::string& text, char (&w)[N]) {
  PROSECTOR_ASSERT(text.size() < N);
  const std::size_t length = std::min(text.size(), N - 1);
  std::memcpy(w, text.data(), length);
  std::memset(w + length, 0, N - length);
}
template <std::size_t N>
std::string from_wire(const char (&w)[N]) {
  return {w, strnlen(w, N)};
}

template <class Scalar>
void to_wire(const Vec3& v, Scalar (&w)[3]) {
  for (int i = 0; i < 3; ++i) w[i] = static_cast<Scalar>(v[i]);
}
template <class Scalar>
Vec3 from_wire(const Scalar (&w)[3]) {
  return {w[0], w[1], w[2]};
}

template <class WirePose>
requires requires(WirePose w) {
  w.p[2], w.q[3];
}
void to_wire(const Pose& pose, WirePose& w) {
  using Scalar = std::remove_reference_t<decltype(w.q[0])>;
  to_wire(pose.p, w.p);
  w.q[0] = static_cast<Scalar>(pose.q.w());
  w.q[1] = static_cast<Scalar>(pose.q.x());
  w.q[2] = static_cast<Scalar>(pose.q.y());
  w.q[3] = static_cast<Scalar>(pose.q.z());
}
template <class WirePose>
requires requires(WirePose w) {
  w.p[2], w.q[3];
}
Pose from_wire(const WirePose& w) {
  return {from_wire(w.p), Quat(w.q[0], w.q[1], w.q[2], w.q[3])};
}

inline prosector_Affine to_wire(const Affine& m) {
  prosector_Affine w;
  for (int i = 0; i < 9; ++i) w.a[i] = m.A(i / 3, i % 3);
  to_wire(m.p, w.p);
  return w;
}
inline Affine from_wire(const prosector_Affine& w) {
  Affine m;
  for (int i = 0; i < 9; ++i) m.A(i / 3, i % 3) = w.a[i];
  m.p = from_wire(w.p);
  return m;
}

inline prosector_TimeStamp to_wire(const SimTime& t) {
  return {t.epoch, t.tick};
}
inline SimTime from_wire(const prosector_TimeStamp& w) {
  return {w.epoch, w.tick};
}

inline prosector_Digest to_wire(const ContentHash& hash) {
  prosector_Digest w{};
  for (std::size_t i = 0; i < 8; ++i) {
    w.high = w.high << 8 | hash[i];
    w.low = w.low << 8 | hash[8 + i];
  }
  return w;
}
inline ContentHash from_wire(const prosector_Digest& w) {
  ContentHash hash{};
  for (std::size_t i = 0; i < 8; ++i) {
    hash[7 - i] = static_cast<std::uint8_t>(w.high >> (8 * i));
    hash[15 - i] = static_cast<std::uint8_t>(w.low >> (8 * i));
  }
  return hash;
}

/// Makes the wire sequence `w` refer to `count` new elements of the arena, value-initialised.
template <class Element, class Sequence>
void make_sequence(Sequence& w, std::size_t count, WireArena& arena) {
  PROSECTOR_ASSERT(count <= std::numeric_limits<std::uint32_t>::max());
  w._maximum = w._length = static_cast<std::uint32_t>(count);
  w._buffer = arena.make<Element>(count);
  w._release = false;
}
template <class Sequence>
bool sequence_within(const Sequence& w, std::size_t limit) {
  return w._length <= limit && (w._length == 0 || w._buffer != nullptr);
}

}  // namespace prosector
