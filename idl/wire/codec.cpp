#include "idl/wire/codec.h"

#include <cstring>

#include "idl/wire/convert.h"

namespace prosector {
namespace {

// Payload: the struct in memory is laid out as CDR is, but for strings and sequences. Strings take their
// length and the characters in use, not the capacity; sequences take their length and elements, not the
// pointer.
template <std::size_t N>
std::size_t text_bytes(const char (&text)[N]) {
  return 4 + strnlen(text, N) + 1;
}

template <class W>
std::size_t payload(const W& w) {
  std::size_t bytes = sizeof w;
  const auto text = [&bytes](const auto& field) { bytes = bytes - sizeof field + text_bytes(field); };
  const auto sequence = [&bytes](const auto& field) {
    bytes = bytes - sizeof field + 4 + field._length * sizeof *field._buffer;
  };
  if constexpr (requires { w.session; }) text(w.session);
  if constexpr (requires { w.scene; }) text(w.scene);
  if constexpr (requires { w.name; }) text(w.name);
  if constexpr (requires { w.description; }) text(w.description);
  if constexpr (requires { w.devices; }) text(w.devices);
  if constexpr (requires { w.reason; }) text(w.reason);
  if constexpr (requires { w.degraded; }) text(w.degraded);
  if constexpr (requires { w.method; }) text(w.method);
  if constexpr (requires { w.bytes; }) sequence(w.bytes);
  if constexpr (requires { w.packed; }) sequence(w.packed);
  if constexpr (requires { w.positions; }) sequence(w.positions);
  if constexpr (requires { w.holders; }) sequence(w.holders);
  if constexpr (requires { w.points._length; }) {
    sequence(w.points);
    sequence(w.vertices);
    sequence(w.triangles);
  }
  if constexpr (requires { w.bodies; }) {
    bytes -= sizeof w.bodies + sizeof w.lights - 8;
    for (std::size_t i = 0; i < w.bodies._length; ++i) bytes += payload(w.bodies._buffer[i]);
    for (std::size_t i = 0; i < w.lights._length; ++i) bytes += payload(w.lights._buffer[i]);
  }
  return bytes;
}

template <class M, class W>
WireCodec codec(const dds_topic_descriptor& descriptor) {
  return {
      &descriptor,
      [](const Message& message, WireArena& arena, void*& sample) -> Refusal {
        M m = std::get<M>(message);
        sample = nullptr;
        if (const Refusal refusal = check(m)) return refusal;
        W* w = arena.make<W>(1);
        to_wire(m, *w, arena);
        sample = w;
        return nullptr;
      },
      [](const void* sample, Message& message) -> Refusal {
        M& m = message.emplace<M>();
        if (const Refusal refusal = from_wire(*static_cast<const W*>(sample), m)) return refusal;
        return check(m);
      },
      [](const void* sample, Message& message) {
        M m;
        from_wire(*static_cast<const W*>(sample), m);
        message = key_only(m);
      },
      [](const void* sample) { return payload(*static_cast<const W*>(sample)); },
  };
}

}  // namespace

const WireCodec& wire_codec(std::size_t topic) {
#define PROSECTOR_CODEC(M) codec<M, prosector_##M>(prosector_##M##_desc)
  static const std::array<WireCodec, topic_count> codecs{
      PROSECTOR_CODEC(SessionInfo),      PROSECTOR_CODEC(Presence),      PROSECTOR_CODEC(RosterEntry),
      PROSECTOR_CODEC(HandInput),        PROSECTOR_CODEC(UserState),     PROSECTOR_CODEC(Command),
      PROSECTOR_CODEC(CommandResult),    PROSECTOR_CODEC(SceneInfo),     PROSECTOR_CODEC(AssetChunk),
      PROSECTOR_CODEC(RigidState),       PROSECTOR_CODEC(SoftState),     PROSECTOR_CODEC(Settled),
      PROSECTOR_CODEC(TopologyRevision), PROSECTOR_CODEC(ContactSample), PROSECTOR_CODEC(ServerStatus),
      PROSECTOR_CODEC(BodyStatus),       PROSECTOR_CODEC(PartState),     PROSECTOR_CODEC(Panel),
      PROSECTOR_CODEC(RoomState)};
#undef PROSECTOR_CODEC
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
