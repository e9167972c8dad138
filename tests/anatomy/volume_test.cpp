#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/anatomy/mask.h"
#include "common/anatomy/volume_io.h"
#include "common/error.h"
#include "tests/anatomy/files.h"

namespace prosector {
namespace {

using namespace testing_files;

std::string error_of(const Bytes& bytes) {
  try {
    parse_volume(bytes, "file");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

Bytes gzip(const Bytes& raw) {
  Bytes out(compressBound(raw.size()) + 64);
  z_stream s{};
  EXPECT_EQ(deflateInit2(&s, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  s.next_in = const_cast<Bytef*>(raw.data());
  s.avail_in = static_cast<uInt>(raw.size());
  s.next_out = out.data();
  s.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&s, Z_FINISH), Z_STREAM_END);
  out.resize(s.total_out);
  deflateEnd(&s);
  return out;
}

template <class T>
Bytes nifti_of(std::int16_t datatype, bool swap, float slope, float intercept) {
  Bytes file = nifti_header(3, 2, 2, datatype, swap);
  put(file, 112, slope, swap);
  put(file, 116, intercept, swap);
  for (std::size_t n = 0; n < 12; ++n) put(file, 352 + n * sizeof(T), static_cast<T>(n * 3 + 1), swap);
  return file;
}

TEST(Volume, InrimagePlainAndGzipped) {
  std::vector<std::uint8_t> voxels(24);
  for (std::size_t n = 0; n < 24; ++n) voxels[n] = static_cast<std::uint8_t>(n);
  const Bytes file = inrimage(4, 3, 2, {0.5, 1, 2}, voxels);
  for (const Bytes& bytes : {file, gzip(file)}) {
    const Volume v = parse_volume(bytes, "file");
    EXPECT_EQ(v.dims, (std::array<std::int64_t, 3>{4, 3, 2}));
    EXPECT_NEAR((v.voxel_size - Vec3(0.5e-3, 1e-3, 2e-3)).norm(), 0, 1e-12);
    EXPECT_EQ(v.at(1, 2, 1), 1 + 4 * (2 + 3 * 1));
    EXPECT_NEAR((v.position({1.5, 1, 0.5})).norm(), 0, 1e-15);  // the middle is the origin
  }
}

TEST(Volume, NiftiEveryTypeBothByteOrders) {
  for (const bool swap : {false, true}) {
    const std::vector<Bytes> files = {
        nifti_of<std::uint8_t>(2, swap, 2, -1),    nifti_of<std::int8_t>(256, swap, 2, -1),
        nifti_of<std::int16_t>(4, swap, 2, -1),    nifti_of<std::uint16_t>(512, swap, 2, -1),
        nifti_of<std::int32_t>(8, swap, 2, -1),    nifti_of<std::uint32_t>(768, swap, 2, -1),
        nifti_of<float>(16, swap, 2, -1),          nifti_of<double>(64, swap, 2, -1),
        nifti_of<std::int64_t>(1024, swap, 2, -1), nifti_of<std::uint64_t>(1280, swap, 2, -1),
    };
    for (const Bytes& file : files) {
      const Volume v = parse_volume(file, "file");
      EXPECT_NEAR((v.voxel_size - Vec3(1.5e-3, 2e-3, 2.5e-3)).norm(), 0, 1e-9);
      for (std::size_t n = 0; n < 12; ++n)
        EXPECT_EQ(v.values[n], 2.f * (3.f * static_cast<float>(n) + 1.f) - 1.f);
    }
  }
  // A slope of 0 means unscaled.
  EXPECT_EQ(parse_volume(nifti_of<std::int16_t>(4, false, 0, 5), "file").values[1], 4.f);
}

TEST(Volume, NiftiIsTurnedToRightAnteriorSuperior) {
  Bytes file = nifti_of<std::uint8_t>(2, false, 1, 0);
  put<std::int16_t>(file, 254, 1);
  // File x runs to inferior, y to left, z to anterior.
  const float rows[3][3] = {{0, -2, 0}, {0, 0, 2.5f}, {-1.5f, 0, 0}};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) put(file, 280 + 16 * r + 4 * c, rows[r][c]);
  const Volume v = parse_volume(file, "file");
  EXPECT_EQ(v.dims, (std::array<std::int64_t, 3>{2, 2, 3}));
  EXPECT_NEAR((v.voxel_size - Vec3(2e-3, 2.5e-3, 1.5e-3)).norm(), 0, 1e-9);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        EXPECT_EQ(v.at(1 - j, k, 2 - i), static_cast<float>((i + 3 * (j + 2 * k)) * 3 + 1));
}

bool notes(const Volume& volume, const std::string& text) {
  return std::ranges::any_of(volume.notes,
                             [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

void put_sform(Bytes& file, const Mat3& sform) {
  put<std::int16_t>(file, 254, 1);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      put(file, 280 + 16 * r + 4 * c, static_cast<float>(sform(static_cast<int>(r), static_cast<int>(c))));
}

// Other programs show a volume as its sform says.
TEST(Volume, NiftiTakesTheSformsSizeAndSaysSo) {
  Bytes file = nifti_of<std::uint8_t>(2, false, 1, 0);
  const Mat3 pixdim = Vec3(1.5, 2, 2.5).asDiagonal();
  put_sform(file, pixdim);
  EXPECT_TRUE(parse_volume(file, "file").notes.empty());
  put_sform(file, 2 * pixdim);
  Volume v = parse_volume(file, "file");
  EXPECT_NEAR((v.voxel_size - Vec3(3e-3, 4e-3, 5e-3)).norm(), 0, 1e-9);
  EXPECT_TRUE(notes(v, "1.5 x 2 x 2.5 mm in pixdim and 3 x 4 x 5 mm in the sform"));
  put(file, 80, std::numeric_limits<float>::quiet_NaN());
  EXPECT_NEAR(parse_volume(file, "file").voxel_size[0], 3e-3, 1e-9);
  // An oblique one has the columns' lengths; a sheared one doesn't fit the grid.
  file = nifti_of<std::uint8_t>(2, false, 1, 0);
  const Mat3 oblique = Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized())).toRotationMatrix() * pixdim;
  put_sform(file, oblique);
  EXPECT_TRUE(parse_volume(file, "file").notes.empty());
  Mat3 sheared = pixdim;
  sheared(0, 2) = 1;
  put_sform(file, sheared);
  EXPECT_TRUE(notes(parse_volume(file, "file"), "its sform is sheared"));
  sheared(0, 2) = 3;
  put_sform(file, sheared);
  EXPECT_NE(error_of(file).find("the sform's axes are 36 % sheared; allowed: at most 20 %"),
            std::string::npos)
      << error_of(file);
  // One that spans nothing isn't used, and qform and sform may differ in which side is left.
  put_sform(file, Mat3::Zero());
  EXPECT_TRUE(notes(parse_volume(file, "file"), "its sform is singular"));
  put_sform(file, pixdim);
  put<std::int16_t>(file, 252, 1);
  put(file, 76, 1.f);
  EXPECT_TRUE(parse_volume(file, "file").notes.empty());
  put_sform(file, Vec3(-1.5, 2, 2.5).asDiagonal());
  EXPECT_TRUE(notes(parse_volume(file, "file"), "its sform and qform have different orientations"));
}

TEST(Volume, NiftiScalingThatIsNoNumberIsNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Volume v = parse_volume(nifti_of<std::int16_t>(4, false, nan, nan), "file");
  EXPECT_EQ(v.values[1], 4.f);
  EXPECT_TRUE(notes(v, "no scaling is applied"));
  EXPECT_NE(error_of(nifti_of<std::int16_t>(4, false, 2, nan)), "");
}

TEST(Volume, OtherNiftiFilesNameTheRemedy) {
  Bytes pair = nifti_of<std::int16_t>(4, false, 1, 0);
  pair[345] = 'i';
  EXPECT_NE(error_of(pair).find("save both as one .nii"), std::string::npos) << error_of(pair);
  Bytes second(600);
  put<std::int32_t>(second, 0, 540);
  std::memcpy(second.data() + 4, "n+2", 4);
  EXPECT_NE(error_of(second).find("NIfTI-2: save it as NIfTI-1"), std::string::npos) << error_of(second);
}

// pigz, bgzip and `cat a.gz b.gz` write several.
TEST(Volume, GzipFilesOfSeveralMembersAreRead) {
  std::vector<std::uint8_t> voxels(4000);
  for (std::size_t n = 0; n < voxels.size(); ++n) voxels[n] = static_cast<std::uint8_t>(n % 251);
  const Bytes file = inrimage(20, 20, 10, {1, 1, 1}, voxels);
  Bytes members;
  for (std::size_t at = 0; at < file.size(); at += 100) {
    const auto begin = file.begin() + static_cast<std::ptrdiff_t>(at);
    const Bytes member = gzip(Bytes(begin, begin + std::min<std::ptrdiff_t>(100, file.end() - begin)));
    members.insert(members.end(), member.begin(), member.end());
  }
  const Volume whole = parse_volume(file, "file");
  EXPECT_EQ(parse_volume(members, "file").values, whole.values);
  members.insert(members.end(), 20, 0);  // padding
  EXPECT_EQ(parse_volume(members, "file").values, whole.values);
  members.resize(members.size() / 2);
  EXPECT_NE(error_of(members).find("truncated"), std::string::npos);
}

TEST(Volume, TrilinearSamplingIsExactOnLinearFields) {
  Volume v{{5, 4, 3}, {0.001, 0.002, 0.003}, {}};
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 5; ++i) v.values.push_back(static_cast<float>(1 + 2 * i - 3 * j + 0.5 * k));
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1.25, 2.5, 0.75), Vec3(4, 3, 2), Vec3(3.9, 0.1, 1.99)})
    EXPECT_NEAR(sample(v, v.position(at)), 1 + 2 * at[0] - 3 * at[1] + 0.5 * at[2], 1e-5);
  EXPECT_NEAR(sample(v, v.position({-5, 0, 0})), 1, 1e-6);
}

TEST(Volume, BadFilesAreRefusedByName) {
  const std::vector<std::uint8_t> voxels(8, 1);
  const Bytes good = inrimage(2, 2, 2, {1, 1, 1}, voxels);
  EXPECT_EQ(error_of(good), "");
  Bytes bytes = good;
  bytes.pop_back();
  EXPECT_NE(error_of(bytes).find("truncated"), std::string::npos);
  EXPECT_NE(error_of(gzip(bytes)).find("truncated"), std::string::npos);
  bytes.resize(100);
  EXPECT_NE(error_of(bytes).find("header"), std::string::npos);
  // Huge claims are refused from the header alone.
  EXPECT_NE(error_of(inrimage(8000, 8000, 8000, {1, 1, 1}, voxels)).find("allowed: at most"),
            std::string::npos);
  EXPECT_NE(error_of(inrimage(2000000000, 1, 1, {1, 1, 1}, voxels)).find("allowed: 1 to"), std::string::npos);
  EXPECT_NE(error_of(inrimage(0, 2, 2, {1, 1, 1}, voxels)).find("allowed: 1 to"), std::string::npos);
  EXPECT_NE(error_of(inrimage(2, 2, 2, {0, 1, 1}, voxels)).find("voxel size"), std::string::npos);
  EXPECT_NE(error_of(inrimage(2, 2, 2, {1, 1, 1e9}, voxels)).find("voxel size"), std::string::npos);
  EXPECT_NE(error_of(Bytes{'h', 'i'}).find("not a volume"), std::string::npos);
  EXPECT_NE(error_of({}).find("not a volume"), std::string::npos);
  Bytes damaged = gzip(good);
  damaged[damaged.size() / 2] ^= 0xff;
  damaged.resize(damaged.size() - 12);
  EXPECT_NE(error_of(damaged), "");

  Bytes nan = nifti_of<float>(16, false, 1, 0);
  put(nan, 352 + 4 * 4, std::numeric_limits<float>::quiet_NaN());
  EXPECT_NE(error_of(nan).find("voxel (1, 1, 0) is not a finite number"), std::string::npos) << error_of(nan);
  Bytes complex_type = nifti_of<float>(32, false, 1, 0);
  EXPECT_NE(error_of(complex_type).find("datatype 32"), std::string::npos);
  Bytes series = nifti_of<std::uint8_t>(2, false, 1, 0);
  put<std::int16_t>(series, 40, 4);
  put<std::int16_t>(series, 48, 9);
  EXPECT_NE(error_of(series).find("one 3-D volume"), std::string::npos);
  EXPECT_THROW(load_volume("/nonexistent/volume.inr"), InputError);
}

TEST(Mask, LabelKeepsTheLargestPieceAndListsWhatIsThere) {
  const Volume v = parse_volume(two_balls(), "balls");
  const Mask mask = mask_of_label(v, 7, 2, "balls");
  EXPECT_EQ(mask.dropped_pieces, 1u);
  EXPECT_EQ(mask.dropped_voxels, 1u);
  double inside = 0;
  for (const float x : mask.volume.values) inside += static_cast<double>(x);
  EXPECT_NEAR(inside, 4.0 / 3 * M_PI * 12 * 12 * 12, 0.02 * inside);
  try {
    mask_of_label(v, 8, 2, "balls");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("label 8 does not occur; allowed: 7, 9"), std::string::npos)
        << e.what();
  }
}

TEST(Mask, ThresholdAndCavities) {
  Volume v{{9, 9, 9}, {0.001, 0.001, 0.001}, std::vector<float>(729, 0.f)};
  for (int k = 2; k < 7; ++k)
    for (int j = 2; j < 7; ++j)
      for (int i = 2; i < 7; ++i) v.values[static_cast<std::size_t>(i + 9 * (j + 9 * k))] = 10;
  v.values[static_cast<std::size_t>(4 + 9 * (4 + 9 * 4))] = 0;  // a hole inside
  const Mask mask = mask_above(v, 5, 1, "cube");
  double inside = 0;
  for (const float x : mask.volume.values) inside += static_cast<double>(x);
  EXPECT_EQ(inside, 125);
  EXPECT_THROW(mask_above(v, 11, 1, "cube"), InputError);
  EXPECT_THROW(mask_above(v, -1, 1, "cube"), InputError);
}

TEST(Mask, SmoothingKeepsABallABall) {
  const Volume v = parse_volume(two_balls(), "balls");
  const SolidField field = smooth_solid(mask_of_label(v, 7, smoothing_margin(1.5), "balls"), 1.5);
  const Vec3 center = v.position({15, 18, 20});
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0, 0.8)}) {
    EXPECT_LT(field.value(center + 0.0228 * direction), 0);
    EXPECT_GT(field.value(center + 0.0252 * direction), 0);
  }
}

}  // namespace
}  // namespace prosector
