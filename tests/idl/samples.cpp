#include "tests/idl/samples.h"

#include <numbers>

namespace prosector {
namespace {

// Values that floats hold exactly, so that streams of floats come back equal.
const Pose some_pose{{0.25, 1.5, -0.125}, {0.5, 0.5, -0.5, 0.5}};

HandPose some_hand() {
  return {true, some_pose, {0, 0.25, 0.5, 0.75, 1}, Gesture::point, 5};
}

ContactPlane some_plane() {
  ContactPlane m;
  m.id = 3;
  m.body = 1;
  m.arm = {0, 0.015625, -0.125};
  m.point = {0.5, 1, 0.25};
  m.normal = {0, 0, 1};
  m.force = {0.25, 0, 1.5};
  m.stiffness = 512;
  m.tangential = 384;
  m.damping = 0.5;
  m.friction = 0.25;
  m.radius = 0.0078125;
  m.velocity = {0, 0, -0.0625};
  m.holds = true;
  return m;
}

AssetChunk some_chunk() {
  AssetChunk m;
  m.hash = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  m.chunk = 1;
  m.chunks = 2;
  m.total_bytes = asset_chunk_bytes + 1000;
  m.bytes.assign(1000, 0x5a);
  return m;
}

BodyStatus some_body_status() {
  BodyStatus m{1, {1, 60}, false, true, 12, 0.00125, 2.5, 40, 1e-3, 2e-5, 0.015, 3.5, 1};
  m.parts = {0.0625, -0.03125, 1e-4, 2e-3};
  m.prices = {{0.3, 0.8}, {0.07, 4.5}};
  m.press_error = 0.0625;
  m.error_map = {{0.5, 1, -0.25}, 0.0125, {3, 1, 2}, {0, 1, 200, 255, 7, 8}};
  return m;
}

SceneInfo some_scene() {
  SceneInfo m;
  m.name = "abdomen";
  m.description = "A table,\na lamp";
  SceneBody table;
  table.name = "table";
  table.pose = some_pose;
  table.mesh = {1, 2, 3};
  SceneBody liver;
  liver.name = "liver";
  liver.description = "Größte Drüse";
  liver.kind = BodyKind::soft;
  liver.parent = 0;
  liver.moves = true;
  liver.map = {9, 8, 7};
  liver.points = 700;
  liver.chunk_points = soft_chunk_points;
  liver.method = "fem_corotational, chosen for 2 %";
  liver.show_figures = true;
  liver.part = true;
  liver.fidelity = Fidelity::hull;
  liver.outline = {3, 4};
  liver.names = {{"de", "Leber"}, {"tr", "karaciğer"}};
  liver.term = "A05.8.01.001";
  liver.appearance = {{0.5, 0.25, 0.125}, 0.3, 0.9, Surface::tissue};
  SceneBody suture;
  suture.name = "suture";
  suture.kind = BodyKind::soft;
  suture.moves = true;
  suture.points = 40;
  suture.chunk_points = soft_chunk_points;
  suture.tube_diameter = 0.0004;
  SceneBody dish;
  dish.name = "dish";
  dish.appearance = {.surface = Surface::glass,
                     .refractive_index = 1.62,
                     .abbe_number = 36.4,
                     .transmittance = {0.5, 0.25, 0.125}};
  m.bodies = {table, liver, suture, dish};
  m.lights = {{"lamp", LightKind::spot, {0, 2, 0}, {0, -1, 0}, {1, 1, 0.9}, 10, 0.6, 0.3, 0}};
  m.patient = {{-1, 0, 0}, {0, 0.6, -0.8}};
  return m;
}

SoftState some_soft_state() {
  SoftState m{.body = 1,
              .chunk = 3,
              .time = {1, 77},
              .revision = 2,
              .first_point = 336,
              .positions = {},
              .velocities = {}};
  for (int i = 0; i < 112; ++i) {
    const double t = i * 2 * std::numbers::pi / 112;
    m.positions.emplace_back(0.1 * std::cos(t), 1 + 0.05 * std::sin(t), 0.001 * i);
    m.velocities.emplace_back(-std::sin(t), std::cos(t), 0.1);
  }
  return m;
}

Settled some_settled() {
  Settled m{.body = 1, .time = {1, 99}, .revision = 2, .hash = 0x123456789abcdef0, .positions = {}};
  for (int i = 0; i < 700; ++i) m.positions.emplace_back(0.001f * static_cast<float>(i), 1.0f, -0.5f);
  return m;
}

TopologyRevision some_revision() {
  TopologyRevision m{.body = 1,
                     .revision = 2,
                     .previous_hash = 10,
                     .chain_hash = 11,
                     .content_hash = 12,
                     .time = {1, 60},
                     .cause = TopologyCause::cut,
                     .author = 7,
                     .piece_of = 0,
                     .surface_hash = 13,
                     .patch = {},
                     .mesh = {1, 2},
                     .map = {3, 4}};
  m.patch.points = {{{0, 1, 0.5f}, {0, 1.25f, 0.5f}}, {{0.25f, 1, 0}, {0.25f, 1, 0.5f}}};
  m.patch.vertices = {{3, {0, 1, 0}, {0, 1, 2, 0}, {0.5f, 0.25f, 0.25f, 0}},
                      {700, {0, 1, 0.5f}, {700, 0, 0, 0}, {1, 0, 0, 0}}};
  m.patch.triangles = {{5, {3, 700, 4}, true}, {9, {0, 0, 0}, false}};
  return m;
}

}  // namespace

std::vector<Message> sample_messages() {
  const std::array<HandPose, 2> hands{some_hand(), some_hand()};
  ServerStatus status;
  status.time = {1, 60};
  status.real_time_factor = 0.99;
  status.step_ms_p50 = 4;
  status.step_ms_p99 = 9;
  status.phase_ms = {1, 2, 3, 4, 5, 6, 7, 8};
  status.energy = -3;
  status.degraded = "liver: not converged";
  status.error = 0.125;
  const Affine sheared{(Mat3() << 2, 0.5, 0, 0, 2, 0, 0, 0, 4).finished(), {0.25, 1, 0}};
  Panel panel{7, {1, 60}, true, 1, some_pose, {}};
  panel.controls[5] = {0.25, true, true};
  const Recording recording{
      600, {{0, MarkKind::joined, "Zoë"}, {60, MarkKind::cut, "Zoë"}, {90, MarkKind::reset, ""}}};
  return {SessionInfo{protocol_version, "prosector", "abdomen", {1, 2}, 60, 64, 42},
          Presence{7, protocol_version, "Zoë", Role::dissector, "fastrak, 5dt, omni", 2},
          RosterEntry{7, "Zoë", Role::dissector, {1, 0.5, 0}, "fastrak, 5dt"},
          HandInput{7, 12, 123456789, true, some_pose, hands, {{{true, some_pose}, {}}}},
          UserState{7, {1, 60}, 12, true, some_pose, hands},
          Command{7, 3, Inspect{1, sheared}},
          CommandResult{7, 3, false, "nothing within reach"},
          some_scene(),
          some_chunk(),
          RigidState{2, {1, 60}, some_pose, {1, 2, 3}, {4, 5, 6}, true},
          some_soft_state(),
          some_settled(),
          some_revision(),
          ContactSample{7,
                        left_hand,
                        {1, 60},
                        true,
                        1,
                        {0.5, 1, 0.5},
                        {0, 1, 0},
                        0.0078125,
                        0.5,
                        {0.5, 0, 0.25},
                        {0, -8, 0},
                        0.015625},
          status,
          some_body_status(),
          PartState{1, {1, 60}, false, true, true, true, 0.5, 2, sheared, {{7, left_hand}, {9, right_hand}}},
          panel,
          RoomState{{1, 60}, 0.25, 0.5},
          recording,
          FeltPlanes{7, right_hand, {1, 60}, 12, {some_plane(), some_plane()}, 0.25, 0.125},
          ArmForce{7, right_hand, 12, {0, 1.5, -0.25}, 0.25, 0.125}};
}

}  // namespace prosector
