#include "drivers/camera/tags/board.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "common/error.h"
#include "drivers/camera/base/camera_calibration.h"
#include "drivers/camera/base/image_reader.h"
#include "drivers/camera/printing/board_sheet.h"
#include "drivers/camera/tags/standard_boards.h"
#include "drivers/camera/tags/tag_detector.h"
#include "tests/camera/tag_cases.h"

namespace prosector {
namespace {

std::filesystem::path folder() {
  const std::filesystem::path out = std::filesystem::path(testing::TempDir()) / "prosector_boards";
  std::filesystem::create_directories(out);
  return out;
}

std::filesystem::path written(const std::string& name, const std::string& text) {
  const std::filesystem::path file = folder() / name;
  std::ofstream(file) << text;
  return file;
}

std::string complaint(const std::function<void()>& does) {
  try {
    does();
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Boards, NoCodeIsOnTwoOfThem) {
  std::set<int> codes;
  for (const StandardBoard& row : standard_boards())
    for (const BoardTag& tag : find_board(row.name).tags) {
      EXPECT_TRUE(codes.insert(tag.code).second) << row.name << " " << tag.code;
      EXPECT_LT(tag.code, tag_codes);
    }
}

TEST(Boards, FilesGiveGridsAndSingleTags) {
  const Board grid = load_board(written(
      "grid.toml", "name = \"mine\"\n[grid]\ncolumns = 2\nrows = 1\nsize = 0.04\ngap = 0.01\nfirst = 7\n"));
  EXPECT_EQ(grid.name, "mine");
  ASSERT_EQ(grid.tags.size(), 2u);
  EXPECT_NEAR(grid.tags[1].pose.p.x(), 0.025, 1e-15);
  EXPECT_TRUE(grid.is_flat());
  const Board body = load_board(
      written("body.toml",
              "[[tag]]\ncode = 3\nsize = 0.05\nposition = [0, 0, 0.03]\n[[tag]]\ncode = 4\nsize = 0.05\n"
              "position = [0.03, 0, 0]\norientation = [0.70710678, 0, 0.70710678, 0]\n"));
  EXPECT_EQ(body.name, "body");
  EXPECT_FALSE(body.is_flat());
  EXPECT_NEAR(body.tags[1].corners()[1].z(), -0.025, 1e-8);
}

TEST(Boards, BadFilesSayWhatAndWhere) {
  struct Row {
    const char *text, *says;
  };
  const Row rows[] = {
      {"", "grid: is missing"},
      {"[grid]\ncolumns = 0\nrows = 1\nsize = 0.1\nfirst = 0\n",
       ":2: columns: must be a number from 1 to 40"},
      {"[grid]\ncolumns = 40\nrows = 40\nsize = 0.1\nfirst = 0\n", "first"},
      {"[grid]\ncolumns = 2\nrows = 1\nsize = 0.08\ngap = 0.001\nfirst = 0\n",
       "gap: must be a number from 0.02"},
      {"[[tag]]\ncode = 3\nsize = 0.05\n[[tag]]\ncode = 3\nsize = 0.05\n", "code 3 is on this board already"},
      {"[[tag]]\ncode = 3\nsize = 0.05\norientation = [1, 1, 0, 0]\n", "must be a unit quaternion"},
      {"[[tag]]\ncode = 3\nsize = 0.05\nbend = 1\n", "bend: unknown key of a board"},
      {"[[tag]]\ncode = 3.5\nsize = 0.05\n", "code: must be a whole number"},
      {"[[tag]]\ncode = 3\nsize = nan\n", "size: must be a number"},
      {"[[tag\n", ":1:"},
  };
  for (const Row& row : rows) {
    const auto file = written("bad.toml", row.text);
    const std::string said = complaint([&] { (void)load_board(file); });
    EXPECT_NE(said.find(row.says), std::string::npos) << said;
    EXPECT_NE(said.find("bad.toml"), std::string::npos) << said;
  }
  EXPECT_NE(complaint([] { (void)find_board("tabel"); }).find("table, tablet, calibration"),
            std::string::npos);
}

// What is printed at 300 dots an inch is found where it belongs, to a twentieth of a millimetre.
TEST(BoardSheet, IsTrueToScale) {
  for (const StandardBoard& row : standard_boards()) {
    const Board board = find_board(row.name);
    const auto file = folder() / "sheet.png";
    write_sheet(board, {}, file);
    const auto tags = TagDetector({2}).find(grey_of(read_image(file)));
    ASSERT_EQ(tags.size(), board.tags.size()) << row.name;
    constexpr double metres = 0.0254 / 300;  // a pixel
    for (const DetectedTag& tag : tags) {
      const auto ours = board.find(tag.code)->corners();
      for (std::size_t c = 0; c < 4; ++c)
        for (const DetectedTag& other : tags) {
          const Vec2 printed = metres * (tag.corners[c] - other.corners[0]);
          const Vec3 meant = ours[c] - board.find(other.code)->corners()[0];
          EXPECT_NEAR(printed.x(), meant.x(), 5e-5) << row.name;
          EXPECT_NEAR(printed.y(), -meant.y(), 5e-5) << row.name;
        }
    }
  }
}

TEST(BoardSheet, SaysWhatItCannotPrint) {
  const Board large = grid_board("large", {6, 6, 0.06, 0.015, 0});
  EXPECT_NE(complaint([&] {
              write_sheet(large, {}, folder() / "x.pdf");
            }).find("too large for paper of 297 × 210 mm"),
            std::string::npos);
  const Board small = find_board("tablet");
  EXPECT_NE(complaint([&] { write_sheet(small, {}, folder() / "x.gif"); }).find("must end with"),
            std::string::npos);
  EXPECT_NE(complaint([&] { write_sheet(small, {}, "/nowhere/x.pdf"); }).find("cannot be written"),
            std::string::npos);
  EXPECT_NE(complaint([&] { write_sheet(small, {}, "/nowhere/x.png"); }).find("cannot be written"),
            std::string::npos);
  EXPECT_NE(complaint([] { (void)paper_named("a9"); }).find("a3, a4 or letter"), std::string::npos);
}

TEST(BoardSheet, PdfHasThePapersSize) {
  const auto file = folder() / "sheet.pdf";
  write_sheet(find_board("table"), {}, file);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  EXPECT_NE(bytes.find("/MediaBox [ 0 0 841.88"), std::string::npos);
}

TEST(CameraCalibrationFile, ComesBackAsItWas) {
  CameraCalibration written_one{"Webcam \"C\" \\ \x01x", usual_lens(), 2.1, 0.08};
  const CameraCalibration read = parse_calibration(write_calibration(written_one), "camera.toml");
  EXPECT_EQ(read.camera, "Webcam C  x");
  EXPECT_NEAR(read.lens.cx, written_one.lens.cx, 1e-4);
  EXPECT_NEAR(read.lens.k1, written_one.lens.k1, 1e-7);
  EXPECT_NEAR(read.response, 2.1, 1e-3);
  EXPECT_NE(complaint([] { (void)parse_calibration("version = 2\n", "c.toml"); }).find("c.toml:1: version"),
            std::string::npos);
}

// Whatever bytes a file has, it is read or refused in words.
TEST(CameraCalibrationFile, DamagedTextsAreRefusedOrRead) {
  Random random(test_seed(true));
  const std::string whole = write_calibration({"cam", usual_lens(), 2.2, 0.1});
  int refused = 0;
  for (int k = 0; k < 2000; ++k) {
    std::string text = whole;
    for (std::size_t n = 1 + random.below(3); n > 0; --n)
      text[random.below(text.size())] = static_cast<char>(random.below(256));
    if (complaint([&] { (void)parse_calibration(text, "c.toml"); }) != "none") ++refused;
  }
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace prosector
