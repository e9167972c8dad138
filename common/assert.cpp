#include "common/assert.h"

#include <fmt/format.h>

#include "common/error.h"

namespace prosector {

void assertion_failed(const char* condition, const char* file, int line) {
  throw InternalError(fmt::format("{}:{}: assertion failed: {}", file, line, condition));
}

}  // namespace prosector
