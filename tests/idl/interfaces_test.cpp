// Which network a session reaches when its user names none.

#include "idl/dds/interfaces.h"

#include <gtest/gtest.h>

#include "common/error.h"

namespace prosector {
namespace {

std::string why_not(const std::vector<NetworkInterface>& interfaces) {
  try {
    return "chose " + only_interface(interfaces);
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Interfaces, TheOnlyOneIsChosen) {
  EXPECT_EQ(only_interface({{"eth0", "10.0.0.1"}}), "eth0");
}

TEST(Interfaces, SeveralAreListedAndNoneIsSaid) {
  const std::string several = why_not({{"eth0", "10.0.0.1"}, {"wlan0", "10.1.0.1"}});
  EXPECT_NE(several.find("eth0 (10.0.0.1), wlan0 (10.1.0.1)"), std::string::npos) << several;
  EXPECT_NE(why_not({}).find("loopback"), std::string::npos) << why_not({});
}

TEST(Interfaces, LoopbackIsNotAmongThem) {
  for (const NetworkInterface& i : network_interfaces()) {
    EXPECT_NE(i.name, "lo");
    EXPECT_FALSE(i.address.starts_with("127.")) << i.name;
  }
}

}  // namespace
}  // namespace prosector
