// prosector-omni-twin: a simulated PHANTOM Omni at a Unix socket, in a modelled hand.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <iostream>

#include "common/clock.h"
#include "common/error.h"
#include "common/version.h"
#include "drivers/arms/omni_line.h"
#include "twins/arms/arm_twin_program.h"
#include "twins/arms/omni_twin.h"
#include "twins/base/twin_program.h"

namespace prosector {
namespace {

/// Packet socket at a path that serves one client.
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

  /// Accepts a client and answers its requests.
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
    const std::uint8_t off = 0;  // as when the cable is unplugged: the motors stop
    twin.write(omni_body::control_register, {&off, 1}, now_ns);
  }
  void answer(std::span<const std::uint8_t> m, OmniTwin& twin, std::int64_t now_ns) {
    std::uint64_t address = 0;
    if (m.size() >= 9) std::memcpy(&address, m.data() + 1, 8);
    if (m[0] == omni::read_request && m.size() == 9) {
      send(omni::read_response, twin.read(address));
    } else if (m[0] == omni::write_request && m.size() > 9) {
      twin.write(address, m.subspan(9), now_ns);
      send(omni::write_response, {});
    } else if (m[0] == omni::command_message) {
      twin.command(m.subspan(1));
    }
  }
};

int run(int argc, char** argv) {
  CLI::App app("A simulated PHANTOM Omni at a Unix socket. Prints a line when ready.", "prosector-omni-twin");
  app.set_version_flag("--version", version_line("prosector-omni-twin"));
  std::string socket;
  ArmTwinSettings settings;
  app.add_option("socket", socket, "Path of the socket")->required();
  add_arm_options(app, settings, "packets");
  if (const auto status = parse(app, argc, argv)) return *status;
  ArmLog log(settings.log);
  Server server(socket);
  OmniTwin twin({held_arm_options(settings), settings.seed, settings.garbage}, monotonic_ns());
  std::cout << "ready: omni-twin:" << socket << std::endl;
  serve_arm(
      settings,
      [&](std::int64_t now) {
        server.serve(twin, now);
        if (const auto packet = twin.advance(now)) server.send(omni::state_message, *packet);
        if (twin.streaming()) log.write(now, twin.arm());
      },
      [&](std::int64_t now) { twin.go_on(now); });
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
