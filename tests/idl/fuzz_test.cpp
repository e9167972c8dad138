// Mutated and random wire structs through the edge: whatever arrives, decoding ends, and what is accepted
// keeps the promises of the checks.

#include <gtest/gtest.h>

#include <random>

#include "idl/wire/codec.h"
#include "idl/wire/convert.h"
#include "tests/idl/samples.h"

namespace prosector {
namespace {

/// The part of a wire struct before its first sequence holds no pointers: any bytes may stand there.
template <class W>
constexpr std::size_t plain_bytes() {
  if constexpr (requires(W w) { w.bodies; })
    return offsetof(W, bodies);
  else if constexpr (requires(W w) { w.bytes; })
    return offsetof(W, bytes);
  else if constexpr (requires(W w) { w.packed; })
    return offsetof(W, packed);
  else if constexpr (requires(W w) { w.points._length; })
    return offsetof(W, points);
  else if constexpr (requires(W w) { w.positions; })
    return offsetof(W, positions);
  else if constexpr (requires(W w) { w.marks; })
    return offsetof(W, marks);
  else if constexpr (requires(W w) { w.holders; })
    return offsetof(W, holders);
  else if constexpr (requires(W w) { w.prices; })
    return offsetof(W, prices);
  else if constexpr (requires(W w) { w.planes; })
    return offsetof(W, planes);
  else
    return sizeof(W);
}

template <class M>
void fuzz(const M& valid, std::mt19937_64& random) {
  using W = typename Wire<M>::Struct;
  constexpr int rounds = 3000;
  int refused = 0;
  for (int round = 0; round < rounds; ++round) {
    WireArena arena;
    W w{};
    to_wire(valid, w, arena);
    auto* bytes = reinterpret_cast<std::uint8_t*>(&w);
    const std::size_t changes = round % 10 == 0 ? plain_bytes<W>() : 1 + random() % 8;
    for (std::size_t i = 0; i < changes; ++i)
      bytes[random() % plain_bytes<W>()] = static_cast<std::uint8_t>(random());
    if constexpr (requires { w.packed; }) w.packed._buffer[random() % w.packed._length] ^= 0xff;
    if constexpr (requires { w.marks; }) {
      auto* marks = reinterpret_cast<std::uint8_t*>(w.marks._buffer);
      marks[random() % (w.marks._length * sizeof(prosector_RecordingMark))] =
          static_cast<std::uint8_t>(random());
    }
    if constexpr (requires { w.planes; }) {
      auto* planes = reinterpret_cast<std::uint8_t*>(w.planes._buffer);
      planes[random() % (w.planes._length * sizeof(prosector_ContactPlane))] =
          static_cast<std::uint8_t>(random());
    }
    if constexpr (requires { w.prices; }) {
      auto* prices = reinterpret_cast<std::uint8_t*>(w.prices._buffer);
      prices[random() % (w.prices._length * sizeof(prosector_Price))] = static_cast<std::uint8_t>(random());
      auto* map = reinterpret_cast<std::uint8_t*>(&w.error_map);
      map[random() % offsetof(prosector_ErrorMap, levels)] = static_cast<std::uint8_t>(random());
    }
    if constexpr (requires { w.vertices; }) {
      reinterpret_cast<std::uint8_t*>(w.points._buffer)[random() % (2 * sizeof(prosector_PatchPoint))] ^= 1;
      auto* vertices = reinterpret_cast<std::uint8_t*>(w.vertices._buffer);
      vertices[random() % (2 * sizeof(prosector_PatchVertex))] = static_cast<std::uint8_t>(random());
      auto* triangles = reinterpret_cast<std::uint8_t*>(w.triangles._buffer);
      triangles[random() % (2 * sizeof(prosector_PatchTriangle))] = static_cast<std::uint8_t>(random());
    }
    Message message;
    const WireCodec& codec = wire_codec(topic_of<M>());
    if (codec.decode(&w, message)) {
      ++refused;
      continue;
    }
    Message again;
    std::size_t size = 0;
    EXPECT_FALSE(through_the_wire(message, again, size)) << "accepted, but not fit to be sent on";
  }
  EXPECT_GT(refused, 0) << topics[topic_of<M>()].name;
}

template <std::size_t... topic>
void fuzz_all(const std::vector<Message>& samples, std::index_sequence<topic...>) {
  std::mt19937_64 random(1);
  (fuzz(std::get<topic>(samples.at(topic)), random), ...);
}

TEST(Fuzz, MutatedWireStructs) {
  fuzz_all(sample_messages(), std::make_index_sequence<topic_count>());
}

}  // namespace
}  // namespace prosector
