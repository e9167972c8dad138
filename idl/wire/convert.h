#pragma once
// Conversions between wire structs and messages, one pair per topic, grouped in *_wire.cpp. For idl/wire
// only: idlc generates the structs from prosector.idl.

#include "common/body_messages.h"
#include "common/commands.h"
#include "common/hand_messages.h"
#include "common/part_messages.h"
#include "common/recording_messages.h"
#include "common/scene_messages.h"
#include "common/session_messages.h"
#include "common/status_messages.h"
#include "idl/wire/arena.h"
#include "idl/wire/checks.h"
#include "prosector.h"

namespace prosector {

/// Wire form of message type M: the generated struct, its DDS descriptor, and the topic's name.
template <class M>
struct Wire;

// Declares the wire form of a message and its functions. Functions and struct have the message's name, so
// they can't be mixed up. wire_codec() doesn't compile until each message of Message has a line here.
//   to_wire()    requires a message that passed check()
//   from_wire()  refuses content that can't be stored in a message (lengths, null sequences)
//   check()      does all other checks, before sending and after receiving; re-normalises poses in place
#define PROSECTOR_WIRE(M)                                                              \
  void to_wire(const M& m, prosector_##M& w, WireArena& arena);                        \
  Refusal from_wire(const prosector_##M& w, M& m);                                     \
  Refusal check(M& m);                                                                 \
  template <>                                                                          \
  struct Wire<M> {                                                                     \
    using Struct = prosector_##M;                                                      \
    static constexpr const char* name = #M;                                            \
    static constexpr const dds_topic_descriptor_t* descriptor = &prosector_##M##_desc; \
  }

PROSECTOR_WIRE(SessionInfo);
PROSECTOR_WIRE(Presence);
PROSECTOR_WIRE(RosterEntry);
PROSECTOR_WIRE(HandInput);
PROSECTOR_WIRE(UserState);
PROSECTOR_WIRE(Command);
PROSECTOR_WIRE(CommandResult);
PROSECTOR_WIRE(SceneInfo);
PROSECTOR_WIRE(AssetChunk);
PROSECTOR_WIRE(RigidState);
PROSECTOR_WIRE(SoftState);
PROSECTOR_WIRE(Settled);
PROSECTOR_WIRE(TopologyRevision);
PROSECTOR_WIRE(ContactSample);
PROSECTOR_WIRE(ServerStatus);
PROSECTOR_WIRE(BodyStatus);
PROSECTOR_WIRE(PartState);
PROSECTOR_WIRE(Panel);
PROSECTOR_WIRE(RoomState);
PROSECTOR_WIRE(Recording);
PROSECTOR_WIRE(FeltPlanes);
PROSECTOR_WIRE(ArmForce);

#undef PROSECTOR_WIRE

}  // namespace prosector
