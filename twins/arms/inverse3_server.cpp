#include "twins/arms/inverse3_server.h"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>
#include <utility>

#include "common/error.h"

namespace prosector {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
using net::ip::tcp;
using Error = beast::error_code;

}  // namespace

class Inverse3Server::Talk {
 public:
  Talk(Inverse3Twin& twin, std::uint16_t port) : twin_(twin) {
    try {
      const tcp::endpoint here(net::ip::address_v4::loopback(), port);
      acceptor_.open(here.protocol());
      acceptor_.set_option(tcp::acceptor::reuse_address(true));
      acceptor_.bind(here);
      acceptor_.listen();
    } catch (const boost::system::system_error& error) {
      throw InputError(fmt::format("port {}: {}", port, error.code().message()));
    }
    port_ = acceptor_.local_endpoint().port();
    accept();
  }

  std::uint16_t port() const { return port_; }
  bool has_client() const { return talks_; }
  void serve(bool mute) {
    if (answer_pending_ && !sending_ && !mute) send(twin_.state());
    io_.poll();
  }
  void cut() {
    if (!stream_) return;
    Error ignored;
    beast::get_lowest_layer(*stream_).socket().close(ignored);
  }

 private:
  Inverse3Twin& twin_;
  net::io_context io_;
  tcp::acceptor acceptor_{io_};
  std::optional<beast::websocket::stream<beast::tcp_stream>> stream_;
  beast::flat_buffer buffer_;
  std::string text_;
  std::uint16_t port_ = 0;
  bool talks_ = false, answer_pending_ = false, sending_ = false;

  void accept() {
    acceptor_.async_accept([this](Error error, tcp::socket socket) {
      if (error) return;
      Error ignored;
      socket.set_option(tcp::no_delay(true), ignored);
      stream_.emplace(std::move(socket));
      stream_->async_accept([this](Error failed) {
        if (failed) return hang_up();
        talks_ = true;
        send(twin_.begin());
        listen();
      });
    });
  }
  void listen() {
    stream_->async_read(buffer_, [this](Error error, std::size_t) {
      if (error) return hang_up();
      twin_.take({static_cast<const char*>(buffer_.data().data()), buffer_.size()});
      buffer_.clear();
      answer_pending_ = true;
      listen();
    });
  }
  void send(std::string text) {
    text_ = std::move(text);
    answer_pending_ = false;
    sending_ = true;
    stream_->async_write(net::buffer(text_), [this](Error, std::size_t) { sending_ = false; });
  }
  void hang_up() {
    twin_.end();
    talks_ = answer_pending_ = sending_ = false;
    buffer_.clear();
    accept();
  }
};

Inverse3Server::Inverse3Server(Inverse3Twin& twin, std::uint16_t port)
    : talk_(std::make_unique<Talk>(twin, port)) {}

Inverse3Server::~Inverse3Server() = default;

std::uint16_t Inverse3Server::port() const {
  return talk_->port();
}
void Inverse3Server::serve() {
  talk_->serve(mute);
}
void Inverse3Server::cut() {
  talk_->cut();
}
bool Inverse3Server::has_client() const {
  return talk_->has_client();
}

}  // namespace prosector
