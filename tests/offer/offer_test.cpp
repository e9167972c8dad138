// What is offered to other software: read back by our own drivers, with garbage and crowds beside them.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <mutex>
#include <random>

#include "client/offer/offer_server.h"
#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/camera.h"
#include "drivers/config/device_config.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

const Pose hand{{0.2, 1.1, -0.3}, Quat(0.9, 0.2, -0.1, 0.3).normalized()};
const Pose head{{-0.1, 1.7, -0.2}, Quat(0.7, -0.2, 0.5, 0.1).normalized()};

std::vector<Offered> two_things() {
  return {{"Ann.right", hand}, {"Ann.head", head}};
}

class EachProtocol : public testing::TestWithParam<std::string> {
 protected:
  Offer offer() const { return parse_offer(GetParam() + ":127.0.0.1:0"); }
  std::string address(const OfferServer& server, const std::string& thing) const {
    return GetParam() == "vrpn" ? "vrpn:" + thing + "@127.0.0.1:" + std::to_string(server.port())
                                : "igtl:127.0.0.1:" + std::to_string(server.port()) + "/" + thing;
  }
  /// Reads the thing until some poses came or it takes too long; the last one.
  static std::optional<Pose> read(const std::string& address) {
    const auto device = open_device(address, {});
    std::vector<DeviceSample> samples;
    const std::int64_t end = monotonic_ns() + 10'000'000'000;
    while (samples.size() < 5 && monotonic_ns() < end) {
      device->poll(samples);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_FALSE(samples.empty()) << device->status().message;
    return samples.empty() ? std::nullopt : std::optional(samples.back().pose);
  }
  static void expect_read(const std::string& address, const Pose& pose) {
    const auto came = read(address);
    ASSERT_TRUE(came);
    EXPECT_LT((came->p - pose.p).norm(), 1e-6);
    EXPECT_NEAR(std::abs(came->q.dot(pose.q)), 1, 1e-6);
  }
};

TEST_P(EachProtocol, OurOwnDriverReadsWhatIsOffered) {
  const OfferServer server(offer(), two_things);
  expect_read(address(server, "Ann.right"), hand);
  expect_read(address(server, "Ann.head"), head);
}

TEST_P(EachProtocol, GarbageAndCrowdsDisturbNobody) {
  const OfferServer server(offer(), two_things);
  std::mt19937 random(11);
  std::vector<std::unique_ptr<ByteStream>> crowd;
  for (int k = 0; k < 40; ++k) {  // more than are let in
    crowd.push_back(connect_tcp("127.0.0.1", std::to_string(server.port())));
    std::vector<std::uint8_t> garbage(1 + random() % 5000);
    for (auto& byte : garbage) byte = static_cast<std::uint8_t>(random());
    if (k % 2 == 0) crowd.back()->send(garbage);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  std::size_t let_go = 0;
  std::vector<std::uint8_t> heard;
  for (const auto& line : crowd) let_go += line->receive(heard) ? 0 : 1;
  EXPECT_GE(let_go, 20u) << "who talks nonsense is let go";
  crowd.resize(20);
  expect_read(address(server, "Ann.right"), hand);
}

INSTANTIATE_TEST_SUITE_P(Offers, EachProtocol, testing::Values("vrpn", "igtl"),
                         [](const auto& protocol) { return protocol.param; });

Image coloured(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image out{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) out.rgb.push_back(static_cast<std::uint8_t>(random()));
  return out;
}

// A picture goes out by OpenIGTLink and comes in as a camera's, byte for byte, with poses beside it.
TEST(OfferedPictures, ComeBackAsACamerasPictures) {
  std::atomic<unsigned> newest = 1;
  const std::array<std::shared_ptr<const Image>, 2> pictures = {
      std::make_shared<const Image>(coloured(640, 480, 1)),
      std::make_shared<const Image>(coloured(320, 200, 2))};
  const OfferServer server(parse_offer("igtl:127.0.0.1:0"), two_things, [&] { return pictures[newest]; });
  const std::string at = "igtl://127.0.0.1:" + std::to_string(server.port());
  const auto camera = open_camera(at + "/Camera");
  const auto any = open_camera(at);
  const auto other = open_camera(at + "/Another");
  for (const unsigned shown : {1u, 0u}) {
    newest = shown;
    for (const auto& one : {camera.get(), any.get()}) {
      std::optional<Frame> frame;
      const std::int64_t end_ns = monotonic_ns() + 10'000'000'000;
      while ((!frame || frame->image.rgb != pictures[shown]->rgb) && monotonic_ns() < end_ns)
        frame = one->next(std::chrono::milliseconds(100));
      ASSERT_TRUE(frame);
      EXPECT_EQ(frame->image.width, pictures[shown]->width);
      EXPECT_EQ(frame->image.rgb, pictures[shown]->rgb);
      EXPECT_LE(frame->time_ns, monotonic_ns());
      EXPECT_EQ(frame->number, shown == 1 ? 0u : 1u);
    }
  }
  EXPECT_FALSE(other->next(std::chrono::milliseconds(100))) << "of that name nothing comes";
}

TEST(OfferedPictures, WhoHangsUpIsToldOf) {
  auto server = std::make_unique<OfferServer>(parse_offer("igtl:127.0.0.1:0"), two_things);
  const auto camera = open_camera("igtl://127.0.0.1:" + std::to_string(server->port()));
  EXPECT_FALSE(camera->next(std::chrono::milliseconds(50)));
  server.reset();
  EXPECT_THROW(
      {
        for (int k = 0; k < 50; ++k) (void)camera->next(std::chrono::milliseconds(50));
      },
      InputError);
  for (const char* bad : {"igtl://", "igtl://host:x", "igtl://host:1/a name that is too long"})
    EXPECT_THROW((void)open_camera(bad), InputError) << bad;
}

TEST(Offers, NamesArePlainAndEachOnce) {
  std::vector<Offered> things = {{"Ann Müller.right", {}},
                                 {"Ann_M__ller.right", {}},
                                 {"somebody with a very long name.left", {}},
                                 {"somebody with a very long name too.left", {}},
                                 {"scalpel no. 11 of the second tray", {}}};
  make_names_valid(things);
  EXPECT_EQ(things[0].name, "Ann_M__ller.right");
  EXPECT_EQ(things[1].name, "Ann_M__ller-2.right");
  EXPECT_EQ(things[2].name, "somebody_with_a.left");
  EXPECT_EQ(things[3].name, "somebody_with-2.left");
  for (const Offered& thing : things) EXPECT_LE(thing.name.size(), longest_offered_name);
}

TEST(Offers, AreReadAsPeopleWriteThem) {
  EXPECT_EQ(parse_offer("vrpn").address, "127.0.0.1");
  EXPECT_EQ(parse_offer("vrpn").port, 3883);
  EXPECT_EQ(parse_offer("igtl:0.0.0.0").port, 18944);
  EXPECT_EQ(parse_offer("igtl:10.0.0.1:7000").port, 7000);
  EXPECT_EQ(parse_offer("vrpn:[::1]:7000").address, "::1");
  for (const char* text : {"", "ftp", "vrpn:", "vrpn:1.2.3.4:", "vrpn:1.2.3.4:x", "igtl:1.2.3.4:70000"})
    EXPECT_THROW(parse_offer(text), InputError) << text;
  EXPECT_THROW(OfferServer(parse_offer("vrpn:nobody:0"), two_things), InputError);
}

}  // namespace
}  // namespace prosector
