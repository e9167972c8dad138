#pragma once
// Conversion of messages whose members and wire fields are listed once, for writing and for reading:
//
//   template <class Io>
//   void fields(Io& io, MessageOf<Io, HeldPose>& m, WireOf<Io, prosector_HeldPose>& w) {
//     io(m.tracked, w.tracked);
//     io(m.pose, w.pose);
//   }

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "idl/wire/primitives.h"

namespace prosector {

/// An Io that writes members of a message to fields of its wire struct.
class FieldWriter {
 public:
  template <class M>
  using Message = const M;
  template <class W>
  using Wire = W;

  explicit FieldWriter(WireArena& arena) : arena_(arena) {}

  template <class T, class Field>
  void operator()(const T& value, Field& w) {
    if constexpr (requires { to_wire(value, w); })
      to_wire(value, w);
    else if constexpr (requires { w = to_wire(value); })
      w = to_wire(value);
    else if constexpr (std::is_integral_v<T>)
      w = value;
    else
      w = static_cast<Field>(value);
  }
  /// Writes a list; `item` is called with this Io, an item and its wire struct.
  template <class T, class Sequence, class Item>
  void list(const std::vector<T>& items, Sequence& w, std::size_t, const char*, Item item) {
    make_sequence<std::remove_pointer_t<decltype(w._buffer)>>(w, items.size(), arena_);
    for (std::size_t i = 0; i < items.size(); ++i) item(*this, items[i], w._buffer[i]);
  }

 private:
  WireArena& arena_;
};

/// An Io that reads members of a message from fields of its wire struct.
class FieldReader {
 public:
  template <class M>
  using Message = M;
  template <class W>
  using Wire = const W;

  template <class T, class Field>
  void operator()(T& value, const Field& w) {
    if constexpr (requires { value = from_wire(w); })
      value = from_wire(w);
    else if constexpr (std::is_same_v<T, bool>)
      value = w != 0;
    else if constexpr (std::is_integral_v<T>)
      value = w;
    else
      value = static_cast<T>(w);
  }
  /// Reads a list of at most `limit` items. A longer one is left out, and refused with the reason
  /// `otherwise`.
  template <class T, class Sequence, class Item>
  void list(std::vector<T>& items, const Sequence& w, std::size_t limit, const char* otherwise, Item item) {
    items.clear();
    const bool readable = sequence_within(w, limit);
    checks_.that(readable, otherwise);
    if (!readable) return;
    items.resize(w._length);
    for (std::size_t i = 0; i < items.size(); ++i) item(*this, items[i], std::as_const(w._buffer[i]));
  }
  Refusal refusal() const { return checks_.refusal(); }

 private:
  Checks checks_;
};

template <class Io, class M>
using MessageOf = typename Io::template Message<M>;
template <class Io, class W>
using WireOf = typename Io::template Wire<W>;

// Defines to_wire() and from_wire() of a message by its fields().
#define PROSECTOR_WIRE_BY_FIELDS(M)                              \
  void to_wire(const M& m, prosector_##M& w, WireArena& arena) { \
    FieldWriter io(arena);                                       \
    fields(io, m, w);                                            \
  }                                                              \
  Refusal from_wire(const prosector_##M& w, M& m) {              \
    FieldReader io;                                              \
    fields(io, m, w);                                            \
    return io.refusal();                                         \
  }                                                              \
  static_assert(std::is_same_v<Wire<M>::Struct, prosector_##M>)

}  // namespace prosector
