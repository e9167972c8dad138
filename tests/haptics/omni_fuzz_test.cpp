// Garbage from an Omni, and to its twin.
#include <gtest/gtest.h>

#include <random>

#include "drivers/protocols/omni_packets.h"
#include "twins/arms/omni_twin.h"

namespace prosector {
namespace {

TEST(OmniFuzz, NoPacketOfAnyBytesIsMoreThanAState) {
  std::mt19937_64 random(11);
  for (int k = 0; k < 20000; ++k) {
    std::vector<std::uint8_t> bytes(random() % 64);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    if (bytes.size() == omni::state_bytes && k % 2 == 0) {  // as good as valid
      bytes[0] = bytes[1] = bytes[3] = 0;
      bytes[2] = 0x1e;
      bytes[28] = 0x46;
      bytes[29] = 0x57;
    }
    if (const auto state = omni::state_of(bytes)) {
      EXPECT_TRUE(omni::gimbal_of(*state).allFinite());
    }
    if (const auto motors = omni_body::motors_of(bytes)) {
      EXPECT_LE(motors->shares.cwiseAbs().maxCoeff(), 1);
    }
  }
}

TEST(OmniFuzz, ATwinBearsWhateverIsWritten) {
  std::mt19937_64 random(12);
  OmniTwinOptions options;
  options.script.add(0, 0, Pose{Vec3(0.01, 0, 0), Quat::Identity()});
  OmniTwin twin(std::move(options), 0);
  std::int64_t now = 0;
  for (int k = 0; k < 5000; ++k) {
    now += static_cast<std::int64_t>(random() % 3'000'000);
    std::vector<std::uint8_t> bytes(random() % 20);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    twin.command(bytes);
    twin.write(k % 50 == 0 ? omni_body::control_register : random(), bytes, now);
    (void)twin.advance(now);
    ASSERT_TRUE(twin.model().position().allFinite());
    ASSERT_LT(twin.model().position().norm(), 1);
  }
}

}  // namespace
}  // namespace prosector
