#pragma once
// A driver behind a vendor's library and the library's twin, in the test's time.

#include <gtest/gtest.h>

#include <future>
#include <random>
#include <string>

#include "drivers/device/arm.h"
#include "drivers/ports/shared_library.h"
#include "tests/folders.h"
#include "tests/haptics/press_case.h"
#include "twins/arms/library_twin.h"

namespace prosector {

inline std::string twin_library(const std::string& name) {
  return build_path("lib/twins/" + name);
}

/// The twin of one library, and the driver `DriverArm` of what it plays.
template <class DriverArm>
class LibraryArmCase : public testing::Test {
 protected:
  LibraryArmCase(const std::string& device, const char* library)
      : library_(twin_library(library)), address_(device + "@" + library_), twin_(reach(library_)) {
    twin_.restart(pressing_hand(), now_ns_, 1);
  }

  std::string library_, address_;
  std::int64_t now_ns_ = 1;
  LibraryTwin& twin_;
  std::unique_ptr<DriverArm> arm_ = open(address_);

  std::unique_ptr<DriverArm> open(const std::string& address) {
    return std::make_unique<DriverArm>(address, ArmConfig{pressing_hand().room_arm}, std::launch::deferred,
                                       [this] { return now_ns_; });
  }
  /// Lets both go on. Returns the last reading.
  ArmReading go(double seconds, const Vec3& force = Vec3::Zero()) {
    ArmReading out;
    for (int k = 0; k < static_cast<int>(1000 * seconds); ++k) {
      now_ns_ += ms;
      twin_.advance(now_ns_);
      out = arm_->read();
      arm_->set_force(force);
    }
    return out;
  }
  PressResult pressed(double stiffness) {
    return press(*arm_, *twin_.arm(), stiffness, now_ns_, [&](std::int64_t now) { twin_.advance(now); });
  }
  Pose stylus_in_room() const {
    const HeldArm& held = *twin_.arm();
    return held.room_arm() * Pose{held.model().position(), held.orientation()};
  }
  std::string message() const { return arm_->status().message; }
  bool says(const std::string& words) const { return message().find(words) != std::string::npos; }
  /// Expects that what it reads is where the twin's arm is.
  void expect_there(const ArmReading& reading) const {
    ASSERT_TRUE(reading.valid) << message();
    EXPECT_NEAR((reading.stylus.p - stylus_in_room().p).norm(), 0, 1e-4);
    EXPECT_NEAR(reading.stylus.q.angularDistance(stylus_in_room().q), 0, 1e-9);
  }

 private:
  static LibraryTwin& reach(const std::string& library) {
    LibraryTwin* (*function)() = nullptr;
    SharedLibrary(library).find(twin_function, function);
    return *function();
  }
};

}  // namespace prosector
