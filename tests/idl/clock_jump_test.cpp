// What waits goes on, and ends, while somebody sets the machine's wall clock.
//
// The wall clock of this process, Cyclone DDS included, is the one below: it stands aside by what a test
// says.

#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <ctime>
#include <thread>

#include "idl/cyclone_bus.h"
#include "tests/dds_domains.h"

namespace {

constexpr std::int64_t second = 1'000'000'000;
std::atomic<std::int64_t> set_by_ns{0};  // how far the wall clock was set

std::int64_t ns_of(const timespec& t) {
  return t.tv_sec * second + t.tv_nsec;
}

timespec timespec_of(std::int64_t ns) {
  return {static_cast<time_t>(ns / second), static_cast<long>(ns % second)};
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* out) noexcept {
  if (const long error = syscall(SYS_clock_gettime, clock, out)) return static_cast<int>(error);
  if (clock == CLOCK_REALTIME) *out = timespec_of(ns_of(*out) + set_by_ns);
  return 0;
}

/// Until the wall clock shows `until`, however often it is set meanwhile.
extern "C" int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                      const timespec* until) {
  using Wait = int (*)(pthread_cond_t*, pthread_mutex_t*, const timespec*);
  static const auto real = reinterpret_cast<Wait>(dlsym(RTLD_NEXT, "pthread_cond_timedwait"));
  for (;;) {
    timespec now{};
    syscall(SYS_clock_gettime, CLOCK_REALTIME, &now);
    const std::int64_t real_until = ns_of(*until) - set_by_ns;
    const timespec slice = timespec_of(std::min(real_until, ns_of(now) + second / 50));
    const int result = real(condition, mutex, &slice);
    timespec after{};
    clock_gettime(CLOCK_REALTIME, &after);
    if (result != ETIMEDOUT || ns_of(after) >= ns_of(*until)) return result;
  }
}

namespace prosector {
namespace {

using namespace std::chrono_literals;

// A domain a test, so that both can run at once.
BusConfig config_of(BusEnd end, std::uint32_t domain) {
  BusConfig config;
  config.end = end;
  config.session = "clock";
  config.domain = domain;
  return config;
}

TEST(ClockJump, WaitsEndInTimeAndSoDoesTheBus) {
  alarm(60);  // where something waits for an hour, the test is ended
  for (const std::int64_t jump : {-3600 * second, 3600 * second}) {
    auto server = make_cyclone_bus(config_of(BusEnd::server, test::dds_domain::clock_jump));
    auto observer = make_cyclone_bus(config_of(BusEnd::observer, test::dds_domain::clock_jump));
    std::atomic<bool> stop{false};
    std::atomic<int> waits{0};
    std::thread waiting([&] {
      std::vector<Received> received;
      for (; !stop; ++waits)
        if (observer->wait(100ms)) observer->take(received);
    });
    std::this_thread::sleep_for(250ms);
    set_by_ns += jump;
    const int before = waits;
    const auto begin = std::chrono::steady_clock::now();
    while (waits < before + 3 && std::chrono::steady_clock::now() - begin < 10s)
      std::this_thread::sleep_for(20ms);
    EXPECT_GE(waits, before + 3) << "after the clock was set by " << jump / second << " s";
    stop = true;
    waiting.join();
    observer.reset();
    server.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 15s);
  }
  EXPECT_TRUE(list_sessions(config_of(BusEnd::observer, test::dds_domain::clock_jump), 100ms).empty());
  alarm(0);
}

/// Takes what `bus` hears until something fits or `time` is over.
template <typename Fits>
bool hears(Bus& bus, std::chrono::milliseconds time, Fits fits) {
  const auto end = std::chrono::steady_clock::now() + time;
  bool heard = false;
  while (!heard && std::chrono::steady_clock::now() < end) {
    std::vector<Received> received;
    if (bus.wait(50ms)) bus.take(received);
    for (const Received& r : received) heard = heard || fits(r);
  }
  return heard;
}

// The events of DDS itself go on: leases are renewed, and who comes afterwards is found.
TEST(ClockJump, NobodyLeavesAndNewcomersAreFound) {
  alarm(60);
  auto server = make_cyclone_bus(config_of(BusEnd::server, test::dds_domain::clock_jump + 1));
  auto client = make_cyclone_bus(config_of(BusEnd::dissector, test::dds_domain::clock_jump + 1));
  Presence presence;
  presence.participant = 3;
  presence.name = "here";
  client->publish(presence);
  server->publish(RoomState{});
  const auto is_presence = [](const Received& r) { return std::holds_alternative<Presence>(r.message); };
  const auto is_room = [](const Received& r) { return std::holds_alternative<RoomState>(r.message); };
  ASSERT_TRUE(hears(*server, 10s, is_presence));
  ASSERT_TRUE(hears(*client, 10s, is_room));
  for (const std::int64_t jump : {-3600 * second, 3600 * second}) {
    SCOPED_TRACE(fmt::format("the clock is set by {} s", jump / second));
    set_by_ns += jump;
    EXPECT_FALSE(hears(*server, 3s, [&](const Received& r) {  // a presence's lease is 1 s
      return is_presence(r) && r.liveness == Liveness::gone;
    }));
    auto newcomer = make_cyclone_bus(config_of(BusEnd::observer, test::dds_domain::clock_jump + 1));
    EXPECT_TRUE(hears(*newcomer, 10s, is_room));
  }
  alarm(0);
}

}  // namespace
}  // namespace prosector
