#pragma once
// Runs a neural network on one thread.

#include <memory>
#include <span>

#include "drivers/camera/nets/net_plan.h"

namespace prosector {

class Network {
 public:
  /// Prepares the network. Throws InputError for a plan that check() rejects or this machine can't run.
  explicit Network(NetPlan plan);
  ~Network();
  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;

  /// Returns the input buffer, to be filled before run().
  std::span<float> input();
  void run();
  /// Returns the plan's output with this index, as computed by run().
  std::span<const float> output(std::size_t number) const;
  std::size_t outputs() const;

 private:
  struct Runtime;
  std::unique_ptr<Runtime> runtime_;
};

}  // namespace prosector
