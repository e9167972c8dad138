#pragma once
// What figures were measured on, so that they can be compared.

#include <nlohmann/json.hpp>

namespace prosector {

/// CPU, cores, compiler, build type and commit.
nlohmann::json machine();

}  // namespace prosector
