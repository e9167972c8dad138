#include "twins/camera/face_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/anatomy/isosurface.h"
#include "common/anatomy/volume_io.h"
#include "common/error.h"
#include "common/smooth_normals.h"

namespace prosector {
namespace {

using std::numbers::pi;

constexpr Rgb skin_tone = {0.55F, 0.34F, 0.25F}, hair = {0.05F, 0.035F, 0.025F}, brow = {0.08F, 0.05F, 0.04F},
              eye_white = {0.75F, 0.75F, 0.73F}, iris = {0.1F, 0.06F, 0.04F}, pupil = {0.01F, 0.01F, 0.01F},
              lip = {0.45F, 0.16F, 0.14F}, dark = {0.08F, 0.04F, 0.03F}, cloth = {0.1F, 0.14F, 0.25F};

// Dimensions of the modelled head, m.
const Vec3 head_half = {0.078, 0.118, 0.098};
constexpr double mouth_height = -0.072, nostril_height = -0.047, hairline = 0.062;

double hump(double x, double width) {
  return std::exp(-(x / width) * (x / width));
}

/// Returns the height of the skin over the head's ellipsoid at a point of the front, m.
double relief(double x, double y, double half_eyes) {
  const double aside = std::abs(x);
  const double down = 0.005 - y;  // m, downwards along the nose
  const double ridge = down < 0 ? 0 : down < 0.045 ? 0.2 + 0.8 * down / 0.045 : hump(down - 0.045, 0.006);
  return 0.024 * ridge * hump(x, 0.008 + 0.1 * std::clamp(down, 0.0, 0.05)) -
         0.010 * hump(aside - half_eyes, 0.015) * hump(y, 0.011) +
         0.005 * hump(aside - half_eyes, 0.009) * hump(y, 0.008) +
         0.004 * hump(aside - half_eyes, 0.022) * hump(y - 0.02, 0.008) +
         0.006 * hump(x, 0.022) * hump(y - mouth_height, 0.009) +
         0.008 * hump(x, 0.022) * hump(y + 0.105, 0.013);
}

/// Returns the colour of the face at a point of the front.
Rgb face_paint(double x, double y, double half_eyes) {
  const double aside = std::abs(x), from_eye = aside - half_eyes;
  const double lid =
      0.0062 * (1 - (from_eye / 0.0155) * (from_eye / 0.0155));  // half the height of the open lids
  if (y > hairline + 0.01 * (aside / 0.07)) return hair;
  if (lid > 0 && std::abs(y) < lid) {
    const double off = std::hypot(from_eye, y);
    return off < 0.0024 ? pupil : off < 0.0058 ? iris : eye_white;
  }
  if (lid > 0 && y > 0 && y < lid + 0.0012) return dark;
  if (std::abs(from_eye - 0.001) < 0.02 && std::abs(y - 0.02 - 3 * from_eye * (0.01 - from_eye)) < 0.0034)
    return brow;
  const double across = x / 0.025, up = y - mouth_height;
  if (std::abs(up) < 0.0009 && std::abs(across) < 1) return dark;
  if (across * across + up * up / (0.008 * 0.008) < 1) return lip;
  if (std::hypot(aside - 0.007, y - nostril_height) < 0.0032) return dark;
  return skin_tone;
}

/// A closed surface made of rings from its top to its bottom.
class Rings {
 public:
  Rings(std::size_t rings, std::size_t around) : rings_(rings), around_(around) {}

  /// Adds the surface to a mesh. `point` returns the position and colour for the polar angle from the top (0
  /// to π) and the azimuth (0 is forward).
  template <class Point>
  void add_to(FaceMesh& mesh, const Point& point) const {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t r = 0; r <= rings_; ++r)
      for (std::size_t a = 0; a < around_; ++a) {
        // Columns are denser in front, on the face.
        const double t = pi * (2 * static_cast<double>(a) / static_cast<double>(around_) - 1);
        const auto [place, paint] =
            point(pi * static_cast<double>(r) / static_cast<double>(rings_), t - 0.7 * std::sin(t));
        mesh.positions.push_back(place.template cast<float>());
        mesh.paint.push_back(paint);
      }
    const auto n = static_cast<std::uint32_t>(around_);
    for (std::uint32_t r = 0; r < rings_; ++r)
      for (std::uint32_t a = 0; a < n; ++a) {
        const std::uint32_t here = first + r * n + a, next = first + r * n + (a + 1) % n;
        mesh.triangles.push_back({here, next, here + n});
        mesh.triangles.push_back({next, next + n, here + n});
      }
  }

 private:
  std::size_t rings_, around_;
};

/// Returns a point of an ellipsoid around the origin: y up, −z forward, azimuth increasing to the user's
/// right.
Vec3 on_egg(const Vec3& half, double from_top, double around) {
  return {half.x() * std::sin(from_top) * std::sin(around), half.y() * std::cos(from_top),
          -half.z() * std::sin(from_top) * std::cos(around)};
}

void add_egg(FaceMesh& mesh, const Vec3& middle, const Vec3& half, const Rgb& paint) {
  Rings(24, 48).add_to(mesh, [&](double from_top, double around) {
    return std::pair(Vec3(middle + on_egg(half, from_top, around)), paint);
  });
}

}  // namespace

FaceMesh make_face(double eye_distance) {
  const double half_eyes = eye_distance / 2;
  // The skin at the pupils has z = 0.
  const double slope = half_eyes / head_half.x();
  const double behind = head_half.z() * std::sqrt(1 - slope * slope) + relief(half_eyes, 0, half_eyes);
  FaceMesh out;
  out.eye_distance = eye_distance;
  Rings(360, 240).add_to(out, [&](double from_top, double around) {
    Vec3 x = on_egg(head_half, from_top, around);
    const bool front = x.z() < 0;
    const Rgb paint = front ? face_paint(x.x(), x.y(), half_eyes) : x.y() > -0.07 ? hair : skin_tone;
    if (front) x.z() -= relief(x.x(), x.y(), half_eyes) * std::min(1.0, -x.z() / 0.03);
    return std::pair(Vec3(x + Vec3(0, 0, behind)), paint);
  });
  add_egg(out, {0, -0.15, behind + 0.02}, {0.055, 0.1, 0.06}, skin_tone);
  add_egg(out, {0, -0.31, behind + 0.03}, {0.21, 0.12, 0.1}, cloth);
  smooth_normals(out.positions, out.triangles, out.normals);
  return out;
}

FaceMesh load_ct_face(const std::filesystem::path& file) {
  constexpr double skin = -250;                 // Hounsfield units
  constexpr double cell = 0.003;                // m
  const Vec3 eyes = {-0.0045, 0.0705, -0.019};  // m, volume's frame: point between the eyes
  constexpr double apart = 0.060;               // m
  if (!std::filesystem::exists(file))
    throw InputError(
        fmt::format("the simulated face needs {}, which is missing: fetch it with deploy/fetch_anatomy.sh",
                    file.string()));
  const Volume volume = load_volume(file);
  const Vec3 half = 0.5 * Vec3(static_cast<double>(volume.dims[0]), static_cast<double>(volume.dims[1]),
                               static_cast<double>(volume.dims[2]))
                              .cwiseProduct(volume.voxel_size);
  // The surface is closed where the volume ends in tissue.
  const auto value = [&](const Vec3& x) {
    return std::max((skin - sample(volume, x)) * 1e-6, (x.cwiseAbs() - 0.96 * half).maxCoeff());
  };
  const TriangleMesh mesh = isosurface({value, {-half, half}}, cell);
  FaceMesh out;
  out.eye_distance = apart;
  // The volume's x is the patient's right, y forward, z up.
  for (const Vec3& x : mesh.positions) {
    const Vec3 at = x - eyes;
    out.positions.emplace_back(Vec3(at.x(), at.z(), -at.y()).cast<float>());
  }
  out.triangles = mesh.triangles;
  out.paint.assign(out.positions.size(), skin_tone);
  smooth_normals(out.positions, out.triangles, out.normals);
  return out;
}

}  // namespace prosector
