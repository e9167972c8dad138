#pragma once
// Table of all topics: message and key, writer, quality of service, limits. docs/look-up/topics.md describes
// it for users. A message's index in the Message variant is its topic's index, here and in idl/wire; a
// missing or misplaced row doesn't compile.

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "idl/bus.h"
#include "idl/instance.h"

namespace prosector {

enum class Writers : std::uint8_t { server, clients };  // clients: observers may become dissectors

/// Properties of a DDS topic: its message, key, writers, quality of service and limits. Best-effort readers
/// drop a sample if a later one of the same *writer* has arrived, whatever the instance. Streams with many
/// instances per tick therefore use several writers (lanes), and each instance always uses the same one.
struct TopicSpec {
  const char* name;
  Writers writers;
  bool reliable;         // false: best effort, never blocks, a lost sample isn't repeated
  bool transient_local;  // transient-local: late joiners receive the last `depth` samples of each instance
  std::uint32_t depth;   // samples stored per instance (keep last); 0: keep all
  double lease;          // s: liveliness lease of the writer; 0: that of its participant
  bool notifies_end;     // readers are notified when an instance ends
  bool requires_reader;  // publish() fails without a reader
  double rate, burst;    // limit per writer: samples/s, and samples in a burst; 0: unlimited
  std::uint32_t lanes;   // number of writers that share the instances
  bool for_arms;         // writers and readers are created only after a participant with a haptic arm joins
  InstanceRules instance;
};

inline constexpr std::size_t topic_count = std::variant_size_v<Message>;

// clang-format off
inline constexpr std::array<TopicSpec, topic_count> topics{{
  //                    writers            reliable  late  depth lease gone  reader rate burst lanes arms  message and its key
  {"SessionInfo",       Writers::server,   true,    true,     1, 0,   true,  false,   0,  0,   1, false, keyed<SessionInfo, &SessionInfo::session, &SessionInfo::server_run>},
  {"Presence",          Writers::clients,  true,    true,     1, 1,   true,  false,   5, 10,   1, false, keyed<Presence, &Presence::participant>},
  {"RosterEntry",       Writers::server,   true,    true,     1, 0,   true,  false,   0,  0,   1, false, keyed<RosterEntry, &RosterEntry::participant>},
  {"HandInput",         Writers::clients,  false,   false,    1, 0,   false, false, 400, 40,   1, false, keyed<HandInput, &HandInput::participant>},
  {"UserState",         Writers::server,   false,   false,    1, 0,   false, false,   0,  0,   8, false, keyed<UserState, &UserState::participant>},
  // A command without a reader isn't sent, so that a server that starts later never executes a stale one.
  {"Command",           Writers::clients,  true,    false,    0, 0,   false, true,   50, 50,   1, false, keyed<Command, &Command::participant>},
  // Results are stored, so that the writer never blocks on a stopped client and none is lost while ends are
  // still matching.
  {"CommandResult",     Writers::server,   true,    true,    32, 0,   false, false,   0,  0,   1, false, keyed<CommandResult, &CommandResult::participant>},
  {"SceneInfo",         Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<SceneInfo>},
  {"AssetChunk",        Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<AssetChunk, &AssetChunk::hash, &AssetChunk::chunk>},
  {"RigidState",        Writers::server,   false,   false,    1, 0,   false, false,   0,  0,  16, false, keyed<RigidState, &RigidState::body>},
  {"SoftState",         Writers::server,   false,   false,    1, 0,   false, false,   0,  0,  32, false, keyed<SoftState, &SoftState::body, &SoftState::chunk>},
  {"Settled",           Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<Settled, &Settled::body>},
  // Each revision is an instance. Not keep-all: one stopped reader would make each write block and then fail.
  {"TopologyRevision",  Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<TopologyRevision, &TopologyRevision::body, &TopologyRevision::revision>},
  {"ContactSample",     Writers::server,   false,   false,    1, 0,   false, false,   0,  0,   8, false, keyed<ContactSample, &ContactSample::participant, &ContactSample::hand>},
  {"ServerStatus",      Writers::server,   false,   false,    1, 0,   false, false,   0,  0,   1, false, keyed<ServerStatus>},
  {"BodyStatus",        Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<BodyStatus, &BodyStatus::body>},
  {"PartState",         Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<PartState, &PartState::body>},
  {"Panel",             Writers::server,   true,    true,     1, 0,   true,  false,   0,  0,   1, false, keyed<Panel, &Panel::participant>},
  {"RoomState",         Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<RoomState>},
  {"Recording",         Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<Recording>},
  {"FeltPlanes",        Writers::server,   false,   false,    1, 0,   false, false,   0,  0,   1, true,  keyed<FeltPlanes, &FeltPlanes::participant, &FeltPlanes::hand>},
  {"ArmForce",          Writers::clients,  false,   false,    1, 0,   false, false, 800, 80,   1, true,  keyed<ArmForce, &ArmForce::participant, &ArmForce::hand>},
}};
// clang-format on

/// Returns whether rule(index, topic) is true for all topics of the table.
template <class Rule>
constexpr bool all_topics(Rule rule) {
  for (std::size_t i = 0; i < topic_count; ++i)
    if (!rule(i, topics[i])) return false;
  return true;
}
static_assert(all_topics([](std::size_t i, const TopicSpec& t) { return t.name && t.instance.message == i; }),
              "topics: a row for each message of Message, in its order");
static_assert(all_topics([](std::size_t, const TopicSpec& t) { return t.lanes > 0; }),
              "topics: somebody must write");
static_assert(all_topics([](std::size_t, const TopicSpec& t) { return t.reliable || t.depth == 1; }),
              "topics: of what may be lost the newest counts");
static_assert(all_topics([](std::size_t, const TopicSpec& t) {
                return t.writers == Writers::server || (t.rate > 0 && t.burst >= 1);
              }),
              "topics: what clients write is limited");

/// Returns whether an end (server, dissector or observer) ever writes the topic; reads() returns whether it
/// reads the topic. Topics for haptic arms are used only with `arm`: a client has a haptic arm, or, for a
/// server, any participant has one.
bool writes(BusEnd end, bool arm, const TopicSpec& topic);
bool reads(BusEnd end, bool arm, const TopicSpec& topic);

/// Returns the values of the message's key fields (@key in prosector.idl), which identify its DDS instance
/// within the topic.
InstanceKey instance_key(const Message& message);
/// Returns the index of the lane (one of the topic's writers) that sends this message. All messages of one
/// DDS instance use the same lane.
std::size_t lane(const Message& message);
/// Returns a message in which only the key fields of `message` are set.
Message key_only(const Message& message);

}  // namespace prosector
