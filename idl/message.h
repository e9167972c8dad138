#pragma once
// The message that a Bus carries. `idl/` turns each kind into its wire form and back with all checks; nothing
// else knows DDS. Directions and QoS: docs/look-up/topics.md.

#include <variant>

#include "common/body_messages.h"
#include "common/commands.h"
#include "common/hand_messages.h"
#include "common/part_messages.h"
#include "common/recording_messages.h"
#include "common/scene_messages.h"
#include "common/session_messages.h"
#include "common/status_messages.h"

namespace prosector {

/// Any message that a Bus publishes or receives. A message's index in this variant is its topic's index
/// (idl/topics.h).
using Message =
    std::variant<SessionInfo, Presence, RosterEntry, HandInput, UserState, Command, CommandResult, SceneInfo,
                 AssetChunk, RigidState, SoftState, Settled, TopologyRevision, ContactSample, ServerStatus,
                 BodyStatus, PartState, Panel, RoomState, Recording, FeltPlanes, ArmForce>;

}  // namespace prosector
