// What Cyclone DDS complains of is counted and told seldom, whatever somebody sends.

#include "idl/dds/network_log.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <random>

#include "common/error.h"
#include "idl/cyclone_bus.h"
#include "tests/dds_domains.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
constexpr std::int64_t second = 1'000'000'000;
constexpr std::uint32_t flooded_domain = test::dds_domain::network_log,
                        taken_domain = test::dds_domain::network_log + 1;

TEST(NetworkLog, AFloodBecomesALineNowAndThen) {
  LogDigest digest;
  std::vector<std::string> lines;
  for (int k = 0; k < 100'000; ++k)
    if (const auto line = digest.take(k * second / 4000, "malformed packet \n\033[2J" + std::to_string(k)))
      lines.push_back(*line);
  ASSERT_EQ(lines.size(), 3u);  // in 25 s
  EXPECT_EQ(lines[0],
            "network: 1 errors since the last report (1 in total); the latest error: malformed packet [2J0");
  EXPECT_EQ(lines[1].rfind("network: 40000 errors since the last report (40001 in total)", 0), 0u)
      << lines[1];
  EXPECT_LT(digest.take(1000 * second, std::string(100'000, 'x'))->size(), 300u);
}

BusConfig server_in(std::uint32_t domain) {
  BusConfig config;
  config.end = BusEnd::server;
  config.session = "log";
  config.domain = domain;
  return config;
}

TEST(NetworkLog, MalformedDatagramsDoNotFloodStandardError) {
  const auto server = make_cyclone_bus(server_in(flooded_domain));
  testing::internal::CaptureStderr();
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(7410 + 250 * flooded_domain));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::mt19937_64 random(20100611);
  for (int k = 0; k < 2000; ++k) {
    // An RTPS header, and a submessage that isn't one.
    std::string datagram("RTPS\x02\x01\x01\x10", 8);
    for (int byte = 0; byte < 60; ++byte) datagram += static_cast<char>(random());
    datagram[20] = 0x15;  // DATA
    sendto(socket, datagram.data(), datagram.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
    if (k % 50 == 0) usleep(1000);
  }
  ::close(socket);
  usleep(300'000);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_LE(std::count(said.begin(), said.end(), '\n'), 2) << said.substr(0, 1000);
  EXPECT_LT(said.size(), 1000u);
}

TEST(NetworkLog, APortThatIsTakenIsSaidInOurWordsOnly) {
  const auto first = make_cyclone_bus(server_in(taken_domain));
  testing::internal::CaptureStderr();
  EXPECT_THROW(make_cyclone_bus(server_in(taken_domain)), InputError);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace prosector
