#pragma once
// Table of wire codecs: for each topic, conversion between message and wire struct with all checks.

#include "idl/topics.h"
#include "idl/wire/arena.h"
#include "idl/wire/checks.h"
#include "idl/wire/serialised_bytes.h"

namespace prosector {

struct WireCodec {
  const dds_topic_descriptor* descriptor;
  /// Checks a message and converts it to its wire struct. `sample` points to that struct, which exists as
  /// long as the arena; null after a refusal. Returns the reason of a refusal.
  Refusal (*encode)(const Message& message, WireArena& arena, void*& sample);
  /// Converts a received wire struct to a message and checks all its fields. Returns the reason if a check
  /// fails.
  Refusal (*decode)(const void* sample, Message& message);
  /// Reads only the key fields of a wire struct into `message`. It is used for notifications of an ended
  /// instance, whose other fields are unset.
  void (*decode_key)(const void* sample, Message& message);

  std::size_t payload_bytes(const void* sample) const { return serialised_bytes(*descriptor, sample); }
};

/// Returns the wire codec (conversions and checks) of `topic`, an index in the Message variant.
const WireCodec& wire_codec(std::size_t topic);

/// Encodes and decodes a message without a network. `received` is set to the message that a receiver would
/// get, and `payload_bytes` to its serialised size. Returns the reason if a check refuses the message.
Refusal through_the_wire(const Message& message, Message& received, std::size_t& payload_bytes);

}  // namespace prosector
