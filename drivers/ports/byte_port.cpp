#include "drivers/ports/byte_port.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace prosector {
namespace {

speed_t line_speed(unsigned baud) {
  switch (baud) {
    case 9600:
      return B9600;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    default:
      return B115200;
  }
}

bool would_block(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

}  // namespace

BytePort::BytePort(std::string path, unsigned baud) : path_(std::move(path)), baud_(baud) {}

BytePort::~BytePort() {
  close();
}

bool BytePort::open() {
  close();
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) return lose(fmt::format("cannot open {}: {}", path_, std::strerror(errno)));
  if (baud_ != 0 && !set_up_line()) return false;
  error_.clear();
  return true;
}

void BytePort::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

bool BytePort::set_up_line() {
  termios line{};
  if (tcgetattr(descriptor_, &line) != 0) return lose(fmt::format("{} is not a serial port", path_));
  cfmakeraw(&line);
  line.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | PARENB);
  line.c_cflag |= CS8 | CREAD | CLOCAL;
  line.c_cc[VMIN] = 1;  // a read of 0 bytes then means that the device hung up, not that no data is available
  line.c_cc[VTIME] = 0;
  cfsetispeed(&line, line_speed(baud_));
  cfsetospeed(&line, line_speed(baud_));
  if (tcsetattr(descriptor_, TCSANOW, &line) != 0)
    return lose(fmt::format("cannot set {} to {} baud: {}", path_, baud_, std::strerror(errno)));
  tcflush(descriptor_, TCIOFLUSH);
  return true;
}

bool BytePort::lose(const std::string& why) {
  error_ = why;
  close();
  return false;
}

bool BytePort::read(std::vector<std::uint8_t>& out, std::size_t limit) {
  std::array<std::uint8_t, 4096> chunk;
  while (limit > 0) {
    const ssize_t n = ::read(descriptor_, chunk.data(), std::min(limit, chunk.size()));
    if (n < 0 && would_block(errno)) return true;
    if (n < 0) return lose(fmt::format("{} was lost: {}", path_, std::strerror(errno)));
    if (n == 0) return lose(fmt::format("{} was lost: hung up", path_));
    out.insert(out.end(), chunk.begin(), chunk.begin() + n);
    limit -= static_cast<std::size_t>(n);
  }
  return true;
}

bool BytePort::write(std::string_view bytes) {
  const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
  if (n == static_cast<ssize_t>(bytes.size())) return true;
  if (n >= 0 || would_block(errno)) return false;
  return lose(fmt::format("{} was lost: {}", path_, std::strerror(errno)));
}

}  // namespace prosector
