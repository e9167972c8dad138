// prosector-omni-twin: a simulated PHANTOM Omni at a Unix socket, held by a modelled hand.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iostream>

#include "common/clock.h"
#include "common/error.h"
#include "common/version.h"
#include "drivers/omni_line.h"
#include "drivers/twins/omni_twin.h"

namespace prosector {
namespace {

constexpr std::int64_t period_ns = 1'000'000;
std::atomic<bool> stopped = false;

void stop(int) {
  stopped = true;
}

/// A socket of packets at a path, and the one client that it serves.
class Server {
 public:
  explicit Server(const std::string& path) : path_(path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof(address.sun_path)) throw InputError(path + ": too long for a socket");
    std::memcpy(address.sun_path, path.c_str(), path.size());
    listener_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    ::unlink(path.c_str());
    if (listener_ < 0 ||
        ::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
        ::listen(listener_, 1) != 0)
      throw InputError(fmt::format("{}: {}", path, std::strerror(errno)));
  }
  ~Server() {
    if (client_ >= 0) ::close(client_);
    ::close(listener_);
    ::unlink(path_.c_str());
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Answers what was asked.
  void serve(OmniTwin& twin, std::int64_t now_ns) {
    if (client_ < 0) client_ = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    std::array<std::uint8_t, omni::longest_message> m{};
    while (client_ >= 0) {
      const ssize_t got = ::recv(client_, m.data(), m.size(), 0);
      if (got < 0) break;
      if (got == 0) {
        hang_up(twin, now_ns);
        break;
      }
      answer({m.data(), static_cast<std::size_t>(got)}, twin, now_ns);
    }
  }
  void send(std::uint8_t kind, std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> m = {kind};
    m.insert(m.end(), bytes.begin(), bytes.end());
    if (client_ >= 0) (void)::send(client_, m.data(), m.size(), MSG_NOSIGNAL);
  }

 private:
  std::string path_;
  int listener_ = -1, client_ = -1;

  void hang_up(OmniTwin& twin, std::int64_t now_ns) {
    ::close(client_);
    client_ = -1;
    const std::uint8_t off = 0;  // a cable that is pulled: the motors stop
    twin.write(omni::control_register, {&off, 1}, now_ns);
  }
  void answer(std::span<const std::uint8_t> m, OmniTwin& twin, std::int64_t now_ns) {
    std::uint64_t address = 0;
    if (m.size() >= 9) std::memcpy(&address, m.data() + 1, 8);
    if (m[0] == omni::asks_read && m.size() == 9) {
      const std::uint32_t word = twin.read(address);
      send(omni::answers_read, {reinterpret_cast<const std::uint8_t*>(&word), 4});
    } else if (m[0] == omni::asks_write && m.size() > 9) {
      twin.write(address, m.subspan(9), now_ns);
      send(omni::answers_write, {});
    } else if (m[0] == omni::carries_command) {
      twin.command(m.subspan(1));
    }
  }
};

void log(std::ofstream& out, std::int64_t now_ns, const OmniTwin& twin, const Pose& room_arm) {
  const Vec3 x = room_arm * twin.model().position(), f = room_arm.q * twin.model().force();
  const Vec3 wanted = room_arm * twin.intended();
  out << fmt::format("{},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.4f},{:.6f},{:.6f},{:.6f},{:.6g}\n", now_ns,
                     x.x(), x.y(), x.z(), f.x(), f.y(), f.z(), wanted.x(), wanted.y(), wanted.z(),
                     twin.model().energy());
}

int run(int argc, char** argv) {
  CLI::App app("A simulated PHANTOM Omni at a Unix socket. It says when it is ready.", "prosector-omni-twin");
  app.set_version_flag("--version", version_line("prosector-omni-twin"));
  std::string socket, script, log_file, hand = "medium";
  OmniTwinOptions options;
  std::vector<double> room = {0, 0, 0, 1, 0, 0, 0};
  app.add_option("socket", socket, "Path of the socket")->required();
  app.add_option("--script", script, "CSV of where the hand wants the stylus (docs/do/devices.md)")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--room-arm", room, "x,y,z,qw,qx,qy,qz: pose of the arm's frame in the room")
      ->expected(7)
      ->delimiter(',');
  app.add_option("--hand", hand, "Who holds it")->check(CLI::IsMember({"light", "medium"}));
  app.add_option("--log", log_file, "CSV of where it is, what its motors do, and what the hand wants");
  app.add_option("--garbage", options.garbage, "Share of packets that are random bytes")
      ->check(CLI::Range(0., 1.));
  app.add_option("--seed", options.seed, "Of its random numbers");
  app.add_flag("--wait-client", options.timing.wait_client, "The script begins when it is streamed from");
  app.add_option("--hold", options.timing.holds, "Seconds at which the script waits for a line of input");
  app.add_flag("--loop", options.timing.loop, "Begin the script again after its end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  options.script = MotionScript::load(script);
  options.room_arm = {Vec3(room[0], room[1], room[2]), Quat(room[3], room[4], room[5], room[6]).normalized()};
  options.hand = hand == "light" ? light_hand : medium_hand;
  std::ofstream log_stream;
  if (!log_file.empty()) {
    log_stream.open(log_file);
    if (!log_stream) throw InputError(log_file + ": cannot be written");
    log_stream << "time_ns,x,y,z,fx,fy,fz,wx,wy,wz,energy\n";
  }
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  const Pose room_arm = options.room_arm;
  const bool holds = !options.timing.holds.empty();
  Server server(socket);
  OmniTwin twin(std::move(options), monotonic_ns());
  std::cout << "ready: " << socket << std::endl;
  std::int64_t next = monotonic_ns();
  while (!stopped) {
    next = std::max(next + period_ns, monotonic_ns());
    const timespec until{next / 1'000'000'000, next % 1'000'000'000};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    const std::int64_t now = monotonic_ns();
    server.serve(twin, now);
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (std::string line; holds && ::poll(&input, 1, 0) > 0 && std::getline(std::cin, line)) twin.go_on(now);
    if (const auto packet = twin.advance(now)) server.send(omni::carries_state, *packet);
    if (log_stream.is_open() && twin.streaming()) log(log_stream, now, twin, room_arm);
  }
  return 0;
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) try {
  return prosector::run(argc, argv);
} catch (const std::exception& error) {
  std::cerr << "prosector-omni-twin: " << error.what() << "\n";
  return 2;
}
