#pragma once
// Lookup of a name in one of the tables (laws, integrators, solvers).

#include <fmt/format.h>

#include <string>
#include <vector>

#include "common/error.h"

namespace prosector::soft {

/// Returns the row called `name` of a table of models, laws, integrators or solvers. Throws InputError that
/// lists the allowed names if there is none. `field`: name of the scene file's field, for the message.
template <class Row>
const Row& find_row(const std::vector<Row>& rows, const char* field, const std::string& name) {
  std::string allowed;
  for (const Row& row : rows) {
    if (name == row.name) return row;
    allowed += (allowed.empty() ? "" : ", ") + std::string(row.name);
  }
  throw InputError(fmt::format("{} is \"{}\"; allowed: {}", field, name, allowed));
}

}  // namespace prosector::soft
