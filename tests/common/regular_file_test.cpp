// Only regular files are read, and none waits for a writer.

#include "common/regular_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "common/error.h"

namespace prosector {
namespace {

class RegularFile : public testing::Test {
 protected:
  RegularFile() {
    std::string pattern = (std::filesystem::temp_directory_path() / "prosector_file_XXXXXX").string();
    dir_ = mkdtemp(pattern.data());
  }
  ~RegularFile() override { std::filesystem::remove_all(dir_); }

  std::string complaint(const std::filesystem::path& file, std::size_t max_bytes = 100) const {
    try {
      read_regular_file(file, max_bytes);
      return "";
    } catch (const InputError& e) {
      return e.what();
    }
  }

  std::filesystem::path dir_;
};

TEST_F(RegularFile, IsReadWhole) {
  const std::string text("a\0b\n", 4);
  std::ofstream(dir_ / "f", std::ios::binary) << text;
  EXPECT_EQ(read_regular_file(dir_ / "f", 4), text);
  std::ofstream(dir_ / "empty").flush();
  EXPECT_EQ(read_regular_file(dir_ / "empty", 4), "");
}

TEST_F(RegularFile, IsRefusedWhenLarger) {
  std::ofstream(dir_ / "f") << "12345";
  EXPECT_NE(complaint(dir_ / "f", 4).find("at most 4 bytes"), std::string::npos);
}

// /proc says 0 bytes of every file.
TEST_F(RegularFile, IsReadToItsEndWhateverItSaysOfItsSize) {
  EXPECT_GT(read_regular_file("/proc/self/status", 1 << 20).size(), 100u);
  EXPECT_NE(complaint("/proc/self/status", 10).find("at most 10 bytes"), std::string::npos);
}

TEST_F(RegularFile, IsNoPipeFolderOrDevice) {
  alarm(20);  // a pipe without a writer would hang the test
  ASSERT_EQ(mkfifo((dir_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(complaint(dir_ / "pipe"), (dir_ / "pipe").string() + ": is a pipe; allowed: a regular file");
  EXPECT_NE(complaint(dir_).find("is a folder"), std::string::npos);
  EXPECT_NE(complaint("/dev/zero").find("is a device"), std::string::npos);
  EXPECT_NE(complaint(dir_ / "absent").find("absent: cannot be read: No such file"), std::string::npos);
  alarm(0);
}

}  // namespace
}  // namespace prosector
