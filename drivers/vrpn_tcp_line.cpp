#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "common/error.h"
#include "drivers/vrpn_line.h"

namespace prosector::vrpn {
namespace {

constexpr int connect_ms = 2000;
constexpr std::size_t chunk = 4096, most_at_once = 65536;  // bytes: who sends faster waits

class TcpLine final : public Line {
 public:
  TcpLine(int descriptor, std::string where) : descriptor_(descriptor), where_(std::move(where)) {
    const int on = 1;
    ::setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  }
  ~TcpLine() override { ::close(descriptor_); }
  TcpLine(const TcpLine&) = delete;
  TcpLine& operator=(const TcpLine&) = delete;

  bool receive(Bytes& out) override {
    flush();
    std::array<std::uint8_t, chunk> bytes;
    for (std::size_t sum = 0; sum < most_at_once;) {
      const ssize_t got = ::recv(descriptor_, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (got > 0) {
        out.insert(out.end(), bytes.begin(), bytes.begin() + got);
        sum += static_cast<std::size_t>(got);
      } else if (got == 0) {
        error_ = where_ + ": the server hung up";
        break;
      } else if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) {
        break;
      } else {
        error_ = fmt::format("{}: {}", where_, std::strerror(errno));
        break;
      }
    }
    return error_.empty();
  }
  void send(std::span<const std::uint8_t> bytes) override {
    flush();
    if (!waiting_.empty()) return;
    waiting_.assign(bytes.begin(), bytes.end());
    flush();
  }
  const std::string& error() const override { return error_; }

 private:
  int descriptor_;
  std::string where_, error_;
  Bytes waiting_;

  void flush() {
    if (waiting_.empty()) return;
    const ssize_t sent = ::send(descriptor_, waiting_.data(), waiting_.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) waiting_.erase(waiting_.begin(), waiting_.begin() + sent);
  }
};

/// Connects to one address. Returns its descriptor, or −1 with errno set.
int connected(const addrinfo& address) {
  const int descriptor = ::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return -1;
  int error = 0;
  socklen_t size = sizeof(error);
  pollfd waiting{descriptor, POLLOUT, 0};
  if (::connect(descriptor, address.ai_addr, address.ai_addrlen) == 0) return descriptor;
  if (errno != EINPROGRESS)
    error = errno;
  else if (::poll(&waiting, 1, connect_ms) <= 0)
    error = ETIMEDOUT;
  else
    ::getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &size);
  if (error == 0) return descriptor;
  ::close(descriptor);
  errno = error;
  return -1;
}

}  // namespace

std::unique_ptr<Line> connect_line(const std::string& host, const std::string& port) {
  const std::string where = host + ":" + port;
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int problem = ::getaddrinfo(host.c_str(), port.c_str(), &wanted, &found); problem != 0)
    throw InputError(fmt::format("{}: {}", where, ::gai_strerror(problem)));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, ::freeaddrinfo);
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next)
    if (const int descriptor = connected(*address); descriptor >= 0)
      return std::make_unique<TcpLine>(descriptor, where);
  throw InputError(fmt::format("{}: {}", where, std::strerror(errno)));
}

}  // namespace prosector::vrpn
