#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <vector>

#include "drivers/arms/omni_line.h"

namespace prosector::omni {
namespace {

constexpr int answer_ms = 20;

class SocketLine final : public Line {
 public:
  explicit SocketLine(std::string path) : path_(std::move(path)) {}
  ~SocketLine() override { close(); }

  bool open() override {
    close();
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path_.size() >= sizeof(address.sun_path))
      return lose("the path of the simulated arm's socket is too long");
    std::memcpy(address.sun_path, path_.c_str(), path_.size());
    descriptor_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (descriptor_ < 0 ||
        ::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
      return lose(std::strerror(errno));
    error_.clear();
    return true;
  }
  void close() override {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
  }
  bool is_open() const override { return descriptor_ >= 0; }
  const std::string& error() const override { return error_; }

  std::optional<Word> read(std::uint64_t address) override {
    std::vector<std::uint8_t> question = with_address(read_request, address);
    const auto answer = ask(question, read_response);
    Word word{};
    if (!answer || answer->size() != 1 + word.size()) return std::nullopt;
    std::copy(answer->begin() + 1, answer->end(), word.begin());
    return word;
  }
  bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) override {
    std::vector<std::uint8_t> question = with_address(write_request, address);
    std::copy(bytes.begin(), bytes.end(), std::back_inserter(question));
    return ask(question, write_response).has_value();
  }
  std::optional<Channels> start() override {
    if (is_open()) return Channels{};
    if (error_.empty()) lose("the connection to the simulated arm is not open");
    return std::nullopt;
  }

  std::optional<std::array<std::uint8_t, state_bytes>> receive() override {
    std::optional<std::array<std::uint8_t, state_bytes>> newest;
    while (const auto message = take()) {
      if (message->size() != state_bytes + 1 || message->front() != state_message) continue;
      newest.emplace();
      std::copy(message->begin() + 1, message->end(), newest->begin());
    }
    return newest;
  }
  bool send(std::span<const std::uint8_t, command_bytes> packet) override {
    std::vector<std::uint8_t> message = {command_message};
    message.insert(message.end(), packet.begin(), packet.end());
    return put(message);
  }

 private:
  std::string path_, error_;
  int descriptor_ = -1;

  bool lose(const std::string& why) {
    close();
    error_ = fmt::format("{}: {}", path_, why);
    return false;
  }
  static std::vector<std::uint8_t> with_address(std::uint8_t kind, std::uint64_t address) {
    std::vector<std::uint8_t> out(9, kind);
    std::memcpy(out.data() + 1, &address, 8);
    return out;
  }
  /// Sends a message. If the queue is full, the message is dropped, since a newer one follows. Returns false
  /// when the connection is lost.
  bool put(const std::vector<std::uint8_t>& message) {
    if (descriptor_ < 0) return false;
    if (::send(descriptor_, message.data(), message.size(), MSG_NOSIGNAL) >= 0) return true;
    if (errno == EAGAIN || errno == EWOULDBLOCK) return true;
    return lose(std::strerror(errno));
  }
  /// Returns the next received message, if any.
  std::optional<std::vector<std::uint8_t>> take() {
    if (descriptor_ < 0) return std::nullopt;
    std::vector<std::uint8_t> message(longest_message);
    const ssize_t got = ::recv(descriptor_, message.data(), message.size(), 0);
    if (got > 0) {
      message.resize(static_cast<std::size_t>(got));
      return message;
    }
    if (got == 0)
      lose("the arm is disconnected");
    else if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)
      lose(std::strerror(errno));
    return std::nullopt;
  }
  /// Sends a request and waits up to `answer_ms` per message for the answer. Packets that arrive meanwhile
  /// are dropped as outdated.
  std::optional<std::vector<std::uint8_t>> ask(const std::vector<std::uint8_t>& question,
                                               std::uint8_t answer) {
    if (!put(question)) return std::nullopt;
    pollfd waiting{descriptor_, POLLIN, 0};
    while (descriptor_ >= 0 && ::poll(&waiting, 1, answer_ms) > 0) {
      const auto message = take();
      if (message && message->front() == answer) return message;
    }
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<Line> make_socket_line(const std::string& path) {
  return std::make_unique<SocketLine>(path);
}

}  // namespace prosector::omni
