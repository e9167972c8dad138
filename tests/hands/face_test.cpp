// The face of the CT's head before a camera: found, and its eyes placed.
#include <gtest/gtest.h>

#include <cmath>

#include "common/anatomy/isosurface.h"
#include "common/anatomy/volume_io.h"
#include "common/error.h"
#include "common/eye_distance.h"
#include "common/rotation_between.h"
#include "common/smooth_normals.h"
#include "drivers/camera/face/eyes_filter.h"
#include "drivers/camera/face/eyes_pose.h"
#include "tests/random.h"
#include "tests/real_data.h"
#include "twins/camera/mesh_layer.h"

namespace prosector {
namespace {

constexpr double skin = -250;  // Hounsfield units

/// The skin of the CT's head, before a grey wall.
class CtHead {
 public:
  explicit CtHead(const std::string& file) {
    const Volume volume = load_volume(file);
    const Vec3 half = 0.5 * Vec3(static_cast<double>(volume.dims[0]), static_cast<double>(volume.dims[1]),
                                 static_cast<double>(volume.dims[2]))
                                .cwiseProduct(volume.voxel_size);
    // Where the picture ends in the flesh, the solid ends, too.
    const auto value = [&](const Vec3& x) {
      return std::max((skin - sample(volume, x)) * 1e-6, (x.cwiseAbs() - 0.96 * half).maxCoeff());
    };
    const TriangleMesh mesh = isosurface({value, {-half, half}}, 0.004);
    for (const Vec3& x : mesh.positions) positions_.push_back(x.cast<float>());
    triangles_ = mesh.triangles;
    smooth_normals(positions_, triangles_, normals_);
    paint_.assign(positions_.size(), {0.55F, 0.34F, 0.25F});
  }

  /// Returns a picture of the head whose volume's middle is at `place`, and what rays meet.
  std::pair<Image, MeshDepthBuffer> paint(const Lens& lens, const Vec3& place, double yaw) const {
    Mat3 facing;  // the volume's x is the patient's right, y ahead, z up
    facing << -1, 0, 0, 0, 0, -1, 0, -1, 0;
    const Pose camera_head = {place,
                              (Quat(Eigen::AngleAxisd(yaw, Vec3::UnitY())) * Quat(facing)).normalized()};
    MeshDepthBuffer layer(2 * lens.width, 2 * lens.height, lens.ray({-1, -1}).head<2>(),
                          lens.ray({lens.width * 1.0, lens.height * 1.0}).head<2>());
    layer.draw({positions_, normals_, triangles_, paint_}, camera_head,
               {Vec3(0.3, -0.5, -0.8).normalized(), 0.5});
    Image image{lens.width, lens.height, {}};
    for (int y = 0; y < lens.height; ++y)
      for (int x = 0; x < lens.width; ++x) {
        const MeshDepthBuffer::Hit hit = layer.at(lens.ray({x * 1.0, y * 1.0}).head<2>().cast<float>());
        for (std::size_t c = 0; c < 3; ++c)
          image.rgb.push_back(
              std::isfinite(hit.depth)
                  ? static_cast<std::uint8_t>(255 * std::pow(std::min(hit.light[c], 1.F), 0.45F))
                  : 110);
      }
    return {image, layer};
  }

 private:
  std::vector<Eigen::Vector3f> positions_, normals_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Rgb> paint_;
};

class Faces : public testing::Test {
 protected:
  void SetUp() override {
    if (file_.empty() || net_.empty())
      GTEST_SKIP()
          << "no head.nii or face_short_range.tflite: deploy/fetch_anatomy.sh, deploy/fetch_models.sh";
  }
  static const CtHead& head(const std::string& file) {
    static const CtHead made(file);
    return made;
  }
  std::string file_ = find_in_data("head.nii"), net_ = find_in_data("face_short_range.tflite");
};

TEST_F(Faces, AreFoundAndTheirEyesPlaced) {
  FaceDetector finder(std::filesystem::path(net_).parent_path());
  const Lens lens;
  std::vector<double> ratios;
  for (const double depth : {0.5, 0.7})
    for (const double yaw : {0.0, 0.3, -0.3}) {
      const auto [image, layer] = head(file_).paint(lens, {0.02, 0.05, depth + 0.1}, yaw);
      const auto face = finder.find(image);
      ASSERT_TRUE(face) << depth << ", " << yaw;
      EXPECT_LT(face->right_eye.x(), face->left_eye.x());
      EXPECT_GT(face->nose.y(), face->right_eye.y());
      const EyesPose eyes = estimate_eyes_pose(*face, lens, default_interpupillary_distance);
      EXPECT_LT(std::abs(eyes.roll), 0.45);
      EXPECT_NEAR(eyes.yaw, -yaw, 0.4);
      if (yaw != 0) {
        EXPECT_LT(eyes.yaw * yaw, 0) << "turned to that side";
      }
      const Vec2 between = eyes.head.p.hnormalized();
      ratios.push_back(eyes.head.p.z() / layer.at(between.cast<float>()).depth);
    }
  // The CT ends at the upper lip and its eyes are closed: points are rough, and these eyes needn't be 63 mm
  // apart.
  for (const double r : ratios) {
    EXPECT_NEAR(r, 1, 0.25);
  }
}

TEST_F(Faces, AreNoneInPicturesOfNothing) {
  FaceDetector finder(std::filesystem::path(net_).parent_path());
  for (const Image& image :
       {Image{}, Image{640, 480, {1, 2, 3}}, Image{160, 120, std::vector<std::uint8_t>(160 * 120 * 3)}})
    EXPECT_FALSE(finder.find(image));
}

/// Returns what a camera sees of a face of the usual shape.
DetectedFace seen_face(const Lens& lens, const Pose& camera_head, double eye_distance) {
  const auto at = [&](const Vec3& x) { return lens.project(camera_head * x); };
  DetectedFace face;
  face.right_eye = at({eye_distance / 2, 0, 0});
  face.left_eye = at({-eye_distance / 2, 0, 0});
  face.nose = at({0, -0.03, -nose_depth_ratio * eye_distance});
  return face;
}

TEST(EyesPose, IsExactForAFaceOfTheUsualShape) {
  Lens lens;
  lens.k1 = -0.2;
  for (const double yaw : {0.0, 0.4, -0.6})
    for (const double roll : {0.0, 0.3})
      for (const double eye_distance : {0.058, 0.07})
        for (const Vec3& middle : {Vec3(0, 0, 0.6), Vec3(0.15, -0.1, 0.4), Vec3(-0.4, 0.2, 1.1)}) {
          // The face turns from the way to the camera.
          const Quat facing(0, 0, 0, 1), way = rotation_between(Vec3::UnitZ(), middle);
          const Quat turned = Quat(Eigen::AngleAxisd(roll, Vec3::UnitZ())) *
                              Quat(Eigen::AngleAxisd(-yaw, Vec3::UnitY())) * facing;
          const Pose head = {middle, way * turned};
          const EyesPose eyes = estimate_eyes_pose(seen_face(lens, head, eye_distance), lens, eye_distance);
          SCOPED_TRACE(testing::Message()
                       << "turned " << yaw << ", " << roll << ", at " << middle.transpose());
          EXPECT_LT((eyes.head.p - middle).norm(), 0.02 * middle.norm());
          EXPECT_LT(eyes.head.q.angularDistance(head.q), 0.04) << "rad";
          EXPECT_NEAR(eyes.yaw, yaw, 0.04);
          EXPECT_NEAR(eyes.roll, roll, 0.03);
        }
}

TEST(EyesPose, ErrsInDistanceAsTheEyesDo) {
  const Lens lens;
  const DetectedFace face = seen_face(lens, {Vec3(0.1, 0, 0.6), Quat(0, 0, 0, 1)}, 0.063);
  const double as_told = estimate_eyes_pose(face, lens, 0.063).head.p.norm();
  EXPECT_NEAR(estimate_eyes_pose(face, lens, 1.1 * 0.063).head.p.norm(), 1.1 * as_told, 1e-9);
}

TEST(EyesFilter, RestsAlongTheViewMoreThanAcross) {
  EyesFilter filter;
  Random random{3};
  double across = 0, along = 0;
  std::int64_t time_ns = 1'000'000'000;
  for (int k = 0; k < 300; ++k, time_ns += 33'333'333) {
    const Vec3 noise(random.uniform(-1, 1), 0, random.uniform(-1, 1));
    const Pose out = filter.update({Vec3(0.1, 0, 0.6) + 0.001 * noise, Quat::Identity()}, time_ns);
    if (k < 60) continue;
    across += std::abs(out.p.x() - 0.1);
    along += std::abs(out.p.z() - 0.6);
  }
  EXPECT_LT(along, 0.9 * across);
  EXPECT_LT(across / 240, 0.0003) << "m";
  const Pose there = {Vec3(-0.2, 0.1, 0.8), Quat::Identity()};
  Pose out;
  for (int k = 0; k < 120; ++k, time_ns += 33'333'333) out = filter.update(there, time_ns);
  EXPECT_LT((out.p - there.p).norm(), 0.001) << "m: at rest there is no lag";
}

TEST(FaceDetector, SaysWhatItNeeds) {
  EXPECT_THROW(FaceDetector("/nowhere"), InputError);
}

}  // namespace
}  // namespace prosector
