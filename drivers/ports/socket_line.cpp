#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "common/error.h"
#include "drivers/ports/byte_line.h"

namespace prosector {
namespace {

constexpr int connect_ms = 2000;
constexpr unsigned unacknowledged_timeout_ms = 5000;             // TCP timeout of unacknowledged data
constexpr std::size_t chunk = 4096, max_bytes_per_read = 65536;  // bytes: read size, and maximum per call;
                                                                 // faster senders are throttled

class SocketLine final : public ByteStream {
 public:
  SocketLine(int descriptor, std::string where) : descriptor_(descriptor), where_(std::move(where)) {
    const int on = 1;
    ::setsockopt(descriptor_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
    ::setsockopt(descriptor_, IPPROTO_TCP, TCP_USER_TIMEOUT, &unacknowledged_timeout_ms,
                 sizeof(unacknowledged_timeout_ms));
  }
  ~SocketLine() override { ::close(descriptor_); }
  SocketLine(const SocketLine&) = delete;
  SocketLine& operator=(const SocketLine&) = delete;

  bool receive(std::vector<std::uint8_t>& out) override {
    flush();
    std::array<std::uint8_t, chunk> bytes;
    for (std::size_t sum = 0; sum < max_bytes_per_read;) {
      const ssize_t got = ::recv(descriptor_, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (got > 0) {
        out.insert(out.end(), bytes.begin(), bytes.begin() + got);
        sum += static_cast<std::size_t>(got);
      } else if (got == 0) {
        error_ = fmt::format("{}: connection closed by the other side", where_);
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
  bool is_full() override {
    flush();
    return !waiting_.empty();
  }
  int descriptor() const override { return descriptor_; }
  const std::string& error() const override { return error_; }

 private:
  int descriptor_;
  std::string where_, error_;
  std::vector<std::uint8_t> waiting_;

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

std::unique_ptr<ByteStream> socket_line(int descriptor, std::string where) {
  return std::make_unique<SocketLine>(descriptor, std::move(where));
}

std::unique_ptr<ByteStream> connect_tcp(const std::string& host, const std::string& port) {
  const std::string where = host + ":" + port;
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int problem = ::getaddrinfo(host.c_str(), port.c_str(), &wanted, &found); problem != 0)
    throw InputError(fmt::format("{}: {}", where, ::gai_strerror(problem)));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> addresses(found, ::freeaddrinfo);
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next)
    if (const int descriptor = connected(*address); descriptor >= 0)
      return std::make_unique<SocketLine>(descriptor, where);
  throw InputError(fmt::format("{}: {}", where, std::strerror(errno)));
}

std::unique_ptr<ByteStream> connect_local(const std::string& path) {
  sockaddr_un there{};
  there.sun_family = AF_UNIX;
  if (path.size() >= sizeof(there.sun_path)) throw InputError(fmt::format("{}: too long for a socket", path));
  path.copy(there.sun_path, path.size());
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor >= 0 && ::connect(descriptor, reinterpret_cast<const sockaddr*>(&there), sizeof(there)) == 0)
    return socket_line(descriptor, path);
  const int error = errno;
  ::close(descriptor);
  throw InputError(fmt::format("{}: {}", path, std::strerror(error)));
}

std::optional<HostPort> parse_host_port(const std::string& text, const char* default_port) {
  const auto colon = text.rfind(':');
  HostPort out{text.substr(0, colon), colon == std::string::npos ? default_port : text.substr(colon + 1)};
  const bool number = !out.port.empty() && out.port.size() <= 5 &&
                      out.port.find_first_not_of("0123456789") == std::string::npos;
  if (out.host.empty() || !number || std::stoul(out.port) > 65535) return std::nullopt;
  return out;
}

}  // namespace prosector
