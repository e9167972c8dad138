#pragma once
// Every topic in one table: its message and key, who writes it, its quality of service, its limits.
// docs/look-up/topics.md says the same for people. A message's place in the Message variant is its topic's
// index, here and in idl/wire; what is missing or out of order doesn't compile.

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "idl/bus.h"
#include "idl/instance.h"

namespace prosector {

enum class Writers : std::uint8_t { server, clients };  // clients: observers too, who may become dissectors

/// Best-effort readers drop what was overtaken by a later sample of the same *writer*, whatever the instance.
/// So streams that send many instances at once have several writers, and an instance always takes the same
/// one.
struct TopicSpec {
  const char* name;
  Writers writers;
  bool reliable;        // else best effort: never blocks, a lost sample stays lost
  bool kept_for_late;   // transient-local: whoever joins later gets the last `depth` of each instance
  std::uint32_t depth;  // samples kept an instance (keep last); 0: keep all
  double lease;         // s: liveliness of the writer; 0: that of its participant
  bool announces_gone;  // readers hear of an instance's end
  bool needs_reader;    // publish() fails while nobody would get the sample
  double rate, burst;   // samples/s and at once that one writer may send; 0: not limited
  std::uint32_t lanes;  // writers that share the instances
  bool for_arms;        // there is neither writer nor reader before somebody has a haptic arm
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
  // A command that nobody hears is not sent, so that a server which starts later never obeys a stale one.
  {"Command",           Writers::clients,  true,    false,    0, 0,   false, true,   50, 50,   1, false, keyed<Command, &Command::participant>},
  // Results stay a while: the writer never blocks on a stopped client, and none is lost while ends still match.
  {"CommandResult",     Writers::server,   true,    true,    32, 0,   false, false,   0,  0,   1, false, keyed<CommandResult, &CommandResult::participant>},
  {"SceneInfo",         Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<SceneInfo>},
  {"AssetChunk",        Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<AssetChunk, &AssetChunk::hash, &AssetChunk::chunk>},
  {"RigidState",        Writers::server,   false,   false,    1, 0,   false, false,   0,  0,  16, false, keyed<RigidState, &RigidState::body>},
  {"SoftState",         Writers::server,   false,   false,    1, 0,   false, false,   0,  0,  32, false, keyed<SoftState, &SoftState::body, &SoftState::chunk>},
  {"Settled",           Writers::server,   true,    true,     1, 0,   false, false,   0,  0,   1, false, keyed<Settled, &Settled::body>},
  // Each revision is an instance. Not keep-all: one stopped reader would make each write block and drop it.
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

/// Tells whether every topic obeys a rule.
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

/// Tells whether an end writes or reads the topic, ever. Topics for arms: if `arm` says that it has one, or,
/// of a server, that somebody has.
bool writes(BusEnd end, bool arm, const TopicSpec& topic);
bool reads(BusEnd end, bool arm, const TopicSpec& topic);

/// Identifies an instance of a topic: what the @key fields of prosector.idl say.
InstanceKey instance_key(const Message& message);
/// Returns which of the topic's writers sends this message.
std::size_t lane(const Message& message);
/// Returns the message with only its key fields set.
Message key_only(const Message& message);

}  // namespace prosector
