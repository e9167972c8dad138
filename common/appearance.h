#pragma once
// Appearance of bodies, lights and the camera of a scene, and the patient's orientation. Colours are linear
// RGB in [0, 1].

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "common/math.h"

namespace prosector {

inline constexpr std::size_t max_lights = 16;

/// Visual material class of a surface. `floor`, `wall` and `ceiling` are used for the client's own room only.
enum class Surface : std::uint8_t {
  plain,
  tissue,
  bone,
  metal,
  skin,
  cloth,
  glass,
  emissive,
  floor,
  wall,
  ceiling
};
inline constexpr Surface last_body_surface = Surface::emissive, last_surface = Surface::ceiling;

inline constexpr double min_refractive_index = 1, max_refractive_index = 4;
inline constexpr double min_abbe_number = 10, max_abbe_number = 1000;

/// Visual appearance of a body: its colour, surface class and optical properties, from which a renderer makes
/// its material.
struct Appearance {
  Vec3 color = {0.7, 0.7, 0.7};
  double roughness = 0.6;  // 0 mirror … 1 matt
  double wetness = 0;      // 0 dry … 1: covered by a thin film of liquid
  Surface surface = Surface::plain;
  // Glass only, which ignores `color`. Defaults: crown glass (BK7) with the green tint of window panes.
  double refractive_index = 1.5168;  // n_d: refractive index at 587.6 nm
  double abbe_number = 64.17;  // V_d = (n_d − 1)/(n_F − n_C): the lower, the stronger the dispersion
  Vec3 transmittance = {0.975, 0.99, 0.985};  // fraction of red, green, blue left after 10 mm of glass
  bool operator==(const Appearance&) const = default;
};

enum class LightKind : std::uint8_t { directional, point, spot };

struct LightInfo {
  std::string name;
  LightKind kind = LightKind::point;
  Vec3 position = Vec3::Zero();
  Vec3 direction = {0, -1, 0};
  Vec3 color = Vec3::Ones();
  double intensity = 1;
  double cone = 0.5;       // spot: half angle, rad
  double softness = 0.2;   // spot: fraction of the cone over which the light fades
  std::int32_t body = -1;  // body in whose frame position and direction are given and with which the light
                           // moves; −1: the room
};

struct CameraInfo {
  Vec3 eye = {0, 1.6, 1.2};
  Vec3 target = {0, 1, 0};
  double fov = 0.8;  // vertical, rad
};

/// Orientation of the patient in the room: directions in the world frame, perpendicular to each other, of any
/// non-zero length.
struct PatientFrame {
  Vec3 right = -Vec3::UnitX();  // towards the patient's right
  Vec3 head = -Vec3::UnitZ();   // from the feet towards the head (superior)

  /// Returns the unit direction towards the patient's front (anterior).
  Vec3 front() const { return head.cross(right).normalized(); }
};
inline constexpr double min_patient_angle = 1.55;  // rad between `right` and `head`

/// Returns whether the patient's `right` and `head` directions are finite, non-zero, and perpendicular within
/// rounding.
inline bool is_valid_patient_frame(const PatientFrame& frame) {
  const double area = frame.head.cross(frame.right).norm(), lengths = frame.head.norm() * frame.right.norm();
  return std::isfinite(lengths) && lengths > 0 && area >= std::sin(min_patient_angle) * lengths;
}

}  // namespace prosector
