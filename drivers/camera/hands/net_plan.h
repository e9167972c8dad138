#pragma once
// A neural network as plain data: tensors, and the layers that make one of others. Pictures are rows of
// pixels of channels, one at a time: shapes are 1, height, width, channels.

#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

enum class LayerKind : std::uint8_t {
  add,
  concatenation,  // of outputs, along their second dimension
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
  resize_bilinear,  // corners of pixels, not centres, fall together
};

enum class Activation : std::uint8_t { none, relu, relu6 };

struct NetTensor {
  std::vector<std::size_t> shape;
  std::vector<float> values = {};  // of a constant; empty: a layer makes them, or who runs the network
};

struct NetLayer {
  LayerKind kind = LayerKind::add;
  std::vector<std::size_t> inputs;  // tensors; then a filter's or slopes' constant, then perhaps a bias
  std::size_t output = 0;
  Activation activation = Activation::none;
  bool same = true;                            // as large as the input, but for the stride: padded with zeros
  std::size_t stride_y = 1, stride_x = 1;      // pixels
  std::size_t dilation_y = 1, dilation_x = 1;  // pixels
  std::size_t window_y = 1, window_x = 1;      // max_pool, pixels
  std::vector<std::size_t> before = {}, after = {};  // pad: how many, of each dimension
};

struct NetPlan {
  std::vector<NetTensor> tensors;
  std::vector<NetLayer> layers;  // in the order of running
  std::size_t input = 0;
  std::vector<std::size_t> outputs;
};

/// Returns how many numbers a tensor of that shape has.
std::size_t numbers_of(const std::vector<std::size_t>& shape);

/// Throws InputError where a layer names what isn't there or isn't made yet, or makes another shape than its
/// output has. Throws it, too, where a network would take more than some hundred megabytes.
void check(const NetPlan& plan);

}  // namespace prosector
