#pragma once
// A neural network as plain data: tensors, and layers that compute tensors from others. The batch size is 1.
// Image tensors have the shape 1, height, width, channels.

#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

enum class LayerKind : std::uint8_t {
  add,
  concatenation,  // of the inputs, along their second dimension
  convolution,
  depthwise,
  fully_connected,
  logistic,
  max_pool,
  mean,  // over height and width
  pad,   // with zeros
  prelu,
  relu,
  reshape,
  resize_bilinear,  // with aligned corners: corner pixels coincide, not pixel centres
};

enum class Activation : std::uint8_t { none, relu, relu6 };

struct NetTensor {
  std::vector<std::size_t> shape;
  std::vector<float> values = {};  // of a constant; empty: computed by a layer or set by the caller
};

struct NetLayer {
  LayerKind kind = LayerKind::add;
  std::vector<std::size_t>
      inputs;  // indices of tensors; then the constant filter or slopes, then optionally a bias
  std::size_t output = 0;
  Activation activation = Activation::none;
  bool same = true;  // padding with zeros: the output has the input's size divided by the stride
  std::size_t stride_y = 1, stride_x = 1;            // pixels
  std::size_t dilation_y = 1, dilation_x = 1;        // pixels
  std::size_t window_y = 1, window_x = 1;            // max_pool, pixels
  std::vector<std::size_t> before = {}, after = {};  // pad: zeros before and after, for each dimension
};

struct NetPlan {
  std::vector<NetTensor> tensors;
  std::vector<NetLayer> layers;  // in execution order
  std::size_t input = 0;
  std::vector<std::size_t> outputs;
};

/// Returns the number of elements of a tensor with this shape, the product of its dimensions.
std::size_t tensor_size(const std::vector<std::size_t>& shape);

/// Checks a neural network's plan. Throws InputError if a layer uses a tensor that is missing or not yet
/// computed, or if its result differs in shape from its output. Throws InputError if the network needs more
/// than some hundred megabytes.
void check(const NetPlan& plan);

}  // namespace prosector
