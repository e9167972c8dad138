#pragma once
// Random numbers for tests that try many cases, and where their seeds come from.

#include <cstdlib>
#include <iostream>
#include <random>

#include "common/math.h"

namespace prosector {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / static_cast<double>(engine_.max());
  }
  Vec3 point(double reach) {  // of a cube around the origin
    return Vec3::NullaryExpr([&] { return uniform(-reach, reach); });
  }
  std::size_t below(std::size_t n) { return engine_() % n; }

 private:
  std::mt19937 engine_;
};

/// An environment variable's, else the other.
inline unsigned number(const char* variable, unsigned otherwise) {
  const char* text = std::getenv(variable);
  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

/// Gives PROSECTOR_SEED, else a fixed seed or a new one each time, and prints it. Tests that ask for a new
/// one are rows of deploy/left_out.txt.
inline unsigned test_seed(bool fixed) {
  const unsigned seed = number("PROSECTOR_SEED", fixed ? 20261122 : std::random_device{}());
  std::cout << "PROSECTOR_SEED=" << seed << std::endl;
  return seed;
}

}  // namespace prosector
