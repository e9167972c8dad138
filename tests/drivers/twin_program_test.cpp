// prosector-5dt-twin as a program of its own, over its pseudo-terminal.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "common/clock.h"
#include "drivers/config/device_config.h"
#include "drivers/device/driver_table.h"
#include "tests/folders.h"
#include "twins/base/twin.h"

namespace prosector {
namespace {

namespace fs = std::filesystem;

class TwinProgram : public testing::Test {
 protected:
  fs::path folder_ = fs::temp_directory_path() / ("prosector-twin-" + std::to_string(getpid()));
  fs::path link_ = folder_ / "glove", log_ = folder_ / "log.csv";
  pid_t pid_ = -1;

  void SetUp() override {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "script.csv")
        << "time,thumb,index,middle,ring,little\n0,0,0,1,1,1\n9,0,0,1,1,1\n";
  }
  void TearDown() override {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
    fs::remove_all(folder_);
  }

  void start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), build_path("bin/prosector-5dt-twin"));
    pid_ = fork();
    if (pid_ != 0) return;
    if (freopen((folder_ / "output").c_str(), "w", stdout) == nullptr || dup2(1, 2) < 0) _exit(99);
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(98);
  }
  /// The exit status, −1 when a signal ended it.
  int wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string output() const {
    std::ifstream in(folder_ / "output");
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(TwinProgram, ServesItsScriptLogsItAndLeavesNothingBehind) {
  for (const bool hid : {false, true}) {
    SCOPED_TRACE(hid ? "USB" : "serial");
    std::vector<std::string> arguments = {"--script", folder_ / "script.csv", "--link", link_, "--log", log_};
    if (hid) arguments.push_back("--hid");
    start(arguments);
    DeviceConfig config;
    config.glove.calibration = GloveCalibration{};
    config.glove.calibration->open.fill(hid ? 800 : 0);
    config.glove.calibration->closed.fill(hid ? 1300 : 255);
    const auto device = open_device((hid ? "5dt-usb:" : "5dt:") + link_.string(), config);
    std::vector<DeviceSample> samples;
    const std::int64_t end = monotonic_ns() + 10'000'000'000;
    while (samples.size() < 20 && monotonic_ns() < end) {
      device->poll(samples);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_GE(samples.size(), 20u) << device->status().message;
    EXPECT_EQ(samples.back().flexion, (std::array<double, fingers>{0, 0, 1, 1, 1}));
    EXPECT_EQ(samples.back().gesture, Gesture::thumb_index);
    EXPECT_EQ(output(), fs::read_symlink(link_).string() + "\n");

    kill(pid_, SIGTERM);
    EXPECT_EQ(wait(), 0);
    EXPECT_FALSE(fs::is_symlink(link_));
    std::ifstream log(log_);
    std::string line;
    std::getline(log, line);
    EXPECT_EQ(line, "time_ns,station,record,values");
    std::size_t records = 0;
    for (; std::getline(log, line); ++records)
      EXPECT_TRUE(line.ends_with(hid ? ",800,800,1300,1300,1300" : ",0,0,255,255,255")) << line;
    EXPECT_GE(records, samples.size());
  }
}

TEST(ScriptClock, StandsStillAtHoldsUntilItIsLetGoOn) {
  constexpr std::int64_t second = 1'000'000'000;
  ScriptClock clock({.wait_client = true, .holds = {1, 3}}, 5 * second);
  EXPECT_EQ(clock.seconds(9 * second), 0) << "no client yet";
  clock.streaming(10 * second);
  EXPECT_EQ(clock.seconds(10 * second + second / 2), 0.5);
  EXPECT_EQ(clock.seconds(17 * second), 1);
  clock.go_on(20 * second);
  EXPECT_EQ(clock.seconds(21 * second), 2);
  clock.go_on(21 * second);  // before it is there: it will not hold
  EXPECT_EQ(clock.seconds(21 * second), 2);
  EXPECT_EQ(clock.seconds(29 * second), 10);
  clock.go_on(30 * second);
  EXPECT_EQ(clock.seconds(30 * second), 11);
}

TEST_F(TwinProgram, BadInputIsOneLineAndExitStatus2) {
  start({"--script", "/nonexistent.csv"});
  EXPECT_EQ(wait(), 2);
  EXPECT_NE(output().find("/nonexistent.csv"), std::string::npos);
  start({"--rate", "0"});
  EXPECT_NE(wait(), 0);
  EXPECT_NE(output().find("--rate"), std::string::npos);
  start({"--hold", "2,1"});
  EXPECT_EQ(wait(), 2);
  EXPECT_NE(output().find("--hold"), std::string::npos);
}

}  // namespace
}  // namespace prosector
