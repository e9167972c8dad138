#pragma once
// Owner of a DDS entity handle.

#include <dds/dds.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace prosector {

class Entity {
 public:
  Entity() = default;
  /// Takes ownership of the DDS entity that a dds_create_… function returned. Throws std::runtime_error
  /// naming `what` if that function failed.
  Entity(dds_entity_t handle, const char* what) : handle_(handle) {
    if (handle < 0) throw std::runtime_error(std::string("DDS: ") + what + ": " + dds_strretcode(handle));
  }
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Entity() {
    if (handle_ > 0) dds_delete(handle_);
  }

  dds_entity_t get() const { return handle_; }
  explicit operator bool() const { return handle_ > 0; }

 private:
  dds_entity_t handle_ = 0;
};

}  // namespace prosector
