#include "twins/base/twin_port.h"

#include <fmt/format.h>
#include <unistd.h>

#include <optional>
#include <utility>

#include "drivers/ports/socket_listener.h"
#include "twins/base/pseudo_terminal.h"

namespace prosector {
namespace {

class TerminalPort final : public TwinPort {
 public:
  explicit TerminalPort(std::string link) : link_(std::move(link)) {}
  void open() override { terminal_.open(link_); }
  void close() override { terminal_.close(); }
  bool is_open() const override { return terminal_.is_open(); }
  int descriptor() const override { return terminal_.descriptor(); }
  const std::string& path() const override { return terminal_.path(); }

 private:
  std::string link_;
  PseudoTerminal terminal_;
};

class SocketPort final : public TwinPort {
 public:
  explicit SocketPort(std::string path) : path_(std::move(path)) {}
  explicit SocketPort(std::uint16_t port) : port_(port) {}
  ~SocketPort() override { SocketPort::close(); }
  SocketPort(const SocketPort&) = delete;
  SocketPort& operator=(const SocketPort&) = delete;

  void open() override {
    if (port_) {
      listener_ = std::make_unique<SocketListener>("127.0.0.1", *port_);
      port_ = listener_->port();
      path_ = fmt::format("localhost:{}", *port_);
    } else {
      listener_ = std::make_unique<SocketListener>(path_);
    }
  }
  void close() override {
    let_go();
    listener_.reset();
  }
  bool is_open() const override { return listener_ != nullptr; }
  int descriptor() const override { return client_; }
  const std::string& path() const override { return path_; }
  bool let_in() override {
    if (client_ < 0 && listener_) client_ = listener_->accept();
    return std::exchange(was_there_, client_ >= 0) != (client_ >= 0) && client_ >= 0;
  }
  void let_go() override {
    if (client_ >= 0) ::close(client_);
    client_ = -1;
    was_there_ = false;
  }

 private:
  std::optional<std::uint16_t> port_;  // none: a Unix socket
  std::string path_;
  std::unique_ptr<SocketListener> listener_;
  int client_ = -1;
  bool was_there_ = false;
};

}  // namespace

std::unique_ptr<TwinPort> terminal_port(const std::string& link) {
  return std::make_unique<TerminalPort>(link);
}
std::unique_ptr<TwinPort> tcp_port(std::uint16_t port) {
  return std::make_unique<SocketPort>(port);
}
std::unique_ptr<TwinPort> local_port(const std::string& path) {
  return std::make_unique<SocketPort>(path);
}

}  // namespace prosector
