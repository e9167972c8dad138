// Wire conversion of body motion and rest shapes: RigidState, SoftState, Settled.

#include "idl/wire/fields.h"
#include "idl/wire/soft_quantizer.h"

namespace prosector {
namespace {

template <class T>
void copy(const std::array<T, 3>& from, T (&to)[3]) {
  for (std::size_t k = 0; k < 3; ++k) to[k] = from[k];
}
template <class T>
std::array<T, 3> as_array(const T (&from)[3]) {
  return {from[0], from[1], from[2]};
}

bool box_within(const Grid& grid, double limit) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = grid.low[k], extent = grid.extent[k];
    if (!within(low, -limit, limit) || !within(extent, 0, 2 * limit)) return false;
  }
  return true;
}

template <class Io>
void fields(Io& io, MessageOf<Io, RigidState>& m, WireOf<Io, prosector_RigidState>& w) {
  io(m.body, w.body);
  io(m.time, w.time);
  io(m.pose, w.pose);
  io(m.linear_velocity, w.linear_velocity);
  io(m.angular_velocity, w.angular_velocity);
  io(m.settled, w.settled);
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(RigidState);

Refusal check(RigidState& m) {
  if (const Refusal pose = check_pose(m.pose)) return pose;
  return Checks()
      .that(m.body < max_bodies, "no such body")
      .that(within(m.linear_velocity, max_speed), "velocity out of range")
      .that(within(m.angular_velocity, max_angular_speed), "the body's angular velocity is out of range")
      .refusal();
}

void to_wire(const SoftState& m, prosector_SoftState& w, WireArena& arena) {
  const Grid positions = position_grid(m.positions), velocities = velocity_grid(m.velocities);
  w.body = m.body;
  w.chunk = m.chunk;
  w.time = to_wire(m.time);
  w.revision = m.revision;
  w.first_point = m.first_point;
  w.count = static_cast<std::uint16_t>(m.positions.size());
  copy(positions.bits, w.bits);
  copy(positions.low, w.low);
  copy(positions.extent, w.extent);
  copy(velocities.low, w.velocity_low);
  copy(velocities.extent, w.velocity_extent);
  make_sequence<std::uint8_t>(w.packed, packed_bytes(positions, velocities, m.positions.size()), arena);
  pack(positions, velocities, m.positions, m.velocities, {w.packed._buffer, w.packed._length});
}

Refusal from_wire(const prosector_SoftState& w, SoftState& m) {
  const Grid positions{as_array(w.low), as_array(w.extent), as_array(w.bits)};
  Grid velocities{as_array(w.velocity_low), as_array(w.velocity_extent), {}};
  m.body = w.body;
  m.chunk = w.chunk;
  m.time = from_wire(w.time);
  m.revision = w.revision;
  m.first_point = w.first_point;
  if (w.count > max_chunk_points) return "too many points";
  for (const std::uint8_t bits : positions.bits)
    if (bits > max_component_bits) return "too many bits";
  if (!box_within(positions, max_coordinate) || !box_within(velocities, max_speed)) return "box out of range";
  set_velocity_bits(velocities);
  if (!sequence_within(w.packed, packed_bytes(positions, velocities, w.count)) ||
      w.packed._length != packed_bytes(positions, velocities, w.count))
    return "wrong packed size";
  m.positions.resize(w.count);
  m.velocities.resize(w.count);
  unpack(positions, velocities, {w.packed._buffer, w.packed._length}, m.positions, m.velocities);
  return {};
}

Refusal check(SoftState& m) {
  Checks checks;
  checks.that(m.body < max_bodies, "no such body")
      .that(!m.positions.empty() && m.positions.size() <= max_chunk_points,
            "the number of the body's points in the message is zero or too large")
      .that(m.velocities.size() == m.positions.size(),
            "the message's number of velocities differs from its number of points; they must be equal")
      .that(m.first_point <= max_streamed_points - m.positions.size(), "points out of range");
  for (const Vec3& x : m.positions) checks.that(within(x, max_coordinate), "position out of range");
  for (const Vec3& v : m.velocities) checks.that(within(v, max_speed), "velocity out of range");
  return checks.refusal();
}

void to_wire(const Settled& m, prosector_Settled& w, WireArena& arena) {
  w.body = m.body;
  w.time = to_wire(m.time);
  w.revision = m.revision;
  w.hash = m.hash;
  make_sequence<float>(w.positions, 3 * m.positions.size(), arena);
  if (!m.positions.empty())
    std::memcpy(w.positions._buffer, m.positions.data(), w.positions._length * sizeof(float));
}

Refusal from_wire(const prosector_Settled& w, Settled& m) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  if (!sequence_within(w.positions, 3 * max_streamed_points)) return "too many points";
  if (w.positions._length % 3 != 0)
    return "the number of coordinates is not a multiple of three; each point needs three";
  m.body = w.body;
  m.time = from_wire(w.time);
  m.revision = w.revision;
  m.hash = w.hash;
  m.positions.resize(w.positions._length / 3);
  for (std::size_t i = 0; i < m.positions.size(); ++i)
    m.positions[i] = Eigen::Map<const Eigen::Vector3f>(w.positions._buffer + 3 * i);
  return {};
}

Refusal check(Settled& m) {
  constexpr auto limit = static_cast<float>(max_coordinate);
  Checks checks;
  checks.that(m.body < max_bodies, "no such body")
      .that(!m.positions.empty() && m.positions.size() <= max_streamed_points,
            "the number of the body's points in the message is zero or too large");
  for (const Eigen::Vector3f& x : m.positions)
    checks.that(x.allFinite() && x.cwiseAbs().maxCoeff() <= limit, "position out of range");
  return checks.refusal();
}

}  // namespace prosector
