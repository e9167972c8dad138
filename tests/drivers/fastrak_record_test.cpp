#include "drivers/protocols/fastrak_record.h"

#include <gtest/gtest.h>

#include <string>

#include "twins/trackers/fastrak_twin.h"

namespace prosector {
namespace {

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

std::string say(FastrakTwin& twin, const std::string& command) {
  std::vector<TwinOutput> out;
  twin.receive(bytes_of(command), 0, out);
  std::string text;
  for (const auto& o : out) text.append(o.bytes.begin(), o.bytes.end());
  return text;
}

FastrakTwinOptions moving() {
  FastrakTwinOptions options;
  options.script.add(0, 0.0, Pose{{0.3, 0.1, -0.4}, Quat(0.8, 0.1, -0.3, 0.5).normalized()});
  return options;
}

TEST(FastrakRecord, ReadsARealLineByWidth) {
  const auto line = bytes_of("02   20.40 -61.06  30.01-150.70 -42.08 156.93\r\n");
  ASSERT_EQ(line.size(), 47u);
  const auto record = fastrak::decode(line, {});
  ASSERT_TRUE(record);
  EXPECT_EQ(record->station, 1u);
  EXPECT_EQ(*record->position, (std::array<float, 3>{20.40f, -61.06f, 30.01f}));
  EXPECT_EQ(*record->angles, (std::array<float, 3>{-150.70f, -42.08f, 156.93f}));
}

TEST(FastrakRecord, WidthsAreTheManuals) {
  EXPECT_EQ(fastrak::record_width({true, {2, 4, 1}}), 29u);
  EXPECT_EQ(fastrak::record_width({true, {2, 11, 1}}), 33u);
  EXPECT_EQ(fastrak::record_width({false, {2, 4, 1}}), 47u);
}

TEST(FastrakRecord, EveryItemRoundTrips) {
  for (const bool binary : {false, true}) {
    for (const auto& item : fastrak::item_table()) {
      FastrakTwin twin(moving(), 0);
      say(twin, binary ? "uf" : "uF");
      EXPECT_EQ(say(twin, "O1," + std::to_string(item.code) + ",1\r"), "");
      std::vector<TwinOutput> out;
      twin.receive(bytes_of("P"), 0, out);
      ASSERT_EQ(out.size(), 1u);
      const auto record = fastrak::decode(out[0].bytes, {binary, {item.code, 1}});
      ASSERT_TRUE(record) << item.name << " binary " << binary;
      std::vector<float> read;
      const auto take = [&](const auto& values) {
        if (!values) return;
        for (const float v : *values) read.push_back(v);
      };
      take(record->position);
      take(record->angles);
      for (const auto& row : record->cosines) take(row);
      take(record->quaternion);
      EXPECT_EQ(read, out[0].values) << item.name << " binary " << binary;
      EXPECT_EQ(read.size(), item.numbers);
    }
  }
}

TEST(FastrakRecord, FramesMapAxesAndInvert) {
  const Pose p = fastrak::from_transmitter({{1, 2, 3}, Quat::Identity()});
  EXPECT_TRUE(p.p.isApprox(Vec3(2, -3, -1), 1e-12));
  // A turn to the right about the transmitter's +Z (down) is a turn to the right about −y.
  const Pose turned = fastrak::from_transmitter({Vec3::Zero(), fastrak::rotation({90, 0, 0})});
  EXPECT_TRUE((turned.q * Vec3(0, 0, -1)).isApprox(Vec3(1, 0, 0), 1e-9));
  const Pose x{{0.1, 0.2, 0.3}, Quat(0.5, -0.5, 0.1, 0.7).normalized()};
  const Pose back = fastrak::to_transmitter(fastrak::from_transmitter(x));
  EXPECT_TRUE(back.p.isApprox(x.p, 1e-12));
  EXPECT_NEAR(std::abs(back.q.dot(x.q)), 1, 1e-12);
}

TEST(FastrakRecord, EulerAnglesInvertRotation) {
  for (const float az : {-170.f, -30.f, 0.f, 100.f})
    for (const float el : {-80.f, 0.f, 45.f})
      for (const float roll : {-120.f, 10.f, 179.f}) {
        const auto angles = fastrak::euler_angles(fastrak::rotation({az, el, roll}));
        EXPECT_NEAR(angles[0], az, 1e-6);
        EXPECT_NEAR(angles[1], el, 1e-6);
        EXPECT_NEAR(angles[2], roll, 1e-6);
      }
}

TEST(FastrakTwin, ReadsBackAndRefusesLikeTheDevice) {
  FastrakTwin twin(moving(), 0);
  EXPECT_EQ(say(twin, "O1\r"), "21O 2 4 1\r\n");
  EXPECT_EQ(say(twin, "l1\r"), "21l1000\r\n");
  EXPECT_EQ(say(twin, "l3,1\rl1\r"), "21l1010\r\n");
  EXPECT_EQ(say(twin, "u"), "");
  EXPECT_EQ(say(twin, "H1\r"), "21H   1.00   0.00   0.00\r\n");
  EXPECT_EQ(say(twin, "H1,,2\rH1\r"), "21H   1.00   2.00   0.00\r\n");
  EXPECT_EQ(say(twin, "A1\r").size(), 68u);
  const std::string status = say(twin, "S");
  EXPECT_EQ(status.size(), 55u);
  EXPECT_EQ(status.substr(0, 6), "21S3F2");
  EXPECT_NE(say(twin, "O1,99\r").find("EC -3"), std::string::npos);
  EXPECT_NE(say(twin, "O1,a\r").find("EC -2"), std::string::npos);
  EXPECT_NE(say(twin, "H\r").find("EC -1"), std::string::npos);
  EXPECT_NE(say(twin, "z").find("EC -99"), std::string::npos);
}

Vec3 reported(FastrakTwin& twin) {
  std::vector<TwinOutput> out;
  twin.receive(bytes_of("P"), 0, out);
  return {out.at(0).values[0], out[0].values[1], out[0].values[2]};
}

TEST(FastrakTwin, MirrorsOutsideTheHemisphere) {
  FastrakTwin twin(moving(), 0);  // transmitter frame: (40, 30, −10) cm
  say(twin, "uf");
  EXPECT_TRUE(reported(twin).isApprox(Vec3(40, 30, -10), 1e-5));
  say(twin, "H1,0,0,1\r");
  EXPECT_TRUE(reported(twin).isApprox(Vec3(-40, -30, 10), 1e-5));
}

TEST(FastrakTwin, AlignsIncrementallyUntilReset) {
  FastrakTwin twin(moving(), 0);
  say(twin, "uf");
  say(twin, "A1,10,0,0,10,1,0,9,0,0\r");  // origin moved by 10 cm, X along the old Y, Y along the old −X
  EXPECT_TRUE(reported(twin).isApprox(Vec3(30, -30, -10), 1e-5));
  say(twin, "A1,10,0,0,10,1,0,9,0,0\r");  // the same again, in the frame now in force
  EXPECT_TRUE(reported(twin).isApprox(Vec3(-30, -20, -10), 1e-5));
  say(twin, "R1\r");
  EXPECT_TRUE(reported(twin).isApprox(Vec3(40, 30, -10), 1e-5));
}

TEST(FastrakTwin, BoresightMakesTheReferenceAngles) {
  FastrakTwin twin(moving(), 0);
  say(twin, "ufG1,10,20,30\rB1\r");
  std::vector<TwinOutput> out;
  twin.receive(bytes_of("P"), 0, out);
  EXPECT_NEAR(out[0].values[3], 10, 1e-4);
  EXPECT_NEAR(out[0].values[4], 20, 1e-4);
  EXPECT_NEAR(out[0].values[5], 30, 1e-4);
}

}  // namespace
}  // namespace prosector
