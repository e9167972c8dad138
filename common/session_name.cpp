#include "common/session_name.h"

#include <fmt/format.h>

#include "common/error.h"
#include "common/ids.h"
#include "common/valid_text.h"

namespace prosector {

void check_session_name(const std::string& name) {
  if (!valid_name(name) || name.find_first_of("*?[]") != std::string::npos)
    throw InputError(
        fmt::format("session name \"{}\" is not valid; allowed: 1 to {} bytes of UTF-8 without control "
                    "characters and without * ? [ ]",
                    name, max_name_length));
}

}  // namespace prosector
