#include "drivers/ports/web_socket.h"

#include <fmt/format.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "drivers/ports/real_time.h"
#include "drivers/ports/triple_buffer.h"

namespace prosector {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
using Stream = beast::websocket::stream<beast::tcp_stream>;
using Error = beast::error_code;

constexpr std::chrono::milliseconds to_connect(2000), silence(500), retry(500), last_answer(50);
constexpr std::size_t longest_text = 65536;  // bytes

}  // namespace

class WebSocket::Talk {
 public:
  Talk(std::string host, std::string port, std::string target, Answer answer)
      : host_(std::move(host)),
        port_(std::move(port)),
        target_(std::move(target)),
        answer_(std::move(answer)) {
    resolve();
    thread_ = std::thread([this] {
      request_real_time_priority(communication_priority);
      io_.run();
    });
  }
  ~Talk() {
    net::post(io_, [this] { end(); });
    thread_.join();
  }
  const State& state() { return published_state_.read(); }

 private:
  std::string host_, port_, target_;
  Answer answer_;
  net::io_context io_;
  net::ip::tcp::resolver resolver_{io_};
  net::steady_timer timer_{io_};
  std::optional<Stream> stream_;
  beast::flat_buffer buffer_{longest_text};
  std::vector<std::string> texts_;  // texts being sent
  State state_;
  TripleBuffer<State> published_state_;
  bool ends_ = false;
  std::thread thread_;

  void resolve() {
    resolver_.async_resolve(host_, port_, [this](Error error, auto found) {
      if (error) return lose(error);
      stream_.emplace(io_);
      beast::get_lowest_layer(*stream_).expires_after(to_connect);
      beast::get_lowest_layer(*stream_).async_connect(found, [this](Error failed, auto) {
        if (failed) return lose(failed);
        shake_hands();
      });
    });
  }
  void shake_hands() {
    beast::get_lowest_layer(*stream_).expires_never();
    Error ignored;
    beast::get_lowest_layer(*stream_).socket().set_option(net::ip::tcp::no_delay(true), ignored);
    stream_->set_option(beast::websocket::stream_base::timeout{to_connect, silence, false});
    stream_->read_message_max(longest_text);
    stream_->async_handshake(host_ + ":" + port_, target_, [this](Error error) {
      if (error) return lose(error);
      ++state_.connections;
      state_.connected = true;
      state_.problem.clear();
      published_state_.write(state_);
      listen();
    });
  }
  void listen() {
    buffer_.clear();
    stream_->async_read(buffer_, [this](Error error, std::size_t) {
      if (error) return lose(error);
      auto answer = answer_({static_cast<const char*>(buffer_.data().data()), buffer_.size()});
      state_.refused = !answer;
      if (!answer) return lose(net::error::connection_aborted);
      texts_ = std::move(*answer);
      send(0);
    });
  }
  /// Sends the texts from index `number` on, then reads the next text.
  void send(std::size_t number) {
    if (number == texts_.size()) return ends_ ? io_.stop() : listen();
    stream_->text(true);
    stream_->async_write(net::buffer(texts_[number]), [this, number](Error failed, std::size_t) {
      if (failed) return lose(failed);
      send(number + 1);
    });
  }
  void lose(Error error) {
    if (ends_) return io_.stop();
    state_.refused = state_.refused && error == net::error::connection_aborted;
    state_.connected = false;
    state_.problem = fmt::format("{}:{}: {}", host_, port_,
                                 error == beast::error::timeout ? "no more data" : error.message());
    published_state_.write(state_);
    stream_.reset();
    timer_.expires_after(retry);
    timer_.async_wait([this](Error cancelled) {
      if (!cancelled) resolve();
    });
  }
  void end() {
    ends_ = true;
    if (!state_.connected) return io_.stop();
    timer_.expires_after(last_answer);
    timer_.async_wait([this](Error) { io_.stop(); });
  }
};

WebSocket::WebSocket(std::string host, std::string port, std::string target, Answer answer)
    : talk_(std::make_unique<Talk>(std::move(host), std::move(port), std::move(target), std::move(answer))) {}

WebSocket::~WebSocket() = default;

const WebSocket::State& WebSocket::state() {
  return talk_->state();
}

}  // namespace prosector
