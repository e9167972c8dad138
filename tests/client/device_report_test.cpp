// What a self-test says of devices that are well, and of each thing that isn't.
#include "client/app/commands/device_report.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

struct Doing {
  std::int64_t interval_ns = 10'000'000;
  std::int64_t tenth_gap = 1;  // of every tenth record, in intervals
  bool jumps = false, odd_quaternion = false, falls = false;
  DeviceStatus status{DeviceHealth::streaming, 0, 0, 0, 0, ""};
};

DeviceReport report_of(const Doing& doing, bool is_camera = false) {
  DeviceReport out("test:it", is_camera);
  DeviceStatus status = doing.status;
  std::int64_t time_ns = 1'000'000'000;
  for (int k = 0; k < 500; ++k) {
    time_ns += doing.interval_ns * (k % 10 == 0 ? doing.tenth_gap : 1);
    DeviceSample sample;
    sample.time_ns = time_ns - (doing.falls && k == 99 ? 100'000'000 : 0);
    sample.has_pose = sample.has_flexion = true;
    sample.pose.p = {1e-3 * k + (doing.jumps && k == 50 ? 1 : 0), 1, 0};
    sample.raw_pose = {0, 0, 0, doing.odd_quaternion && k == 7 ? 0.9f : 1.0f, 0, 0, 0};
    sample.flexion.fill(k % 2);
    sample.gesture = k % 2 == 0 ? Gesture::flat : Gesture::fist;
    sample.buttons = 1;
    ++status.records;
    out.take({sample}, status, 0.01 * k);
  }
  return out;
}

TEST(DeviceReport, AWellDeviceFits) {
  const DeviceReport report = report_of({});
  EXPECT_TRUE(report.fits()) << report.text();
  EXPECT_NE(report.text().find("100.0 records per second"), std::string::npos) << report.text();
  EXPECT_EQ(report.text().find("not seen"), std::string::npos) << report.text();
}

TEST(DeviceReport, EachFaultIsFound) {
  const auto with = [](auto change) {
    Doing doing;
    change(doing);
    return report_of(doing);
  };
  for (const auto& [words, report] : std::initializer_list<std::pair<const char*, DeviceReport>>{
           {"about 196 records are missing", with([](Doing& d) { d.tenth_gap = 5; })},
           {"2 jumps", with([](Doing& d) { d.jumps = true; })},
           {"1 quaternions", with([](Doing& d) { d.odd_quaternion = true; })},
           {"1 decreasing timestamps", with([](Doing& d) { d.falls = true; })},
           {"invalid data skipped 3 times", with([](Doing& d) { d.status.resyncs = 3; })},
           {"reopened 1 times", with([](Doing& d) { d.status.reopens = 1; })},
           {"state at the end: silent", with([](Doing& d) { d.status.health = DeviceHealth::silent; })}}) {
    EXPECT_FALSE(report.fits()) << words;
    const std::string text = report.text();
    const auto at = text.find(words);
    ASSERT_NE(at, std::string::npos) << words << "\n" << text;
    EXPECT_EQ(text.substr(text.rfind('\n', at) + 1, 12), "DOES NOT FIT") << text;
  }
}

TEST(DeviceReport, ACameraMayPassOverImages) {
  Doing doing;
  doing.tenth_gap = 3;
  const DeviceReport some = report_of(doing, true);
  EXPECT_TRUE(some.fits()) << some.text();
  EXPECT_NE(some.text().find("not seen      station 1: in about 98 images"), std::string::npos)
      << some.text();
  doing.tenth_gap = 20;
  EXPECT_FALSE(report_of(doing, true).fits()) << "most images gave nothing";
}

TEST(DeviceReport, NothingIsNoFit) {
  DeviceReport report("test:it", false);
  report.take({}, {DeviceHealth::absent, 0, 0, 0, 0, "nobody there"}, 1);
  EXPECT_FALSE(report.fits());
  EXPECT_NE(report.text().find("absent: nobody there"), std::string::npos) << report.text();
}

}  // namespace
}  // namespace prosector
