// Device bytes, cut, mixed with garbage and mutated: what comes out must be what went in, or nothing.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "common/error.h"
#include "drivers/ports/timestamped_buffer.h"
#include "drivers/protocols/fastrak_record.h"
#include "drivers/protocols/five_dt_record.h"
#include "drivers/protocols/igtl_messages.h"
#include "drivers/recordings/motion_script.h"
#include "drivers/recordings/recorded.h"
#include "idl/message.h"
#include "tests/gesture_bends.h"

namespace prosector {
namespace {

TEST(ParserFuzz, RandomBytesNeverMakeImplausibleRecords) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 300000; ++i) {
    fastrak::Format format{random() % 2 == 0, {2, 11, 1}};
    std::vector<std::uint8_t> bytes(fastrak::record_width(format));
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
    bytes[0] = '0';
    bytes[1] = static_cast<std::uint8_t>('1' + random() % 4);
    bytes[2] = ' ';
    bytes[bytes.size() - 2] = '\r';
    bytes[bytes.size() - 1] = '\n';
    if (const auto r = fastrak::decode(bytes, format)) {
      for (const float x : *r->position) EXPECT_TRUE(std::abs(x) <= 1000);
      for (const float x : *r->quaternion) EXPECT_TRUE(std::abs(x) <= 1.01f);
    }
    bytes.resize(random() % 70);
    five_dt::decode_report(bytes);
    five_dt::decode_packet(bytes, false);
    fastrak::decode(bytes, format);
  }
}

// What is read of a spoilt IMAGE has as many bytes as its size says, or is nothing.
TEST(ParserFuzz, SpoiltImagesAreWholeOrNone) {
  std::mt19937_64 random(13);
  const Image image{7, 5, std::vector<std::uint8_t>(7 * 5 * 3, 90)};
  int read = 0;
  for (int i = 0; i < 100000; ++i) {
    igtl::Message message{igtl::image_type, "Camera", igtl::image_body(image)};
    for (std::uint64_t k = random() % 4; k > 0; --k)
      message.body[random() % 40] = static_cast<std::uint8_t>(random() % 2 == 0 ? random() : random() % 8);
    if (random() % 4 == 0) message.body.resize(random() % (message.body.size() + 40));
    if (const auto back = igtl::image_of(message)) {
      ++read;
      EXPECT_EQ(back->rgb.size(), static_cast<std::size_t>(3 * back->width * back->height));
    }
    // The same bytes in a stream, cut anywhere.
    if (i % 50 != 0) continue;
    igtl::Bytes stream;
    igtl::put(stream, message);
    if (random() % 2 == 0) stream[random() % 58] ^= static_cast<std::uint8_t>(1 + random() % 255);
    igtl::Reader reader(true);
    for (std::size_t at = 0; at < stream.size();) {
      const std::size_t count = std::min<std::size_t>(1 + random() % 60, stream.size() - at);
      reader.take(std::span(stream).subspan(at, count));
      at += count;
      while (const auto next = reader.next()) (void)igtl::image_of(*next);
    }
  }
  EXPECT_GT(read, 10000);
  EXPECT_LT(read, 90000);
}

// Sixteen bits are stretched from the least to the greatest, with and without sign, in both orders of bytes.
TEST(IgtlImage, SixteenBitsAreStretched) {
  struct Row {
    std::uint8_t type, endian;
    std::vector<std::uint8_t> words;
    std::vector<std::uint8_t> grey;
  };
  const Row rows[] = {{5, 2, {0, 0, 0xff, 0, 0xfe, 1}, {0, 127, 255}},
                      {5, 1, {0, 0, 0, 0xff, 1, 0xfe}, {0, 127, 255}},
                      {4, 2, {0xff, 0xff, 0, 0, 1, 0}, {0, 127, 255}},
                      {3, 2, {10, 20, 30}, {10, 20, 30}},
                      {10, 2, {10, 20, 30}, {}},
                      {3, 2, {10, 20}, {}}};
  for (const Row& row : rows) {
    igtl::Message message{igtl::image_type, "CT", igtl::image_body({3, 1, std::vector<std::uint8_t>(9)})};
    message.body.resize(message.body.size() - 9);
    message.body[2] = 1;
    message.body[3] = row.type;
    message.body[4] = row.endian;
    message.body.insert(message.body.end(), row.words.begin(), row.words.end());
    const auto image = igtl::image_of(message);
    ASSERT_EQ(image.has_value(), !row.grey.empty()) << int{row.type};
    for (std::size_t i = 0; image && i < 3; ++i) EXPECT_EQ(image->rgb[3 * i], row.grey[i]);
  }
}

TEST(TimestampedBuffer, EveryByteKeepsItsChunksTime) {
  TimestampedBuffer buffer;
  const std::array<std::uint8_t, 3> a = {1, 2, 3};
  buffer.append(a, 10);
  buffer.append(a, 20);
  buffer.drop(2);
  EXPECT_EQ(buffer.time_ns(), 10);
  buffer.drop(1);
  EXPECT_EQ(buffer.time_ns(), 20);
  buffer.append(a, 30);
  buffer.drop(4);
  EXPECT_EQ(buffer.time_ns(), 30);
  EXPECT_EQ(buffer.bytes().size(), 2u);
  buffer.drop(99);
  EXPECT_EQ(buffer.time_ns(), 0);
}

class Files : public testing::Test {
 protected:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("prosector-files-" + std::to_string(getpid()) + ".csv");
  void write(const std::string& text) { std::ofstream(path_) << text; }
  void TearDown() override { std::filesystem::remove(path_); }
};

TEST_F(Files, RecordingsRoundTrip) {
  DeviceSample a;
  a.station = 2;
  a.time_ns = 5'000'000'000;
  a.has_pose = true;
  a.pose = {{0.1, -0.2, 1.0 / 3}, Quat(0.5, 0.5, -0.5, 0.5)};
  DeviceSample b;
  b.time_ns = 5'250'000'000;
  b.has_flexion = true;
  b.flexion = {0, 0.25, 0.5, 0.75, 1};
  b.gesture = Gesture::two;
  b.buttons = 3;
  ASSERT_TRUE(SampleRecorder(path_).write({a, b}));
  const auto read = load_recording(path_);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].sample.station, 2u);
  EXPECT_EQ(read[0].sample.pose.p, a.pose.p);
  EXPECT_FALSE(read[0].sample.has_flexion);
  EXPECT_DOUBLE_EQ(read[1].time, 0.25);
  EXPECT_FALSE(read[1].sample.has_pose);
  EXPECT_EQ(read[1].sample.flexion, b.flexion);
  EXPECT_EQ(read[1].sample.gesture, Gesture::two);
  EXPECT_EQ(read[1].sample.buttons, 3u);
}

TEST_F(Files, RecordingsKeepEachGesture) {
  std::vector<DeviceSample> made;
  for_gestures([&](const GestureRow& row) {
    DeviceSample& sample = made.emplace_back();
    sample.time_ns = std::ssize(made) * 10'000'000;
    sample.has_flexion = true;
    sample.flexion = bends_of(row);
    sample.gesture = row.gesture;
  });
  ASSERT_TRUE(SampleRecorder(path_).write(made));
  const auto read = load_recording(path_);
  ASSERT_EQ(read.size(), made.size());
  for (std::size_t k = 0; k < made.size(); ++k) EXPECT_EQ(read[k].sample.gesture, made[k].gesture) << k;
}

TEST_F(Files, ScriptsRestAtKeyframesAndLoop) {
  write("time,x,y,z\n0,0,0,0\n2,1,0,0\n");
  const MotionScript script = MotionScript::load(path_);
  EXPECT_EQ(script.pose(0, -1, false).p.x(), 0);
  EXPECT_DOUBLE_EQ(script.pose(0, 1, false).p.x(), 0.5);
  EXPECT_EQ(script.pose(0, 9, false).p.x(), 1);
  EXPECT_DOUBLE_EQ(script.pose(0, 3, true).p.x(), 0.5);
  EXPECT_LT(script.pose(0, 0.01, false).p.x(), 1e-5);
}

TEST_F(Files, BadFilesSayWhere) {
  for (const char* text : {"", "time,wrong\n0,1\n", "time,x,y,z\n0,1\n", "time,x,y,z\n0,1,nan,2\n",
                           "time,x,y,z\n0,1,,2\n", "time,thumb\n0,2\n", "time,station,x,y,z\n0,7,0,0,0\n",
                           "time,x,y,z\n1,0,0,0\n0,0,0,0\n", "time,x,y,z,qw,qx,qy,qz\n0,0,0,0,2,0,0,0\n"}) {
    write(text);
    EXPECT_THROW(MotionScript::load(path_), InputError) << text;
    EXPECT_THROW(load_recording(path_), InputError) << text;
  }
  EXPECT_THROW(load_recording("/nonexistent.csv"), InputError);
  EXPECT_THROW(SampleRecorder("/nonexistent/x.csv"), InputError);
}

}  // namespace
}  // namespace prosector
