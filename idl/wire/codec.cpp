#include "idl/wire/codec.h"

#include <string_view>
#include <utility>

#include "idl/wire/convert.h"

namespace prosector {
namespace {

template <std::size_t topic>
WireCodec codec() {
  using M = std::variant_alternative_t<topic, Message>;
  using W = typename Wire<M>::Struct;
  static_assert(std::string_view(topics[topic].name) == Wire<M>::name,
                "each topic must have the name of its message type");
  return {
      Wire<M>::descriptor,
      [](const Message& message, WireArena& arena, void*& sample) -> Refusal {
        M m = std::get<M>(message);
        sample = nullptr;
        if (const Refusal refusal = check(m)) return refusal;
        W* w = arena.make<W>(1);
        to_wire(m, *w, arena);
        sample = w;
        return {};
      },
      [](const void* sample, Message& message) -> Refusal {
        M& m = message.emplace<M>();
        if (const Refusal refusal = from_wire(*static_cast<const W*>(sample), m)) return refusal;
        return check(m);
      },
      [](const void* sample, Message& message) {
        M m;
        static_cast<void>(from_wire(*static_cast<const W*>(sample), m));  // the other fields aren't set
        message = key_only(m);
      },
  };
}

template <std::size_t... topic>
std::array<WireCodec, topic_count> codecs_of(std::index_sequence<topic...>) {
  return {codec<topic>()...};
}

}  // namespace

const WireCodec& wire_codec(std::size_t topic) {
  static const auto codecs = codecs_of(std::make_index_sequence<topic_count>());
  return codecs.at(topic);
}

Refusal through_the_wire(const Message& message, Message& received, std::size_t& payload_bytes) {
  const WireCodec& codec = wire_codec(message.index());
  WireArena arena;
  void* sample = nullptr;
  if (const Refusal refusal = codec.encode(message, arena, sample)) return refusal;
  payload_bytes = codec.payload_bytes(sample);
  return codec.decode(sample, received);
}

}  // namespace prosector
