#pragma once
// Every topic in one table: who writes it, its quality of service, its limits. docs/look-up/topics.md says
// the same for people. A row's place is the message's index in the Message variant.

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "idl/bus.h"

namespace prosector {

enum class Writers : std::uint8_t { server, clients };  // clients: observers too, who may become dissectors

/// Best-effort readers drop what was overtaken by a later sample of the same *writer*, whatever the instance.
/// So streams that send many instances at once have several writers, and an instance always takes the same
/// one.
struct TopicSpec {
  const char* name;
  Writers writers;
  bool reliable;            // else best effort: never blocks, a lost sample stays lost
  bool kept_for_late;       // transient-local: whoever joins later gets the last `depth` of each instance
  std::uint32_t depth;      // samples kept an instance (keep last); 0: keep all
  double lease;             // s: liveliness of the writer; 0: that of its participant
  bool announces_gone;      // readers hear of an instance's end
  bool needs_reader;        // publish() fails while nobody would get the sample
  double rate, burst;       // samples/s and at once that one writer may send; 0: not limited
  std::uint32_t lanes = 1;  // writers that share the instances
};

inline constexpr std::size_t topic_count = std::variant_size_v<Message>;
extern const std::array<TopicSpec, topic_count> topics;

bool writes(BusEnd end, const TopicSpec& topic);
bool reads(BusEnd end, const TopicSpec& topic);

/// Identifies an instance of a topic: what the @key fields of prosector.idl say.
using InstanceKey = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>;
InstanceKey instance_key(const Message& message);
/// Returns which of the topic's writers sends this message.
std::size_t lane(const Message& message);
/// Returns the message with only its key fields set.
Message key_only(const Message& message);

}  // namespace prosector
