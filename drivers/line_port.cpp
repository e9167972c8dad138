#include "drivers/line_port.h"

#include <utility>

#include "common/clock.h"

namespace prosector {

LinePort::LinePort(std::string where, std::function<std::unique_ptr<ByteLine>()> connect)
    : where_(std::move(where)), opening_(std::move(connect), std::launch::async) {}

bool LinePort::open() {
  return opening_.poll(monotonic_ns()) != nullptr;
}

void LinePort::close() {
  if (is_open()) opening_.lose("", monotonic_ns());
}

int LinePort::descriptor() const {
  return is_open() ? opening_.get()->descriptor() : -1;
}

bool LinePort::read(std::vector<std::uint8_t>& out, std::size_t) {
  if (!is_open()) return false;
  if (opening_.get()->receive(out)) return true;
  opening_.lose(opening_.get()->error(), monotonic_ns());
  return false;
}

bool LinePort::write(std::string_view bytes) {
  if (!is_open()) return false;
  opening_.get()->send({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  return true;
}

}  // namespace prosector
