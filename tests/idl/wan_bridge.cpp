// A far network in user space: one TAP device in each of two network namespaces, and between them, in each
// direction, a seeded loss, a rate limit with a queue, and a delay with jitter.
//   wan_bridge NAMESPACE_A ADDRESS_A/BITS NAMESPACE_B ADDRESS_B/BITS [SEED [DELAY_MS]]
// Prints "ready" when both devices are up; ends with its standard input or a signal. Needs root.

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/clock.h"

namespace {

constexpr double loss = 0.01;
constexpr std::int64_t default_delay_ns = 20'000'000, jitter_ns = 5'000'000;
constexpr double bits_per_ns = 0.05;                  // 50 Mbit/s
constexpr std::int64_t queue_limit_ns = 200'000'000;  // a packet that would wait longer is dropped

void require(bool ok, const std::string& what) {
  if (!ok) throw std::runtime_error(what + ": " + std::strerror(errno));
}

/// Opens the device "wan0" inside the namespace; the calling thread stays there.
int open_tap(const std::string& space, const std::string& address) {
  const int handle = open(("/run/netns/" + space).c_str(), O_RDONLY | O_CLOEXEC);
  require(handle >= 0 && setns(handle, CLONE_NEWNET) == 0, "namespace " + space);
  close(handle);
  const int tap = open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  ifreq request{};
  request.ifr_flags = IFF_TAP | IFF_NO_PI;
  std::strcpy(request.ifr_name, "wan0");
  require(tap >= 0 && ioctl(tap, TUNSETIFF, &request) == 0, "TAP device");
  const std::string up = "ip addr add " + address + " dev wan0 && ip link set wan0 up";
  require(std::system(up.c_str()) == 0, "address " + address);
  return tap;
}

/// One direction of the link.
class Link {
 public:
  Link(int from, int to, std::int64_t delay_ns, std::uint64_t seed)
      : from_(from), to_(to), delay_ns_(delay_ns), random_(seed) {}

  void read_all(std::int64_t now) {
    std::array<char, 65536> frame;
    for (ssize_t size; (size = read(from_, frame.data(), frame.size())) > 0;)
      accept({frame.begin(), frame.begin() + size}, now);
  }
  void write_due(std::int64_t now) {
    for (; !under_way_.empty() && under_way_.begin()->first <= now; under_way_.erase(under_way_.begin())) {
      const std::vector<char>& frame = under_way_.begin()->second;
      if (write(to_, frame.data(), frame.size()) < 0) return;  // the receiver's queue is full
    }
  }
  std::int64_t next_ns(std::int64_t otherwise) const {
    return under_way_.empty() ? otherwise : std::min(otherwise, under_way_.begin()->first);
  }

 private:
  void accept(std::vector<char> frame, std::int64_t now) {
    const std::int64_t start = std::max(now, free_at_);
    if (start - now > queue_limit_ns) return;
    free_at_ = start + static_cast<std::int64_t>(8.0 * static_cast<double>(frame.size()) / bits_per_ns);
    if (std::uniform_real_distribution<double>(0, 1)(random_) < loss) return;
    const auto jitter = std::uniform_int_distribution<std::int64_t>(-jitter_ns, jitter_ns)(random_);
    under_way_.emplace(free_at_ + delay_ns_ + jitter, std::move(frame));
  }

  int from_, to_;
  std::int64_t delay_ns_;
  std::mt19937_64 random_;
  std::int64_t free_at_ = 0;  // when the rate limit lets the next packet start
  std::multimap<std::int64_t, std::vector<char>> under_way_;
};

void run(int a, int b, std::int64_t delay_ns, std::uint64_t seed) {
  Link there(a, b, delay_ns, seed), back(b, a, delay_ns, seed + 1);
  std::array<pollfd, 3> files{{{a, POLLIN, 0}, {b, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
  while ((files[2].revents & (POLLIN | POLLHUP)) == 0) {
    const std::int64_t now = prosector::monotonic_ns();
    const std::int64_t next = back.next_ns(there.next_ns(now + 100'000'000));
    const std::int64_t wait = std::max<std::int64_t>(0, next - now);
    const timespec timeout{wait / 1'000'000'000, wait % 1'000'000'000};
    ppoll(files.data(), files.size(), &timeout, nullptr);
    const std::int64_t woken = prosector::monotonic_ns();
    there.read_all(woken);
    back.read_all(woken);
    there.write_due(woken);
    back.write_due(woken);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr,
               "usage: wan_bridge NAMESPACE_A ADDRESS_A/BITS NAMESPACE_B ADDRESS_B/BITS [SEED [DELAY_MS]]\n");
    return 2;
  }
  try {
    const int a = open_tap(argv[1], argv[2]), b = open_tap(argv[3], argv[4]);
    fmt::print("ready\n");
    std::fflush(stdout);
    const std::int64_t delay_ns =
        argc > 6 ? std::strtoll(argv[6], nullptr, 10) * 1'000'000 : default_delay_ns;
    run(a, b, delay_ns, argc > 5 ? std::strtoull(argv[5], nullptr, 10) : 1);
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "wan_bridge: {}\n", error.what());
    return 1;
  }
}
