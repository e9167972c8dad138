// Arms that have threads of their own, in the client's servo, in real time: what the library's twin says in
// the environment is what its hand does.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "client/haptics/servo_thread.h"
#include "tests/folders.h"
#include "tests/haptics/arm_line_case.h"

namespace prosector {
namespace {

constexpr double stiffness = 300;  // N/m

/// Writes what the hand does: it goes 10 mm below the plane at height 0, and stays.
std::filesystem::path script() {
  const auto file = std::filesystem::path(testing::TempDir()) / "arm_thread_press.csv";
  std::ofstream(file) << "time,x,y,z\n0,0,0.02,0\n0.5,0,-0.01,0\n";
  return file;
}

/// Waits until the servo's force is the plane's at its place, and the hand's press is all there.
bool comes_to_press(ServoThread& servo, const std::vector<ContactPlane>& planes) {
  const bool came = comes_true([&] {
    servo.feel(planes);
    const ServoView view = servo.view();
    const double depth = -view.reading.stylus.p.y();
    return view.reading.valid && depth > 3e-3 && std::abs(view.force_now.y() - stiffness * depth) < 0.03;
  });
  if (came) return true;
  const ServoView view = servo.view();
  ADD_FAILURE() << view.status.message << " valid " << view.reading.valid << " y "
                << view.reading.stylus.p.y() << " m, force " << view.force_now.y() << " N";
  return false;
}

class ArmInServo : public testing::TestWithParam<std::string> {};

TEST_P(ArmInServo, PressesAndEnds) {
  const auto words = "--script " + script().string();
  ::setenv("PROSECTOR_TWIN", words.c_str(), 1);
  ContactPlane plane;
  plane.id = 1;
  plane.stiffness = plane.tangential = stiffness;
  for (int k = 0; k < 2; ++k) {  // the second time, what was closed is opened again
    ServoThread servo(open_arm(GetParam(), {}), Pose{});
    EXPECT_TRUE(comes_to_press(servo, {plane}));
  }
}

INSTANTIATE_TEST_SUITE_P(Libraries, ArmInServo,
                         testing::Values("hdapi:default@" + build_path("lib/twins/libHD.so"),
                                         "dhd:default@" + build_path("lib/twins/libdhd.so")));

}  // namespace
}  // namespace prosector
