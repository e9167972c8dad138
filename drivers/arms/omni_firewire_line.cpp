// Connection to an Omni on FireWire, through the kernel's bus driver and libraw1394. Register accesses are
// asynchronous requests; packets are isochronous, one per eight bus cycles in each direction.
#include <fcntl.h>
#include <fmt/format.h>
#include <libraw1394/raw1394.h>
#include <poll.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>
#include <vector>

#include "drivers/arms/omni_line.h"

namespace prosector::omni {
namespace {

constexpr unsigned buffered = 16, cycles_a_packet = 8;
constexpr unsigned longest_packet = 64;  // bytes: public drivers reserve space after the state
constexpr std::uint8_t channels_of_bus = 63;
constexpr int first_node = 0xffc0;

/// RAII owner of a libraw1394 handle.
class Handle {
 public:
  Handle() = default;
  explicit Handle(int port) : handle_(raw1394_new_handle_on_port(port)) {}
  Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Handle() {
    if (handle_ != nullptr) raw1394_destroy_handle(handle_);
  }
  raw1394handle_t get() const { return handle_; }
  explicit operator bool() const { return handle_ != nullptr; }

 private:
  raw1394handle_t handle_ = nullptr;
};

class FirewireLine final : public Line {
 public:
  explicit FirewireLine(const std::string& port) : name_(port) {
    const auto [end, problem] = std::from_chars(port.data(), port.data() + port.size(), port_);
    if (problem != std::errc() || end != port.data() + port.size() || port_ < 0) port_ = -1;
  }

  ~FirewireLine() override { close(); }

  bool open() override {
    close();
    if (port_ < 0) return lose("the path of an Omni must be the number of a FireWire port, from 0");
    requests_ = Handle(port_);
    if (!requests_) return lose(std::strerror(errno));
    for (int i = 0; i < raw1394_get_nodecount(requests_.get()); ++i) {
      node_ = static_cast<nodeid_t>(first_node | i);
      if (const auto word = read(kind_register); word && number_of(*word) == kind) return true;
    }
    return lose("no Omni found on this FireWire bus: check its power and cable");
  }
  void close() override {
    for (const std::uint8_t channel : channels_)
      raw1394_channel_modify(requests_.get(), channel, RAW1394_MODIFY_FREE);
    channels_.clear();
    receiving_ = Handle();
    sending_ = Handle();
    requests_ = Handle();
  }
  bool is_open() const override { return static_cast<bool>(requests_); }
  const std::string& error() const override { return error_; }

  std::optional<Word> read(std::uint64_t address) override {
    quadlet_t word = 0;
    if (!requests_ || raw1394_read(requests_.get(), node_, address, 4, &word) < 0) return std::nullopt;
    return std::bit_cast<Word>(word);  // the library keeps the bus order
  }
  bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) override {
    std::array<quadlet_t, 4> words{};
    if (!requests_ || bytes.size() > sizeof(words)) return false;
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return raw1394_write(requests_.get(), node_, address, bytes.size(), words.data()) >= 0;
  }

  std::optional<Channels> start() override {
    while (requests_ && channels_.size() < 2 && reserve_channel()) {
    }
    if (channels_.size() < 2)
      return fail(
          "the Omni needs two isochronous channels, but this FireWire bus has no two free ones: unplug other "
          "devices");
    const Channels out{channels_[0], channels_[1]};
    receiving_ = Handle(port_);
    sending_ = Handle(port_);
    if (!receiving_ || !sending_) return fail(std::strerror(errno));
    raw1394_set_userdata(receiving_.get(), this);
    raw1394_set_userdata(sending_.get(), this);
    if (raw1394_iso_recv_init(receiving_.get(), take, buffered, longest_packet, out.from_arm,
                              RAW1394_DMA_DEFAULT, 1) < 0 ||
        raw1394_iso_recv_start(receiving_.get(), -1, -1, 0) < 0 ||
        raw1394_iso_xmit_init(sending_.get(), give, buffered, command_bytes, out.to_arm,
                              RAW1394_ISO_SPEED_100, 1) < 0 ||
        raw1394_iso_xmit_start(sending_.get(), -1, -1) < 0)
      return fail(std::strerror(errno));
    return out;
  }

  std::optional<std::array<std::uint8_t, state_bytes>> receive() override {
    turn(receiving_);
    turn(sending_);
    return std::exchange(newest_, std::nullopt);
  }
  bool send(std::span<const std::uint8_t, command_bytes> packet) override {
    std::copy(packet.begin(), packet.end(), command_.begin());
    turn(sending_);
    return is_open();
  }

 private:
  std::string name_, error_;
  int port_ = -1;
  nodeid_t node_ = 0;
  Handle requests_, receiving_, sending_;
  std::vector<std::uint8_t> channels_;  // reserved on the bus: to the arm, from the arm
  std::optional<std::array<std::uint8_t, state_bytes>> newest_;
  std::array<std::uint8_t, command_bytes> command_ = bytes_of(Command{});
  unsigned cycle_ = 0;

  /// Reserves the next free channel at the bus's isochronous resource manager, which prevents conflicts with
  /// other devices such as cameras. Returns whether one was free.
  bool reserve_channel() {
    for (std::uint8_t channel = channels_.empty() ? 0 : static_cast<std::uint8_t>(channels_.back() + 1);
         channel < channels_of_bus; ++channel)
      if (raw1394_channel_modify(requests_.get(), channel, RAW1394_MODIFY_ALLOC) == 0) {
        channels_.push_back(channel);
        return true;
      }
    return false;
  }
  std::nullopt_t fail(const std::string& why) {
    lose(why);
    return std::nullopt;
  }
  bool lose(const std::string& why) {
    close();
    error_ = fmt::format("FireWire port {}: {}", name_, why);
    return false;
  }
  /// Processes pending events of the library without waiting.
  static void turn(const Handle& handle) {
    if (!handle) return;
    pollfd ready{raw1394_get_fd(handle.get()), POLLIN | POLLOUT, 0};
    while (::poll(&ready, 1, 0) > 0 && (ready.revents & POLLIN) != 0)
      if (raw1394_loop_iterate(handle.get()) < 0) return;
  }
  static raw1394_iso_disposition take(raw1394handle_t handle, unsigned char* data, unsigned length,
                                      unsigned char, unsigned char, unsigned char, unsigned, unsigned) {
    auto* line = static_cast<FirewireLine*>(raw1394_get_userdata(handle));
    if (length >= state_bytes) std::copy_n(data, state_bytes, line->newest_.emplace().begin());
    return RAW1394_ISO_OK;
  }
  static raw1394_iso_disposition give(raw1394handle_t handle, unsigned char* data, unsigned* length,
                                      unsigned char* tag, unsigned char* sync, int, unsigned) {
    auto* line = static_cast<FirewireLine*>(raw1394_get_userdata(handle));
    *tag = *sync = 0;
    *length = line->cycle_++ % cycles_a_packet == 0 ? command_bytes : 0;
    if (*length > 0) std::copy(line->command_.begin(), line->command_.end(), data);
    return RAW1394_ISO_OK;
  }
};

}  // namespace

std::unique_ptr<Line> make_firewire_line(const std::string& port) {
  return std::make_unique<FirewireLine>(port);
}

}  // namespace prosector::omni
