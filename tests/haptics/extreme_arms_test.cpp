// Numbers that no arm means, from every arm of the table, and forces that no arm can have: no pose comes of
// the first, they are counted, and the second are bounded.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "common/commands.h"
#include "drivers/arms/dhd.h"
#include "drivers/arms/hdapi.h"
#include "drivers/arms/inverse3.h"
#include "drivers/arms/omni.h"
#include "drivers/arms/omni_arm_math.h"
#include "drivers/arms/vrpn_arm.h"
#include "drivers/device/plausible.h"
#include "drivers/protocols/omni_packets.h"
#include "tests/haptics/library_arm_case.h"
#include "twins/arms/omni_body.h"

namespace prosector {
namespace {

using Limits = std::numeric_limits<double>;
constexpr std::array extremes = {
    1e308, -1e308, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), 0., Limits::denorm_min(),
    1e-200};

struct Outcome {
  bool valid = false;         // a reading with the extreme number as its stylus' rotation
  std::uint64_t counted = 0;  // what the driver counted as garbage
  double force = 0;           // N: that the arm got where the client asked for the extreme number
};

/// A twin behind a vendor's library, all of whose numbers are the extreme one for some cycles.
template <class DriverArm>
struct Library : LibraryArmCase<DriverArm> {
  Library(const std::string& device, const char* library) : LibraryArmCase<DriverArm>(device, library) {}
  void TestBody() override {}

  Outcome outcome(double extreme) {
    Outcome out;
    EXPECT_TRUE(this->go(0.5).valid);
    this->go(0.005, {extreme, -extreme, extreme});
    out.force = this->twin_.arm()->model().force().norm();
    this->twin_.faults.instead = extreme;
    const auto before = this->arm_->status().resyncs;
    out.valid = this->go(0.005).valid;
    out.counted = this->arm_->status().resyncs - before;
    return out;
  }
};

Outcome from_hdapi(double extreme) {
  return Library<HdapiArm>("default", "libHD.so").outcome(extreme);
}
Outcome from_dhd(double extreme) {
  return Library<DhdArm>("0", "libdhd.so").outcome(extreme);
}

std::string json(double number) {
  return std::isfinite(number) ? fmt::format("{}", number) : "null";
}
std::string haply_text(const std::string& q) {
  return R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":0,"y":0,"z":0.1}}}],)"
         R"("wireless_verse_grip":[{"state":{"orientation":{"w":)" +
         q + R"(,"x":)" + q + R"(,"y":)" + q + R"(,"z":)" + q + "}}}]}";
}
Outcome from_inverse3(double extreme) {
  std::int64_t now_ns = 1;
  Inverse3Arm arm({}, [&] { return now_ns; });
  Outcome out;
  arm.handle_text(haply_text("0.5"));
  EXPECT_TRUE(arm.read().valid);
  arm.set_force({extreme, -extreme, extreme});
  const auto force = inverse3::force_of(arm.handle_text(haply_text("0.5")));
  out.force = force ? force->force.norm() : Limits::infinity();
  (void)arm.read();
  const auto before = arm.status().resyncs;
  arm.handle_text(haply_text(json(extreme)));
  out.valid = arm.read().valid;
  out.counted = arm.status().resyncs - before;
  return out;
}

/// A VRPN server that says what it is told to, and keeps what it hears.
struct Said {
  vrpn::Bytes to_driver, from_driver;
};
class SaidLine final : public ByteStream {
 public:
  explicit SaidLine(Said& said) : said_(said) {}
  bool receive(vrpn::Bytes& out) override {
    out.insert(out.end(), said_.to_driver.begin(), said_.to_driver.end());
    said_.to_driver.clear();
    return true;
  }
  void send(std::span<const std::uint8_t> bytes) override {
    said_.from_driver.assign(bytes.begin(), bytes.end());
  }
  const std::string& error() const override { return error_; }

 private:
  Said& said_;
  std::string error_;
};
Outcome from_vrpn(double extreme) {
  std::int64_t now_ns = 1;
  Said said;
  VrpnArm arm(
      "Arm", {}, [&] { return std::make_unique<SaidLine>(said); }, std::launch::deferred,
      [&] { return now_ns; });
  const auto tell = [&](double q) {
    vrpn::put(said.to_driver, {1, 1, vrpn::body_of(vrpn::TrackerPose{0, Vec3::Zero(), Quat(q, q, q, q)})});
    now_ns += ms;
    return arm.read();
  };
  said.to_driver = vrpn::cookie();
  vrpn::put(said.to_driver, vrpn::naming(vrpn::names_sender, 1, "Arm"));
  vrpn::put(said.to_driver, vrpn::naming(vrpn::names_type, 1, vrpn::pose_type));
  EXPECT_TRUE(tell(0.5).valid);
  Outcome out;
  arm.set_force({extreme, -extreme, extreme});
  constexpr std::size_t header = 24;
  const auto field = vrpn::field_of(vrpn::Bytes(said.from_driver.begin() + header, said.from_driver.end()));
  out.force = field ? field->force.norm() : 0;  // what is no number isn't sent
  out.valid = tell(extreme).valid;
  out.counted = arm.status().resyncs;
  return out;
}

/// The Omni sends counts. What can't be an angle is a pot without voltage.
Outcome from_omni(double extreme) {
  auto packet = omni_body::state_packet({0, 0, 0}, Vec3::Zero(), false, 0);
  for (const std::size_t at : {10u, 11u, 22u, 23u}) packet[at] = 0;
  const bool read = omni::state_of(packet).has_value();
  omni::Command command;
  command.motors =
      omni::commands_for(omni::docked, bounded_force({extreme, -extreme, extreme}, omni_limits().peak_force));
  command.motors_on = true;
  const auto motors = omni_body::motors_of(omni::bytes_of(command));
  EXPECT_TRUE(motors);
  const Vec3 force = omni_body::force_of(omni_body::in_inkwell(), motors->shares);
  return {read, read ? 0u : 1u, force.norm()};
}

TEST(ExtremeArms, AreNoPoseAndAreCountedAndForcesAreBounded) {
  const std::map<std::string, Outcome (*)(double)> feeders = {
      {"omni", from_omni}, {"omni-twin", from_omni}, {"hdapi", from_hdapi},
      {"dhd", from_dhd},   {"vrpn", from_vrpn},      {"inverse3", from_inverse3},
  };
  constexpr double strongest = 12;  // N: of all arms' peak forces
  for (const ArmRow& row : arm_drivers()) {
    ASSERT_TRUE(feeders.contains(row.name)) << row.name << " has no test of extreme values";
    for (const double extreme : extremes) {
      SCOPED_TRACE(fmt::format("{} {}", row.name, extreme));
      const Outcome outcome = feeders.at(row.name)(extreme);
      EXPECT_FALSE(outcome.valid);
      EXPECT_GT(outcome.counted, 0u);
      EXPECT_LE(outcome.force, strongest * (1 + 1e-3)) << "finite, too";
    }
  }
}

}  // namespace
}  // namespace prosector
