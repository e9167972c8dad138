// Every message through the wire and back, and everything that the edge must refuse.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "idl/wire/codec.h"
#include "idl/wire/convert.h"
#include "tests/idl/samples.h"
#include "tests/idl/wire_bytes.h"

namespace prosector {
namespace {

using test::as_wire_bytes;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a round trip makes of a message; fails the test when it is refused.
Message round_trip(const Message& message) {
  Message received;
  std::size_t bytes = 0;
  const Refusal refusal = through_the_wire(message, received, bytes);
  EXPECT_FALSE(refusal) << topics[message.index()].name << ": " << refusal.why();
  EXPECT_GT(bytes, 0u);
  return received;
}

TEST(Wire, EveryMessageComesBackEqual) {
  for (const Message& message : sample_messages()) {
    const Message received = round_trip(message);
    ASSERT_EQ(received.index(), message.index());
    EXPECT_EQ(instance_key(received), instance_key(message)) << topics[message.index()].name;
    if (std::holds_alternative<SoftState>(message)) continue;  // quantised: soft_quantizer_test
    EXPECT_EQ(as_wire_bytes(received), as_wire_bytes(message)) << topics[message.index()].name;
  }
}

TEST(Wire, FieldsKeepTheirMeaning) {
  const auto scene = std::get<SceneInfo>(round_trip(sample_messages()[7]));
  EXPECT_EQ(scene.bodies[1].description, "Größte Drüse");
  EXPECT_EQ(scene.bodies[1].parent, 0);
  EXPECT_EQ(scene.bodies[1].map[1], 8);
  EXPECT_EQ(scene.lights[0].kind, LightKind::spot);
  const auto input = std::get<HandInput>(round_trip(sample_messages()[3]));
  EXPECT_EQ(input.hands[1].pose.q.z(), 0.5);
  EXPECT_EQ(input.hands[1].flexion[3], 0.75);
  EXPECT_EQ(input.sequence, 12u);
  const auto contact = std::get<ContactSample>(round_trip(sample_messages()[13]));
  EXPECT_EQ(contact.depth, 0.0078125);
  const auto settled = std::get<Settled>(round_trip(sample_messages()[11]));
  EXPECT_EQ(settled.positions, std::get<Settled>(sample_messages()[11]).positions);
}

TEST(Wire, EveryGestureComesBackByItsNumber) {
  auto input = std::get<HandInput>(sample_messages()[3]);
  for (int number = 0; number <= 11; ++number) {
    input.hands[right_hand].gesture = static_cast<Gesture>(number);
    EXPECT_EQ(std::get<HandInput>(round_trip(input)).hands[right_hand].gesture, static_cast<Gesture>(number));
  }
  EXPECT_EQ(static_cast<int>(Gesture::pinch), 8) << "as it was before thumbs counted";
}

TEST(Wire, KeyOnlyKeepsTheKey) {
  for (const Message& message : sample_messages()) {
    const Message key = key_only(message);
    EXPECT_EQ(key.index(), message.index());
    EXPECT_EQ(instance_key(key), instance_key(message)) << topics[message.index()].name;
  }
}

TEST(Wire, NearlyUnitQuaternionsAreNormalised) {
  RigidState m = std::get<RigidState>(sample_messages()[9]);
  m.pose.q.coeffs() *= 1.005;
  const auto received = std::get<RigidState>(round_trip(m));
  EXPECT_NEAR(received.pose.q.norm(), 1, 1e-7);
}

// A change to a valid message that the edge must refuse.
struct Spoiled {
  const char* what;
  Message message;
};

template <class M>
Spoiled spoiled(const char* what, void (*spoil)(M&)) {
  for (const Message& message : sample_messages()) {
    if (!std::holds_alternative<M>(message)) continue;
    M m = std::get<M>(message);
    spoil(m);
    return {what, m};
  }
  return {what, {}};
}

std::vector<Spoiled> spoiled_messages() {
  return {
      spoiled<SessionInfo>("empty session", [](SessionInfo& m) { m.session.clear(); }),
      spoiled<SessionInfo>("long session", [](SessionInfo& m) { m.session.assign(64, 'x'); }),
      spoiled<SessionInfo>("tick rate 0", [](SessionInfo& m) { m.tick_rate = 0; }),
      spoiled<SessionInfo>("tick rate NaN", [](SessionInfo& m) { m.tick_rate = nan; }),
      spoiled<Presence>("nobody", [](Presence& m) { m.participant = 0; }),
      spoiled<Presence>("empty name", [](Presence& m) { m.name.clear(); }),
      spoiled<Presence>("control character", [](Presence& m) { m.name = "a\x1b[2J"; }),
      spoiled<Presence>("C1 control", [](Presence& m) { m.name = "a\xc2\x9b"; }),
      spoiled<Presence>("stray continuation", [](Presence& m) { m.name = "\x80"; }),
      spoiled<Presence>("overlong form", [](Presence& m) { m.name = "\xc0\xaf"; }),
      spoiled<Presence>("overlong of three", [](Presence& m) { m.name = "\xe0\x80\xaf"; }),
      spoiled<Presence>("surrogate", [](Presence& m) { m.name = "\xed\xa0\x80"; }),
      spoiled<Presence>("past Unicode", [](Presence& m) { m.name = "\xf4\x90\x80\x80"; }),
      spoiled<Presence>("cut short", [](Presence& m) { m.name = "a\xe2\x82"; }),
      spoiled<Presence>("unknown role", [](Presence& m) { m.role = static_cast<Role>(3); }),
      spoiled<Presence>("long devices", [](Presence& m) { m.devices.assign(1024, 'x'); }),
      spoiled<RosterEntry>("colour", [](RosterEntry& m) { m.color.x() = 1.5; }),
      spoiled<RosterEntry>("colour NaN", [](RosterEntry& m) { m.color.y() = nan; }),
      spoiled<HandInput>("nobody", [](HandInput& m) { m.participant = 0; }),
      spoiled<HandInput>("NaN position", [](HandInput& m) { m.hands[0].pose.p.x() = nan; }),
      spoiled<HandInput>("infinite head", [](HandInput& m) { m.head.p.z() = infinity; }),
      spoiled<HandInput>("far away", [](HandInput& m) { m.hands[1].pose.p.y() = 1e6; }),
      spoiled<HandInput>("tablet far away", [](HandInput& m) { m.held[0].pose.p.x() = -1e6; }),
      spoiled<HandInput>("stylus unturned", [](HandInput& m) { m.held[1].pose.q.coeffs().setZero(); }),
      spoiled<HandInput>("quaternion 0", [](HandInput& m) { m.hands[0].pose.q.coeffs().setZero(); }),
      spoiled<HandInput>("quaternion 2", [](HandInput& m) { m.hands[0].pose.q.coeffs() *= 2; }),
      spoiled<HandInput>("quaternion NaN", [](HandInput& m) { m.head.q.w() = nan; }),
      spoiled<HandInput>("flexion 2", [](HandInput& m) { m.hands[0].flexion[2] = 2; }),
      spoiled<HandInput>("flexion NaN", [](HandInput& m) { m.hands[0].flexion[4] = nan; }),
      spoiled<HandInput>("gesture", [](HandInput& m) { m.hands[0].gesture = static_cast<Gesture>(200); }),
      spoiled<HandInput>("next gesture", [](HandInput& m) { m.hands[1].gesture = static_cast<Gesture>(12); }),
      spoiled<UserState>("NaN position", [](UserState& m) { m.hands[0].pose.p.x() = nan; }),
      spoiled<Command>("nobody", [](Command& m) { m.participant = 0; }),
      spoiled<Command>("third hand", [](Command& m) { m.body = Grasp{2}; }),
      spoiled<Command>("body", [](Command& m) { m.body = Detach{max_bodies}; }),
      spoiled<Command>("role",
                       [](Command& m) {
                         m.body = SetRole{7, static_cast<Role>(3)};
                       }),
      spoiled<Command>("control",
                       [](Command& m) {
                         m.body = SetControl{static_cast<PanelControl>(6), 0};
                       }),
      spoiled<Command>("value",
                       [](Command& m) {
                         m.body = SetControl{PanelControl::stiffness, 1.5};
                       }),
      spoiled<Command>("pace", [](Command& m) { m.body = SetPace{max_pace + 1}; }),
      spoiled<Command>("accuracy",
                       [](Command& m) {
                         m.body = SetAccuracy{1, max_accuracy + 1};
                       }),
      spoiled<Command>("value NaN", [](Command& m) { m.body = SetPace{nan}; }),
      spoiled<Command>("flattened", [](Command& m) { std::get<Inspect>(m.body).shape.A.row(1).setZero(); }),
      spoiled<Command>("blown up", [](Command& m) { std::get<Inspect>(m.body).shape.A *= 1e9; }),
      spoiled<Command>("shape NaN", [](Command& m) { std::get<Inspect>(m.body).shape.A(2, 1) = nan; }),
      spoiled<Command>("panel far away",
                       [](Command& m) {
                         m.body = OpenPanel{1, PanelPlacement::put, {0, 1e6, 0}};
                       }),
      spoiled<CommandResult>("long reason", [](CommandResult& m) { m.reason.assign(1024, 'x'); }),
      spoiled<SceneInfo>(
          "parent of none",
          [](SceneInfo& m) { m.bodies[0].parent = static_cast<std::int32_t>(m.bodies.size()); }),
      spoiled<SceneInfo>("own parent", [](SceneInfo& m) { m.bodies[0].parent = 0; }),
      spoiled<SceneInfo>("parents in a ring", [](SceneInfo& m) { m.bodies[0].parent = 1; }),
      spoiled<SceneInfo>("parent −2", [](SceneInfo& m) { m.bodies[0].parent = -2; }),
      spoiled<SceneInfo>("too many bodies", [](SceneInfo& m) { m.bodies.resize(max_bodies + 1); }),
      spoiled<SceneInfo>("too many lights", [](SceneInfo& m) { m.lights.resize(max_lights + 1); }),
      spoiled<SceneInfo>("points", [](SceneInfo& m) { m.bodies[1].points = max_streamed_points + 1; }),
      spoiled<SceneInfo>("no points", [](SceneInfo& m) { m.bodies[1].points = 0; }),
      spoiled<SceneInfo>("refracts less than nothing",
                         [](SceneInfo& m) { m.bodies[3].appearance.refractive_index = 0.9; }),
      spoiled<SceneInfo>("refracts NaN", [](SceneInfo& m) { m.bodies[3].appearance.refractive_index = nan; }),
      spoiled<SceneInfo>("Abbe number 0", [](SceneInfo& m) { m.bodies[3].appearance.abbe_number = 0; }),
      spoiled<SceneInfo>("Abbe number NaN", [](SceneInfo& m) { m.bodies[3].appearance.abbe_number = nan; }),
      spoiled<SceneInfo>("glass that shines",
                         [](SceneInfo& m) { m.bodies[3].appearance.transmittance.x() = 1.5; }),
      spoiled<SceneInfo>("chunk of 0", [](SceneInfo& m) { m.bodies[1].chunk_points = 0; }),
      spoiled<SceneInfo>("tube inside out", [](SceneInfo& m) { m.bodies[2].tube_diameter = -1e-3; }),
      spoiled<SceneInfo>("large chunks",
                         [](SceneInfo& m) { m.bodies[1].chunk_points = max_chunk_points + 1; }),
      spoiled<SceneInfo>("light nowhere", [](SceneInfo& m) { m.lights[0].position.x() = nan; }),
      spoiled<SceneInfo>("the direction of a light is zero or out of range",
                         [](SceneInfo& m) { m.lights[0].direction.setZero(); }),
      spoiled<SceneInfo>("field of view", [](SceneInfo& m) { m.camera.fov = 4; }),
      spoiled<SceneInfo>("a patient askew",
                         [](SceneInfo& m) {
                           m.patient = {{1, 0, 0}, {1, 1, 0}};
                         }),
      spoiled<SceneInfo>("a patient without head",
                         [](SceneInfo& m) {
                           m.patient = {{1, 0, 0}, Vec3::Zero()};
                         }),
      spoiled<AssetChunk>("no such chunk", [](AssetChunk& m) { m.chunk = 2; }),
      spoiled<AssetChunk>("wrong count", [](AssetChunk& m) { m.chunks = 3; }),
      spoiled<AssetChunk>("huge", [](AssetChunk& m) { m.total_bytes = 0xffffffff; }),
      spoiled<AssetChunk>("empty", [](AssetChunk& m) { m.total_bytes = 0; }),
      spoiled<AssetChunk>("short", [](AssetChunk& m) { m.bytes.pop_back(); }),
      spoiled<AssetChunk>("long", [](AssetChunk& m) { m.bytes.resize(asset_chunk_bytes + 1); }),
      spoiled<RigidState>("body", [](RigidState& m) { m.body = max_bodies; }),
      spoiled<RigidState>("too fast", [](RigidState& m) { m.linear_velocity.x() = 1e9; }),
      spoiled<RigidState>("spins NaN", [](RigidState& m) { m.angular_velocity.x() = nan; }),
      spoiled<SoftState>("no points", [](SoftState& m) { m.positions = m.velocities = {}; }),
      spoiled<SoftState>("too many", [](SoftState& m) { m.positions.resize(257, Vec3::Zero()); }),
      spoiled<SoftState>("velocity missing", [](SoftState& m) { m.velocities.pop_back(); }),
      spoiled<SoftState>("NaN", [](SoftState& m) { m.positions[50].z() = nan; }),
      spoiled<SoftState>("NaN velocity", [](SoftState& m) { m.velocities[50].z() = nan; }),
      spoiled<SoftState>("far", [](SoftState& m) { m.positions[0].x() = 1e5; }),
      spoiled<SoftState>("range", [](SoftState& m) { m.first_point = 0xffffffff; }),
      spoiled<Settled>("no points", [](Settled& m) { m.positions.clear(); }),
      spoiled<Settled>("NaN", [](Settled& m) { m.positions[600].y() = std::nanf(""); }),
      spoiled<TopologyRevision>("ancestry", [](TopologyRevision& m) { m.revision = 0; }),
      spoiled<TopologyRevision>("cause",
                                [](TopologyRevision& m) { m.cause = static_cast<TopologyCause>(4); }),
      spoiled<TopologyRevision>("piece of −2", [](TopologyRevision& m) { m.piece_of = -2; }),
      spoiled<TopologyRevision>("incomplete keyframe", [](TopologyRevision& m) { m.map = {}; }),
      spoiled<TopologyRevision>("point NaN",
                                [](TopologyRevision& m) { m.patch.points[1].now.x() = std::nanf(""); }),
      spoiled<TopologyRevision>("vertex far",
                                [](TopologyRevision& m) { m.patch.vertices[1].rest.x() = 1e5f; }),
      spoiled<TopologyRevision>("weights", [](TopologyRevision& m) { m.patch.vertices[0].weight[1] = 0.5f; }),
      spoiled<TopologyRevision>("weight NaN",
                                [](TopologyRevision& m) { m.patch.vertices[0].weight[3] = std::nanf(""); }),
      spoiled<TopologyRevision>("point",
                                [](TopologyRevision& m) { m.patch.vertices[0].point[3] = 1u << 20; }),
      spoiled<TopologyRevision>("slot twice", [](TopologyRevision& m) { m.patch.vertices[1].slot = 3; }),
      spoiled<TopologyRevision>("backwards", [](TopologyRevision& m) { m.patch.triangles[1].slot = 4; }),
      spoiled<TopologyRevision>("slot", [](TopologyRevision& m) { m.patch.triangles[1].slot = 1u << 21; }),
      spoiled<TopologyRevision>("corner",
                                [](TopologyRevision& m) { m.patch.triangles[0].corners[2] = 1u << 20; }),
      spoiled<ContactSample>("third hand", [](ContactSample& m) { m.hand = 2; }),
      spoiled<ContactSample>("depth", [](ContactSample& m) { m.depth = nan; }),
      spoiled<ContactSample>("normal", [](ContactSample& m) { m.normal *= 50; }),
      spoiled<ContactSample>("impulse", [](ContactSample& m) { m.impulse = -1; }),
      spoiled<ContactSample>("force", [](ContactSample& m) { m.force.x() = infinity; }),
      spoiled<ContactSample>("local point", [](ContactSample& m) { m.local_point.y() = nan; }),
      spoiled<ContactSample>("impact", [](ContactSample& m) { m.impact = nan; }),
      spoiled<ServerStatus>("energy", [](ServerStatus& m) { m.energy = infinity; }),
      spoiled<ServerStatus>("phase", [](ServerStatus& m) { m.phase_ms[7] = -1; }),
      spoiled<ServerStatus>("text", [](ServerStatus& m) { m.degraded = "\xff"; }),
      spoiled<SceneInfo>("method", [](SceneInfo& m) { m.bodies[1].method = "\xff"; }),
      spoiled<SceneInfo>("fidelity", [](SceneInfo& m) { m.bodies[1].fidelity = static_cast<Fidelity>(6); }),
      spoiled<SceneInfo>("light with nobody", [](SceneInfo& m) { m.lights[0].body = 4; }),
      spoiled<PartState>("body", [](PartState& m) { m.body = max_bodies; }),
      spoiled<PartState>("opacity", [](PartState& m) { m.opacity = 1.5; }),
      spoiled<PartState>("stiffness", [](PartState& m) { m.stiffness = 0; }),
      spoiled<PartState>("shape", [](PartState& m) { m.shape.p.x() = nan; }),
      spoiled<PartState>("nobody holds", [](PartState& m) { m.holders[1].participant = 0; }),
      spoiled<PartState>("third hand holds", [](PartState& m) { m.holders[0].hand = 2; }),
      spoiled<PartState>("too many", [](PartState& m) { m.holders.resize(max_holders + 1, m.holders[0]); }),
      spoiled<Panel>("nobody", [](Panel& m) { m.participant = 0; }),
      spoiled<Panel>("pose", [](Panel& m) { m.pose.p.z() = nan; }),
      spoiled<Panel>("control", [](Panel& m) { m.controls[2].position = -0.5; }),
      spoiled<RoomState>("brightness", [](RoomState& m) { m.lights = nan; }),
      spoiled<RoomState>("pace", [](RoomState& m) { m.pace = 2 * max_pace; }),
      spoiled<Presence>("three arms", [](Presence& m) { m.arms = 4; }),
      spoiled<FeltPlanes>("nobody", [](FeltPlanes& m) { m.participant = 0; }),
      spoiled<FeltPlanes>("third hand", [](FeltPlanes& m) { m.hand = 2; }),
      spoiled<FeltPlanes>("too many planes", [](FeltPlanes& m) { m.planes.resize(5, m.planes[0]); }),
      spoiled<FeltPlanes>("body", [](FeltPlanes& m) { m.planes[1].body = max_bodies; }),
      spoiled<FeltPlanes>("point", [](FeltPlanes& m) { m.planes[0].point.y() = nan; }),
      spoiled<FeltPlanes>("too far from the hand", [](FeltPlanes& m) { m.planes[0].arm.x() = 2; }),
      spoiled<FeltPlanes>("normal", [](FeltPlanes& m) { m.planes[0].normal.setZero(); }),
      spoiled<FeltPlanes>("huge force", [](FeltPlanes& m) { m.planes[0].force.z() = 2000; }),
      spoiled<FeltPlanes>("negative stiffness", [](FeltPlanes& m) { m.planes[0].stiffness = -1; }),
      spoiled<FeltPlanes>("huge stiffness", [](FeltPlanes& m) { m.planes[0].tangential = 1e9; }),
      spoiled<FeltPlanes>("damping", [](FeltPlanes& m) { m.planes[0].damping = nan; }),
      spoiled<FeltPlanes>("friction", [](FeltPlanes& m) { m.planes[0].friction = -0.1; }),
      spoiled<FeltPlanes>("radius", [](FeltPlanes& m) { m.planes[0].radius = -1; }),
      spoiled<FeltPlanes>("velocity", [](FeltPlanes& m) { m.planes[0].velocity.x() = 100; }),
      spoiled<FeltPlanes>("energy", [](FeltPlanes& m) { m.taken = -1; }),
      spoiled<ArmForce>("nobody", [](ArmForce& m) { m.participant = 0; }),
      spoiled<ArmForce>("third hand", [](ArmForce& m) { m.hand = 2; }),
      spoiled<ArmForce>("force", [](ArmForce& m) { m.force.x() = nan; }),
      spoiled<ArmForce>("energy", [](ArmForce& m) { m.given = nan; }),
      spoiled<Recording>("a mark of the recording is after its end", [](Recording& m) { m.last_tick = 80; }),
      spoiled<Recording>("marks out of order", [](Recording& m) { m.marks[0].tick = 70; }),
      spoiled<Recording>("kind of mark", [](Recording& m) { m.marks[1].kind = static_cast<MarkKind>(5); }),
      spoiled<Recording>("marks", [](Recording& m) { m.marks.resize(max_recording_marks + 1); }),
      spoiled<SceneInfo>("name in no language", [](SceneInfo& m) { m.bodies[1].names[0].language = ""; }),
      spoiled<SceneInfo>("language", [](SceneInfo& m) { m.bodies[1].names[0].language = "de_AT!"; }),
      spoiled<SceneInfo>("empty name", [](SceneInfo& m) { m.bodies[1].names[0].name = ""; }),
      spoiled<SceneInfo>("language twice", [](SceneInfo& m) { m.bodies[1].names[1].language = "de"; }),
      spoiled<SceneInfo>("term", [](SceneInfo& m) { m.bodies[1].term = "A05\n"; }),
      spoiled<BodyStatus>("body", [](BodyStatus& m) { m.body = max_bodies; }),
      spoiled<BodyStatus>("step NaN", [](BodyStatus& m) { m.step = nan; }),
      spoiled<BodyStatus>("residual", [](BodyStatus& m) { m.residual = -1; }),
      spoiled<BodyStatus>("correction", [](BodyStatus& m) { m.correction = infinity; }),
      spoiled<BodyStatus>("error NaN", [](BodyStatus& m) { m.error = nan; }),
      spoiled<BodyStatus>("prices", [](BodyStatus& m) { m.prices.resize(max_configuration_costs + 1); }),
      spoiled<BodyStatus>("price NaN", [](BodyStatus& m) { m.prices[1].ms = nan; }),
      spoiled<BodyStatus>("part NaN", [](BodyStatus& m) { m.parts.model = nan; }),
      spoiled<BodyStatus>("part below 0", [](BodyStatus& m) { m.parts.time = -0.5; }),
      spoiled<BodyStatus>("press NaN", [](BodyStatus& m) { m.press_error = nan; }),
      spoiled<BodyStatus>("map's size", [](BodyStatus& m) { m.error_map.size[1] = 2; }),
      spoiled<BodyStatus>("map's side",
                          [](BodyStatus& m) {
                            m.error_map.size = {max_error_map_side + 1, 1, 1};
                            m.error_map.levels.resize(max_error_map_side + 1);
                          }),
      spoiled<BodyStatus>("map's place", [](BodyStatus& m) { m.error_map.corner.y() = nan; }),
      spoiled<BodyStatus>("steps down", [](BodyStatus& m) { m.stepped_down = max_steps_down + 1; }),
  };
}

TEST(Wire, SpoiledMessagesAreRefused) {
  for (const Spoiled& spoiled : spoiled_messages()) {
    Message received;
    std::size_t bytes = 0;
    EXPECT_TRUE(through_the_wire(spoiled.message, received, bytes))
        << topics[spoiled.message.index()].name << ": " << spoiled.what;
  }
}

TEST(Wire, AnotherVersionCanStillSayWhoItIs) {
  SessionInfo info{protocol_version + 1, "prosector", "", {}, 0, 0, 1};
  EXPECT_EQ(std::get<SessionInfo>(round_trip(info)).version, protocol_version + 1);
  Presence presence{1, protocol_version + 1, "Ada", static_cast<Role>(17), ""};
  EXPECT_EQ(std::get<Presence>(round_trip(presence)).version, protocol_version + 1);
}

// Wire structs that a well-meaning sender never makes.
TEST(Wire, SpoiledWireStructsAreRefused) {
  WireArena arena;
  prosector_SoftState w{};
  to_wire(std::get<SoftState>(sample_messages()[10]), w, arena);
  SoftState m;
  ASSERT_FALSE(from_wire(w, m));
  const auto refused = [&](auto&& spoil) {
    prosector_SoftState bad = w;
    spoil(bad);
    EXPECT_TRUE(from_wire(bad, m));
  };
  refused([](auto& bad) { bad.count = 60000; });
  refused([](auto& bad) { bad.count = 113; });
  refused([](auto& bad) { bad.bits[1] = 27; });
  refused([](auto& bad) { bad.bits[1] = 255; });
  refused([](auto& bad) { bad.extent[0] = -1; });
  refused([](auto& bad) { bad.extent[0] = std::nanf(""); });
  refused([](auto& bad) { bad.low[2] = 1e30f; });
  refused([](auto& bad) { bad.velocity_low[2] = std::nanf(""); });
  refused([](auto& bad) { bad.packed._length -= 1; });
  refused([](auto& bad) { bad.packed._buffer = nullptr; });

  prosector_Settled settled{};
  to_wire(std::get<Settled>(sample_messages()[11]), settled, arena);
  settled.positions._length -= 1;
  Settled out;
  EXPECT_TRUE(from_wire(settled, out));

  prosector_TopologyRevision revision{};
  to_wire(std::get<TopologyRevision>(sample_messages()[12]), revision, arena);
  TopologyRevision cut;
  ASSERT_FALSE(from_wire(revision, cut));
  const auto refused_cut = [&](auto&& spoil) {
    prosector_TopologyRevision bad = revision;
    spoil(bad);
    EXPECT_TRUE(from_wire(bad, cut));
  };
  refused_cut([](auto& bad) { bad.points._length = 1u << 30; });
  refused_cut([](auto& bad) { bad.vertices._buffer = nullptr; });
  refused_cut([](auto& bad) { bad.triangles._length = max_surface_triangles + 1; });

  prosector_SceneInfo scene{};
  to_wire(std::get<SceneInfo>(sample_messages()[7]), scene, arena);
  SceneInfo seen;
  ASSERT_FALSE(from_wire(scene, seen));
  scene.bodies._buffer[1].names._length = max_local_names + 1;
  EXPECT_TRUE(from_wire(scene, seen));

  prosector_Presence presence{};
  std::memset(presence.name, 'x', sizeof presence.name);  // no terminating zero
  Presence named;
  static_cast<void>(from_wire(presence, named));
  named.participant = 1;
  EXPECT_TRUE(check(named));
}

}  // namespace
}  // namespace prosector
