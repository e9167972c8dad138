#pragma once
// The answer of what can be refused: nothing, or why not.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "common/assert.h"

namespace prosector {

/// Why something was refused, for people. True means refused; a default one that it was done or accepted.
/// Not for bad files (InputError) and not for faults of the program (InternalError).
class [[nodiscard]] Refusal {
 public:
  Refusal() = default;
  Refusal(std::string why) : why_(std::move(why)) { PROSECTOR_ASSERT(!why_->empty()); }
  Refusal(const char* why) : Refusal(std::string(why)) {}
  Refusal(std::nullptr_t) = delete;

  explicit operator bool() const { return why_.has_value(); }
  /// Returns the reason; empty where nothing was refused.
  std::string why() const { return why_.value_or(std::string()); }
  bool operator==(const Refusal&) const = default;

 private:
  std::optional<std::string> why_;
};

}  // namespace prosector
