#include "twins/base/twin_server.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

#include "common/clock.h"
#include "common/error.h"
#include "twins/base/twin_port.h"

namespace prosector {
namespace {

constexpr std::int64_t longest_wait_ns = 20'000'000;  // maximum interval between checks of `stop`
constexpr std::int64_t babble_period_ns = 5'000'000;
constexpr int longest_garbage = 40;

std::unique_ptr<TwinPort> port_of(const TwinServerOptions& options) {
  if (options.port) return tcp_port(*options.port);
  return options.socket.empty() ? terminal_port(options.link) : local_port(options.socket);
}

class Server {
 public:
  Server(Twin& twin, const TwinServerOptions& options, const std::function<void(const std::string&)>& ready)
      : twin_(twin),
        options_(options),
        ready_(ready),
        port_(port_of(options)),
        random_(options.seed),
        start_ns_(monotonic_ns()) {
    if (!options.log.empty()) {
      log_.open(options.log);
      if (!log_) throw InputError(fmt::format("{}: cannot be written", options.log));
      log_ << "time_ns,station,record,values\n";
    }
    plug_in();
  }

  void step() {
    const std::int64_t now_ns = monotonic_ns();
    const double t = static_cast<double>(now_ns - start_ns_) * 1e-9;
    const bool unplugged = options_.unplug && options_.unplug->contains(t);
    if (unplugged && port_->is_open()) pull_plug();
    if (!unplugged && !port_->is_open()) plug_in();
    if (!port_->is_open()) {
      wait(now_ns + longest_wait_ns);
      return;
    }
    if (reads_stdin_lines_) hear(now_ns);
    if (port_->let_in()) reset_connection();
    outputs_.clear();
    if (port_->descriptor() < 0) return wait(now_ns + longest_wait_ns);
    receive(now_ns);
    twin_.produce(now_ns, outputs_);
    if (options_.babble && options_.babble->contains(t)) {
      outputs_.clear();
      if (now_ns >= next_babble_ns_) write(random_bytes());
      if (now_ns >= next_babble_ns_) next_babble_ns_ = now_ns + babble_period_ns;
    }
    if (options_.silence && options_.silence->contains(t)) outputs_.clear();
    for (const TwinOutput& out : outputs_) send(out);
    wait(std::min(twin_.due_ns(now_ns), now_ns + longest_wait_ns));
  }

 private:
  void plug_in() {
    reset_connection();
    port_->open();
    ready_(port_->path());
  }

  void pull_plug() {
    port_->close();
    reset_connection();
  }

  void reset_connection() {
    pending_.clear();
    twin_.reset_client();
  }

  void hear(std::int64_t now_ns) {
    pollfd input = {.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (poll(&input, 1, 0) <= 0) return;
    std::array<char, 64> bytes;
    const ssize_t n = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    reads_stdin_lines_ = n > 0;  // until the end of the input
    for (ssize_t i = 0; i < n; ++i)
      if (bytes[static_cast<std::size_t>(i)] == '\n') twin_.go_on(now_ns);
  }

  void receive(std::int64_t now_ns) {
    std::array<std::uint8_t, 1024> chunk;
    const ssize_t n = ::read(port_->descriptor(), chunk.data(), chunk.size());
    if (n > 0) twin_.receive(std::span(chunk).first(static_cast<std::size_t>(n)), now_ns, outputs_);
    if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR && errno != EIO)) {
      port_->let_go();
      reset_connection();
    }
  }

  void send(const TwinOutput& out) {
    if (std::bernoulli_distribution(options_.garbage)(random_)) write(random_bytes());
    const std::int64_t first_byte_ns = monotonic_ns();
    if (write(out.bytes) && out.is_record && log_.is_open()) {
      log_ << fmt::format("{},{},{}", first_byte_ns, out.station + 1, out.record);
      for (const float v : out.values) log_ << fmt::format(",{}", v);
      log_ << '\n' << std::flush;
    }
  }

  std::vector<std::uint8_t> random_bytes() {
    std::vector<std::uint8_t> bytes(
        static_cast<std::size_t>(std::uniform_int_distribution(1, longest_garbage)(random_)));
    for (auto& b : bytes) b = static_cast<std::uint8_t>(random_() & 0xff);
    return bytes;
  }

  /// Writes a whole record or none. While the client does not read, whole records are dropped. Returns
  /// whether the record was accepted.
  bool write(const std::vector<std::uint8_t>& bytes) {
    flush();
    if (!pending_.empty()) return false;
    pending_ = bytes;
    flush();
    if (pending_.size() < bytes.size() || bytes.empty()) return true;
    pending_.clear();
    return false;
  }

  void flush() {
    if (pending_.empty()) return;
    const ssize_t n = ::write(port_->descriptor(), pending_.data(), pending_.size());
    if (n > 0) pending_.erase(pending_.begin(), pending_.begin() + n);
  }

  void wait(std::int64_t until_ns) {
    const std::int64_t left = std::max<std::int64_t>(until_ns - monotonic_ns(), 0);
    const timespec time = {.tv_sec = left / 1'000'000'000, .tv_nsec = left % 1'000'000'000};
    pollfd fd = {.fd = port_->descriptor(), .events = POLLIN, .revents = 0};
    ppoll(&fd, port_->descriptor() >= 0 ? 1 : 0, &time, nullptr);
  }

  Twin& twin_;
  const TwinServerOptions& options_;
  bool reads_stdin_lines_ = options_.reads_stdin_lines;
  const std::function<void(const std::string&)>& ready_;
  std::unique_ptr<TwinPort> port_;
  std::ofstream log_;
  std::mt19937_64 random_;
  std::int64_t start_ns_, next_babble_ns_ = 0;
  std::vector<TwinOutput> outputs_;
  std::vector<std::uint8_t> pending_;  // bytes that the client has not read yet
};

}  // namespace

void serve_twin(Twin& twin, const TwinServerOptions& options, const std::atomic<bool>& stop,
                const std::function<void(const std::string&)>& ready) {
  std::signal(SIGPIPE, SIG_IGN);  // a client may hang up at any time
  Server server(twin, options, ready);
  while (!stop) server.step();
}

}  // namespace prosector
