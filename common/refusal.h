#pragma once
// Result of an operation that can be refused: nothing, or the reason.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "common/assert.h"

namespace prosector {

/// Reason why an operation was refused, as text for users. It converts to true if the operation was refused;
/// a default-constructed one means success. It is not used for bad files (InputError) nor for errors in the
/// program (InternalError).
class [[nodiscard]] Refusal {
 public:
  Refusal() = default;
  Refusal(std::string why) : why_(std::move(why)) { PROSECTOR_ASSERT(!why_->empty()); }
  Refusal(const char* why) : Refusal(std::string(why)) {}
  Refusal(std::nullptr_t) = delete;

  explicit operator bool() const { return why_.has_value(); }
  /// Returns the reason why the operation was refused; empty if it was not.
  std::string why() const { return why_.value_or(std::string()); }
  bool operator==(const Refusal&) const = default;

 private:
  std::optional<std::string> why_;
};

}  // namespace prosector
