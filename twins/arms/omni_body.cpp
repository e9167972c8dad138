#include "twins/arms/omni_body.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector::omni_body {
namespace {

constexpr double link = 0.13335;                     // m: length of both bars
constexpr double above = 0.02335, before = 0.16835;  // m: position of the shoulder relative to the frame's
                                                     // origin
constexpr double full_torque = 0.44;                 // N·m: assumed, since no public source states it
constexpr double count_angle = 2 * std::numbers::pi / 15000;
constexpr double docked_shoulder = 0.23, docked_lower_bar = -0.37;  // rad, absolute
constexpr int zero_torque = 0x7ff, torque_range = 4095;
constexpr std::uint16_t fixed_bits = 0x53c0, changing_bits = 0x000b, motor_bit = 0x0008;
constexpr int pot_ends = 60000;  // sum of a potentiometer's two readings

/// Angle of a potentiometer: gain · fraction of one reading + zero, rad.
struct PotScale {
  double gain, zero;
};
constexpr std::array<PotScale, 3> pots = {{{5.48, -2.74}, {-5.28, 2.64}, {4.76, -2.38}}};

// The chain's axes follow the robotics convention: x away from the user, y left, z up.
const Quat& to_arm_frame() {
  static const Quat turn((Mat3() << 0, -1, 0, 0, 0, 1, -1, 0, 0).finished());
  return turn;
}
Quat about(double angle, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(angle, axis));
}
Quat forearm(const Chain& c) {
  return about(c.waist, Vec3::UnitZ()) * about(c.shoulder, Vec3::UnitY()) * about(c.elbow, Vec3::UnitY());
}
Vec3 wrist_centre(const Chain& c) {
  const Vec3 forearm_end = about(c.elbow, Vec3::UnitY()) * Vec3(0, 0, -link);
  const Vec3 upper_end = about(c.shoulder, Vec3::UnitY()) * (Vec3(-link, 0, 0) + forearm_end);
  return about(c.waist, Vec3::UnitZ()) * upper_end;
}
Vec3 in_arm_frame(const Vec3& of_shoulder) {
  return to_arm_frame() * of_shoulder + Vec3(0, above, -before);
}

/// Rotates a chain by changes of its encoder angles. The motors act on the same angles.
Chain turned(const Chain& c, const Vec3& encoders) {
  return {c.waist + encoders[0], c.shoulder + encoders[1], c.elbow + encoders[2] - encoders[1], c.wrist};
}

void append16(std::span<std::uint8_t> packet, std::size_t at, unsigned value) {
  packet[at] = static_cast<std::uint8_t>(value % 256);
  packet[at + 1] = static_cast<std::uint8_t>(value / 256 % 256);
}

}  // namespace

std::array<std::uint8_t, 4> register_bytes(std::uint64_t address) {
  if (address == vendor_register) return {0x00, 0x0b, 0x99, 0x00};
  if (address == serial_register) return {0x81, 0x28, 0x41, 0x39};
  return {};
}

bool starts_packets(std::uint8_t control) {
  return (control >> 3 & 1) != 0;
}

Chain in_inkwell() {
  return {0, docked_shoulder, docked_lower_bar - docked_shoulder, Vec3::Zero()};
}

Encoders encoders_of(const Chain& chain, const Encoders& offset) {
  const Chain home = in_inkwell();
  const double waist = chain.waist - home.waist, shoulder = chain.shoulder - home.shoulder,
               lower_bar = chain.shoulder + chain.elbow - home.shoulder - home.elbow;
  const auto counts = [](double angle) { return static_cast<int>(std::lround(angle / count_angle)); };
  return {offset[0] + counts(waist), offset[1] - counts(shoulder), offset[2] + counts(lower_bar)};
}

Pose stylus_of(const Chain& chain) {
  const Quat hand = forearm(chain) * about(chain.wrist[0], Vec3::UnitZ()) *
                    about(chain.wrist[1], Vec3::UnitY()) * about(chain.wrist[2], Vec3::UnitX());
  return {in_arm_frame(wrist_centre(chain)), to_arm_frame() * hand * to_arm_frame().conjugate()};
}

std::optional<Chain> chain_at(const Pose& stylus) {
  const Vec3 at = to_arm_frame().conjugate() * (stylus.p - Vec3(0, above, -before));
  const double ratio = at.squaredNorm() / (2 * link * link) - 1;
  if (!(std::abs(ratio) < 1)) return std::nullopt;
  Chain out;
  out.waist = std::atan2(-at.y(), -at.x());
  out.elbow = std::asin(ratio);
  const Vec3 level = wrist_centre({0, 0, out.elbow, Vec3::Zero()});
  const double out_from_axis = -std::hypot(at.x(), at.y());
  out.shoulder = std::atan2(level.z() * out_from_axis - level.x() * at.z(),
                            level.x() * out_from_axis + level.z() * at.z());
  const Mat3 hand = (forearm(out).conjugate() * (to_arm_frame().conjugate() * stylus.q * to_arm_frame()))
                        .toRotationMatrix();
  out.wrist = {std::atan2(hand(1, 0), hand(0, 0)), std::asin(std::clamp(-hand(2, 0), -1., 1.)),
               std::atan2(hand(2, 1), hand(2, 2))};
  return out;
}

std::optional<Motors> motors_of(std::span<const std::uint8_t> packet) {
  if (packet.size() != command_size) return std::nullopt;
  const auto word = [&](std::size_t at) { return packet[at] + 256 * packet[at + 1]; };
  if ((word(6) & ~changing_bits) != fixed_bits) return std::nullopt;
  Motors out;
  out.on = (word(6) & motor_bit) != 0;
  for (int i = 0; i < 3; ++i) {
    const int value = word(2 * static_cast<std::size_t>(i));
    if (value > torque_range) return std::nullopt;
    out.shares[i] = value == zero_torque ? 0 : 2. * value / torque_range - 1;
  }
  return out;
}

Vec3 force_of(const Chain& chain, const Vec3& shares) {
  // Virtual work: for every small encoder rotation, force · displacement = torque · rotation.
  constexpr double small = 1e-6;
  Mat3 way;  // Jacobian of the wrist's centre with respect to the encoder angles
  for (int i = 0; i < 3; ++i) {
    const Vec3 turn = small * Vec3::Unit(i);
    way.col(i) = (wrist_centre(turned(chain, turn)) - wrist_centre(turned(chain, -turn))) / (2 * small);
  }
  if (std::abs(way.determinant()) < 1e-3 * link * link * link)
    return Vec3::Zero();  // near a singularity: the arm is stretched out
  return to_arm_frame() * Vec3(way.transpose().inverse() * (full_torque * shares));
}

std::array<std::uint8_t, state_size> state_packet(const Encoders& encoders, const Vec3& wrist, bool docked,
                                                  std::uint32_t count) {
  std::array<std::uint8_t, state_size> out{};
  append16(out, 2, 0x001e);
  for (std::size_t i = 0; i < 3; ++i) {
    append16(out, 4 + 2 * i, static_cast<unsigned>(encoders[i]));
    const double share =
        std::clamp((wrist[static_cast<Eigen::Index>(i)] - pots[i].zero) / pots[i].gain, 0., 1.);
    const auto one_end = static_cast<unsigned>(std::lround(share * pot_ends));
    append16(out, 10 + 2 * i, one_end);
    append16(out, 22 + 2 * i, pot_ends - one_end);
  }
  out[18] = static_cast<std::uint8_t>(count % 256);
  out[19] = docked ? 0x03 : 0x07;  // bits 0 and 1: buttons released
  append16(out, 20, 0x1007);
  append16(out, 28, 0x5746);
  append16(out, 32, count % 65536);
  append16(out, 34, count / 65536);
  return out;
}

}  // namespace prosector::omni_body
