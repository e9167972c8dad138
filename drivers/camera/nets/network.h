#pragma once
// Runs a neural network on one thread.

#include <memory>
#include <span>

#include "drivers/camera/nets/net_plan.h"

namespace prosector {

class Network {
 public:
  /// Prepares a neural network for execution. Throws InputError for an inconsistent plan or one that this
  /// machine cannot run.
  explicit Network(NetPlan plan);
  ~Network();
  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;

  /// Returns the buffer of the network's input values, which the caller fills before run().
  std::span<float> input();
  void run();
  /// Returns the values of the network's output number `number` (index in NetPlan::outputs), as computed by
  /// run().
  std::span<const float> output(std::size_t number) const;
  std::size_t outputs() const;

 private:
  struct Runtime;
  std::unique_ptr<Runtime> runtime_;
};

}  // namespace prosector
