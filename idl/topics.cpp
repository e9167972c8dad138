#include "idl/topics.h"

#include <functional>

namespace prosector {

// clang-format off
const std::array<TopicSpec, topic_count> topics{{
  //                    writers               reliable late   depth lease gone   reader  rate burst lanes
  {"SessionInfo",       Writers::server,      true,    true,      1, 0,   true,  false,    0,  0},
  {"Presence",          Writers::clients,     true,    true,      1, 1,   true,  false,    5, 10},
  {"RosterEntry",       Writers::server,      true,    true,      1, 0,   true,  false,    0,  0},
  {"HandInput",         Writers::clients,     false,   false,     1, 0,   false, false,  400, 40},
  {"UserState",         Writers::server,      false,   false,     1, 0,   false, false,    0,  0,    8},
  // A command that nobody hears is not sent, so that a server which starts later never obeys a stale one.
  {"Command",           Writers::clients,     true,    false,     0, 0,   false, true,    50, 50},
  // Results stay a while: the writer never blocks on a stopped client, and none is lost while ends still match.
  {"CommandResult",     Writers::server,      true,    true,     32, 0,   false, false,    0,  0},
  {"SceneInfo",         Writers::server,      true,    true,      1, 0,   false, false,    0,  0},
  {"AssetChunk",        Writers::server,      true,    true,      1, 0,   false, false,    0,  0},
  {"RigidState",        Writers::server,      false,   false,     1, 0,   false, false,    0,  0,    16},
  {"SoftState",         Writers::server,      false,   false,     1, 0,   false, false,    0,  0,    32},
  {"Settled",           Writers::server,      true,    true,      1, 0,   false, false,    0,  0},
  // Each revision is an instance. Not keep-all: one stopped reader would make each write block and drop it.
  {"TopologyRevision",  Writers::server,      true,    true,      1, 0,   false, false,    0,  0},
  {"ContactSample",     Writers::server,      false,   false,     1, 0,   false, false,    0,  0,    8},
  {"ServerStatus",      Writers::server,      false,   false,     1, 0,   false, false,    0,  0},
  {"BodyStatus",        Writers::server,      true,    true,      1, 0,   false, false,    0,  0},
  {"PartState",         Writers::server,      true,    true,      1, 0,   false, false,    0,  0},
  {"Panel",             Writers::server,      true,    true,      1, 0,   true,  false,    0,  0},
  {"RoomState",         Writers::server,      true,    true,      1, 0,   false, false,    0,  0},
}};
// clang-format on

bool writes(BusEnd end, const TopicSpec& topic) {
  switch (topic.writers) {
    case Writers::server:
      return end == BusEnd::server;
    case Writers::clients:
      return end != BusEnd::server;
  }
  return false;
}

bool reads(BusEnd end, const TopicSpec& topic) {
  return (end == BusEnd::server) != (topic.writers == Writers::server);
}

namespace {

std::uint64_t word(const ContentHash& hash, std::size_t first) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) value = value << 8 | hash[first + i];
  return value;
}

struct KeyOf {
  InstanceKey operator()(const SessionInfo& m) const {
    return {std::hash<std::string>()(m.session), m.server_run, 0};
  }
  InstanceKey operator()(const AssetChunk& m) const { return {word(m.hash, 0), word(m.hash, 8), m.chunk}; }
  InstanceKey operator()(const SoftState& m) const { return {m.body, m.chunk, 0}; }
  InstanceKey operator()(const ContactSample& m) const { return {m.participant, m.hand, 0}; }
  InstanceKey operator()(const SceneInfo&) const { return {}; }
  InstanceKey operator()(const ServerStatus&) const { return {}; }
  InstanceKey operator()(const RoomState&) const { return {}; }
  template <class M>
  requires requires(M m) { m.participant; }
  InstanceKey operator()(const M& m) const { return {m.participant, 0, 0}; }
  InstanceKey operator()(const Settled& m) const { return {m.body, 0, 0}; }
  InstanceKey operator()(const TopologyRevision& m) const { return {m.body, m.revision, 0}; }
  InstanceKey operator()(const RigidState& m) const { return {m.body, 0, 0}; }
  InstanceKey operator()(const BodyStatus& m) const { return {m.body, 0, 0}; }
  InstanceKey operator()(const PartState& m) const { return {m.body, 0, 0}; }
};

struct KeyOnly {
  Message operator()(const SessionInfo& m) const {
    SessionInfo key;
    key.session = m.session;
    key.server_run = m.server_run;
    return key;
  }
  Message operator()(const AssetChunk& m) const {
    AssetChunk key;
    key.hash = m.hash;
    key.chunk = m.chunk;
    return key;
  }
  template <class M>
  Message operator()(const M& m) const {
    M key;
    if constexpr (requires { m.participant; }) key.participant = m.participant;
    if constexpr (requires { m.participant, m.hand, m.touching; }) key.hand = m.hand;
    if constexpr (
        requires { m.body, m.time; } && !requires { m.participant; })
      key.body = m.body;
    if constexpr (requires { m.body, m.chunk; }) key.chunk = m.chunk;
    if constexpr (std::is_same_v<M, TopologyRevision>) key.revision = m.revision;
    return key;
  }
};

}  // namespace

InstanceKey instance_key(const Message& message) {
  return std::visit(KeyOf(), message);
}

std::size_t lane(const Message& message) {
  const auto& [first, second, third] = instance_key(message);
  return (first + second + third) % topics[message.index()].lanes;
}

Message key_only(const Message& message) {
  return std::visit(KeyOnly(), message);
}

}  // namespace prosector
