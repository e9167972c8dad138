// What is sealed comes back whole or not at all.

#include "common/sealed_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace prosector {
namespace {

struct SealedFile : testing::Test {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("prosector-sealed." + std::to_string(getpid()));
  std::filesystem::path file = folder / "a" / "b";
  std::vector<std::uint8_t> bytes = {0, 1, 2, 255, 128, 7};

  ~SealedFile() override { std::filesystem::remove_all(folder); }
};

TEST_F(SealedFile, ComesBackUnderItsKeyOnly) {
  EXPECT_FALSE(read_sealed_file(file, "key").bytes);
  EXPECT_EQ(read_sealed_file(file, "key").error, "");  // no file is no error
  ASSERT_TRUE(write_sealed_file(file, "key", bytes));
  EXPECT_EQ(read_sealed_file(file, "key").bytes, bytes);
  EXPECT_FALSE(read_sealed_file(file, "another").bytes);
  EXPECT_EQ(read_sealed_file(file, "another").error, "is damaged");
  ASSERT_TRUE(write_sealed_file(file, "empty", {}));
  EXPECT_EQ(read_sealed_file(file, "empty").bytes, std::vector<std::uint8_t>());
}

TEST_F(SealedFile, AnyFlippedBitAndAnyLostByteIsNoticed) {
  ASSERT_TRUE(write_sealed_file(file, "key", bytes));
  std::ifstream in(file, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(in), {});
  const auto refuses = [&](const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
    const SealedFileResult found = read_sealed_file(file, "key");
    return !found.bytes && !found.error.empty();
  };
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    EXPECT_TRUE(refuses(flipped)) << bit;
  }
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_TRUE(refuses(whole.substr(0, size)));
  EXPECT_TRUE(refuses(whole + "x"));
}

TEST_F(SealedFile, AFolderThatCannotBeMadeIsNoError) {
  EXPECT_FALSE(write_sealed_file("/proc/nowhere/file", "key", bytes));
}

}  // namespace
}  // namespace prosector
