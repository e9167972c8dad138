#include "drivers/ports/stream_port.h"

#include <utility>

#include "common/clock.h"

namespace prosector {

StreamPort::StreamPort(std::string where, std::function<std::unique_ptr<ByteStream>()> connect)
    : where_(std::move(where)), opening_(std::move(connect), std::launch::async) {}

bool StreamPort::open() {
  return opening_.poll(monotonic_ns()) != nullptr;
}

void StreamPort::close() {
  if (is_open()) opening_.lose("", monotonic_ns());
}

int StreamPort::descriptor() const {
  return is_open() ? opening_.get()->descriptor() : -1;
}

bool StreamPort::read(std::vector<std::uint8_t>& out, std::size_t) {
  if (!is_open()) return false;
  if (opening_.get()->receive(out)) return true;
  opening_.lose(opening_.get()->error(), monotonic_ns());
  return false;
}

bool StreamPort::write(std::string_view bytes) {
  if (!is_open()) return false;
  opening_.get()->send({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  return true;
}

}  // namespace prosector
