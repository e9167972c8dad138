#include "idl/topics.h"

#include "common/assert.h"

namespace prosector {

bool writes(BusEnd end, bool arm, const TopicSpec& topic) {
  if (topic.for_arms && !arm) return false;
  switch (topic.writers) {
    case Writers::server:
      return end == BusEnd::server;
    case Writers::clients:
      return end != BusEnd::server;
  }
  return false;
}

bool reads(BusEnd end, bool arm, const TopicSpec& topic) {
  return (arm || !topic.for_arms) && (end == BusEnd::server) != (topic.writers == Writers::server);
}

InstanceKey instance_key(const Message& message) {
  PROSECTOR_ASSERT(message.index() < topic_count);
  return topics[message.index()].instance.key(message);
}

std::size_t lane(const Message& message) {
  const auto& [first, second, third] = instance_key(message);
  return (first + second + third) % topics[message.index()].lanes;
}

Message key_only(const Message& message) {
  PROSECTOR_ASSERT(message.index() < topic_count);
  return topics[message.index()].instance.key_only(message);
}

}  // namespace prosector
