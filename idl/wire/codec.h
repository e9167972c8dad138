#pragma once
// The edge as one table: for each topic, from message to wire struct and back with all checks.

#include "idl/topics.h"
#include "idl/wire/arena.h"
#include "idl/wire/checks.h"
#include "idl/wire/serialised_bytes.h"

namespace prosector {

struct WireCodec {
  const dds_topic_descriptor* descriptor;
  /// Checks and converts; the sample lives as long as the arena. Null `sample` with a refusal.
  Refusal (*encode)(const Message& message, WireArena& arena, void*& sample);
  /// Converts and checks a whole sample.
  Refusal (*decode)(const void* sample, Message& message);
  /// Reads the key fields only, for news of an instance whose other fields are unset.
  void (*decode_key)(const void* sample, Message& message);

  std::size_t payload_bytes(const void* sample) const { return serialised_bytes(*descriptor, sample); }
};

/// Returns the codec of `topic`, an index in the Message variant.
const WireCodec& wire_codec(std::size_t topic);

/// Encodes, then decodes: `received` is what receiving makes of a sent message, without a network.
Refusal through_the_wire(const Message& message, Message& received, std::size_t& payload_bytes);

}  // namespace prosector
