#pragma once
// Wire struct ↔ message, one pair a topic, grouped by family in *_wire.cpp. Included by idl/wire only: the
// structs are what idlc made of prosector.idl.
//
// to_wire() expects a message that passed check(). from_wire() refuses what can't be put into a message at
// all (lengths, null sequences); check() does the rest.

#include "idl/wire/arena.h"
#include "idl/wire/checks.h"
#include "prosector.h"

namespace prosector {

void to_wire(const SessionInfo& m, prosector_SessionInfo& w, WireArena& arena);
void to_wire(const Presence& m, prosector_Presence& w, WireArena& arena);
void to_wire(const RosterEntry& m, prosector_RosterEntry& w, WireArena& arena);
void to_wire(const HandInput& m, prosector_HandInput& w, WireArena& arena);
void to_wire(const UserState& m, prosector_UserState& w, WireArena& arena);
void to_wire(const Command& m, prosector_Command& w, WireArena& arena);
void to_wire(const CommandResult& m, prosector_CommandResult& w, WireArena& arena);
void to_wire(const SceneInfo& m, prosector_SceneInfo& w, WireArena& arena);
void to_wire(const AssetChunk& m, prosector_AssetChunk& w, WireArena& arena);
void to_wire(const RigidState& m, prosector_RigidState& w, WireArena& arena);
void to_wire(const SoftState& m, prosector_SoftState& w, WireArena& arena);
void to_wire(const Settled& m, prosector_Settled& w, WireArena& arena);
void to_wire(const TopologyRevision& m, prosector_TopologyRevision& w, WireArena& arena);
void to_wire(const ContactSample& m, prosector_ContactSample& w, WireArena& arena);
void to_wire(const ServerStatus& m, prosector_ServerStatus& w, WireArena& arena);
void to_wire(const BodyStatus& m, prosector_BodyStatus& w, WireArena& arena);
void to_wire(const PartState& m, prosector_PartState& w, WireArena& arena);
void to_wire(const Panel& m, prosector_Panel& w, WireArena& arena);
void to_wire(const RoomState& m, prosector_RoomState& w, WireArena& arena);

Refusal from_wire(const prosector_SessionInfo& w, SessionInfo& m);
Refusal from_wire(const prosector_Presence& w, Presence& m);
Refusal from_wire(const prosector_RosterEntry& w, RosterEntry& m);
Refusal from_wire(const prosector_HandInput& w, HandInput& m);
Refusal from_wire(const prosector_UserState& w, UserState& m);
Refusal from_wire(const prosector_Command& w, Command& m);
Refusal from_wire(const prosector_CommandResult& w, CommandResult& m);
Refusal from_wire(const prosector_SceneInfo& w, SceneInfo& m);
Refusal from_wire(const prosector_AssetChunk& w, AssetChunk& m);
Refusal from_wire(const prosector_RigidState& w, RigidState& m);
Refusal from_wire(const prosector_SoftState& w, SoftState& m);
Refusal from_wire(const prosector_Settled& w, Settled& m);
Refusal from_wire(const prosector_TopologyRevision& w, TopologyRevision& m);
Refusal from_wire(const prosector_ContactSample& w, ContactSample& m);
Refusal from_wire(const prosector_ServerStatus& w, ServerStatus& m);
Refusal from_wire(const prosector_BodyStatus& w, BodyStatus& m);
Refusal from_wire(const prosector_PartState& w, PartState& m);
Refusal from_wire(const prosector_Panel& w, Panel& m);
Refusal from_wire(const prosector_RoomState& w, RoomState& m);

}  // namespace prosector
