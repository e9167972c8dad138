#pragma once
// A neural network, run on one thread.

#include <memory>
#include <span>

#include "drivers/camera/hands/net_plan.h"

namespace prosector {

class Network {
 public:
  /// Makes it ready. Throws InputError for a plan that check() refuses or this machine can't run.
  explicit Network(NetPlan plan);
  ~Network();
  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;

  /// Returns what to fill before run().
  std::span<float> input();
  void run();
  /// Returns what run() made of an output of the plan, in the plan's order.
  std::span<const float> output(std::size_t number) const;
  std::size_t outputs() const;

 private:
  struct Runtime;
  std::unique_ptr<Runtime> runtime_;
};

}  // namespace prosector
