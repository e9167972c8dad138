// What the set-up window says of the machine.
#include "client/setup/machine_checks.h"

#include <gtest/gtest.h>

#include "tests/session/temporary_file.h"
#include "tests/setup/written_file.h"

namespace prosector::test {
namespace {

TEST(MachineChecks, JudgePicturesByHowSmoothTheyAre) {
  EXPECT_EQ(check_pictures(0.005, "a card").state, CheckState::good);
  EXPECT_EQ(check_pictures(0.03, "a card").state, CheckState::fair);
  const MachineCheck slow = check_pictures(0.2, "llvmpipe");
  EXPECT_EQ(slow.state, CheckState::bad);
  EXPECT_NE(slow.words.find("200.0 ms"), std::string::npos);
  EXPECT_NE(slow.words.find("llvmpipe"), std::string::npos);
  EXPECT_NE(slow.words.find("--quality low"), std::string::npos) << "what to do";
}

TEST(MachineChecks, JudgeCores) {
  EXPECT_EQ(check_cores(1).state, CheckState::bad);
  EXPECT_EQ(check_cores(2).state, CheckState::fair);
  EXPECT_EQ(check_cores(16).state, CheckState::good);
}

TEST(MachineChecks, JudgeWhatSocketsKeep) {
  const TemporaryFile limit("rmem_max");
  EXPECT_EQ(check_network_buffers(limit.path).state, CheckState::unknown);
  write_file(limit.path, "212992\n");
  const MachineCheck small = check_network_buffers(limit.path);
  EXPECT_EQ(small.state, CheckState::fair);
  EXPECT_NE(small.words.find("208 kB"), std::string::npos);
  EXPECT_NE(small.words.find("net.core.rmem_max="), std::string::npos) << "what to do";
  write_file(limit.path, "4194304\n");
  EXPECT_EQ(check_network_buffers(limit.path).state, CheckState::good);
}

TEST(MachineChecks, NameTheAnatomyThatIsMissing) {
  const MachineCheck none = check_anatomy("/nowhere");
  EXPECT_EQ(none.state, CheckState::fair);
  EXPECT_NE(none.words.find("liver.inr.gz"), std::string::npos);
  EXPECT_NE(none.words.find("deploy/fetch_anatomy.sh"), std::string::npos);
}

TEST(MachineChecks, SaySomethingOfThisMachine) {
  for (const MachineCheck& check : {check_real_time(), check_clock(), check_network_buffers()}) {
    EXPECT_FALSE(check.name.empty());
    EXPECT_FALSE(check.words.empty());
    EXPECT_NE(check.state, CheckState::bad);
  }
}

}  // namespace
}  // namespace prosector::test
