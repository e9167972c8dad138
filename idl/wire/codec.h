#pragma once
// Table of wire codecs: for each topic, conversion between message and wire struct with all checks.

#include "idl/topics.h"
#include "idl/wire/arena.h"
#include "idl/wire/checks.h"
#include "idl/wire/serialised_bytes.h"

namespace prosector {

struct WireCodec {
  const dds_topic_descriptor* descriptor;
  /// Checks and converts a message; `sample` lives as long as the arena and is null after a refusal.
  Refusal (*encode)(const Message& message, WireArena& arena, void*& sample);
  /// Converts and checks a whole sample.
  Refusal (*decode)(const void* sample, Message& message);
  /// Reads the key fields only, for notifications of an ended instance, whose other fields are unset.
  void (*decode_key)(const void* sample, Message& message);

  std::size_t payload_bytes(const void* sample) const { return serialised_bytes(*descriptor, sample); }
};

/// Returns the codec of `topic`, an index in the Message variant.
const WireCodec& wire_codec(std::size_t topic);

/// Encodes and decodes a message without a network: `received` is the message that a receiver would get.
Refusal through_the_wire(const Message& message, Message& received, std::size_t& payload_bytes);

}  // namespace prosector
