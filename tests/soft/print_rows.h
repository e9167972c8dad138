#pragma once
// How GoogleTest names the rows of the tables that tests loop over.

#include <ostream>

#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {

inline void PrintTo(const soft::LawRow& row, std::ostream* out) {
  *out << row.name;
}

}  // namespace prosector
