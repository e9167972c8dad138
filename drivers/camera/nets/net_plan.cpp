#include "drivers/camera/nets/net_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/error.h"

namespace prosector {
namespace {

using Shape = std::vector<std::size_t>;

constexpr std::size_t most_numbers = std::size_t{1} << 25;  // limit per tensor
constexpr std::size_t most_in_all = std::size_t{1} << 27;   // limit on all tensors together
constexpr std::size_t most_of_dimension = std::size_t{1}
                                          << 20;  // limit on dimensions, strides, windows and padding

/// Checks one layer; messages contain its number.
class LayerCheck {
 public:
  LayerCheck(const NetPlan& plan, std::size_t layer)
      : plan_(plan), layer_(plan.layers[layer]), number_(layer) {}

  void take() const {
    ask(layer_.stride_y > 0 && layer_.stride_x > 0, "a stride is 0");
    ask(layer_.dilation_y > 0 && layer_.dilation_x > 0, "a dilation is 0");
    ask(layer_.window_y > 0 && layer_.window_x > 0, "a window is 0");
    for (const std::size_t n : {layer_.stride_y, layer_.stride_x, layer_.dilation_y, layer_.dilation_x,
                                layer_.window_y, layer_.window_x})
      ask(n <= most_of_dimension, "the layer's stride, dilation or window is too large");
    const Shape made = output_shape();
    const Shape& declared = plan_.tensors[layer_.output].shape;
    ask(made == declared,
        fmt::format("the layer produces a tensor of shape [{}], but its output tensor has shape [{}]",
                    fmt::join(made, ", "), fmt::join(declared, ", ")));
  }

 private:
  void ask(bool good, const std::string& otherwise) const {
    if (!good) throw InputError(fmt::format("layer {}: {}", number_, otherwise));
  }
  const NetTensor& in(std::size_t k) const {
    ask(k < layer_.inputs.size(), fmt::format("input {} is missing", k));
    return plan_.tensors[layer_.inputs[k]];
  }
  const Shape& constant(std::size_t k) const {
    ask(!in(k).values.empty(), fmt::format("input {} must be constant", k));
    return in(k).shape;
  }
  const Shape& picture() const {
    const Shape& out = in(0).shape;
    ask(out.size() == 4 && out[0] == 1,
        "the layer's input must be one image (4 dimensions, the first of them 1)");
    return out;
  }
  void ask_bias(std::size_t channels) const {
    if (layer_.inputs.size() < 3) return;
    ask(constant(2) == Shape{channels}, "the layer's bias must have one number for each output channel");
  }
  std::size_t along(std::size_t size, std::size_t window, std::size_t stride, std::size_t dilation) const {
    const std::size_t reach = (window - 1) * dilation + 1;
    ask(layer_.same || reach <= size, "the layer's window is larger than its input image");
    return ((layer_.same ? size : size - reach + 1) + stride - 1) / stride;
  }
  Shape slid(std::size_t window_y, std::size_t window_x, std::size_t channels) const {
    const Shape& x = picture();
    return {1, along(x[1], window_y, layer_.stride_y, layer_.dilation_y),
            along(x[2], window_x, layer_.stride_x, layer_.dilation_x), channels};
  }
  Shape convolved() const {
    const Shape &x = picture(), &filter = constant(1);
    ask(filter.size() == 4 && filter[3] == x[3],
        "the layer's filter does not match the number of channels of its input");
    ask_bias(filter[0]);
    return slid(filter[1], filter[2], filter[0]);
  }
  Shape depthwise() const {
    const Shape &x = picture(), &filter = constant(1);
    ask(filter.size() == 4 && filter[0] == 1 && filter[3] % x[3] == 0,
        "the layer's filter does not match the number of channels of its input");
    ask_bias(filter[3]);
    return slid(filter[1], filter[2], filter[3]);
  }
  Shape connected() const {
    const Shape& filter = constant(1);
    ask(filter.size() == 2 && filter[1] == tensor_size(in(0).shape),
        "the layer's filter does not match the size of its input");
    ask_bias(filter[0]);
    return {1, filter[0]};
  }
  Shape averaged() const {
    const Shape& x = picture();
    const std::size_t rank = plan_.tensors[layer_.output].shape.size();
    return rank == 2 ? Shape{1, x[3]} : Shape{1, 1, 1, x[3]};
  }
  Shape padded() const {
    Shape x = picture();
    ask(layer_.before.size() == 4 && layer_.after.size() == 4, "a padding layer must pad four dimensions");
    for (std::size_t d = 0; d < 4; ++d) {
      ask(std::max(layer_.before[d], layer_.after[d]) <= most_of_dimension, "it pads too much");
      x[d] += layer_.before[d] + layer_.after[d];
    }
    return x;
  }
  Shape resized() const {
    const Shape &x = picture(), &declared = plan_.tensors[layer_.output].shape;
    ask(declared.size() == 4, "the layer's output must be one image (4 dimensions)");
    return {1, declared[1], declared[2], x[3]};
  }
  Shape joined() const {
    ask(!layer_.inputs.empty(), "it concatenates nothing");
    Shape out = in(0).shape;
    ask(out.size() >= 2 && out[0] == 1,
        "the layer concatenates tensors whose first dimension is not 1, which is not supported");
    for (std::size_t k = 1; k < layer_.inputs.size(); ++k) {
      Shape x = in(k).shape;
      ask(x.size() == out.size(),
          "the layer concatenates tensors of different dimensions; only the second one may differ");
      out[1] += x[1];
      x[1] = out[1];
      ask(x == out, "the layer concatenates tensors of different dimensions; only the second one may differ");
    }
    ask(std::find(plan_.outputs.begin(), plan_.outputs.end(), layer_.output) != plan_.outputs.end(),
        "a concatenation layer must produce an output of the network");
    return out;
  }
  Shape output_shape() const {
    switch (layer_.kind) {
      case LayerKind::add:
        ask(in(0).shape == in(1).shape, "the layer adds tensors of different dimensions");
        return in(0).shape;
      case LayerKind::concatenation:
        return joined();
      case LayerKind::convolution:
        return convolved();
      case LayerKind::depthwise:
        return depthwise();
      case LayerKind::fully_connected:
        return connected();
      case LayerKind::logistic:
      case LayerKind::relu:
        return in(0).shape;
      case LayerKind::max_pool:
        ask(layer_.window_y * layer_.window_x > 1,
            "the pooling layer's window is one pixel; it must have more");
        return slid(layer_.window_y, layer_.window_x, picture()[3]);
      case LayerKind::mean:
        return averaged();
      case LayerKind::pad:
        return padded();
      case LayerKind::prelu:
        ask(tensor_size(constant(1)) == picture()[3], "a PReLU layer must have one slope for each channel");
        return picture();
      case LayerKind::reshape:
        ask(tensor_size(in(0).shape) == tensor_size(plan_.tensors[layer_.output].shape),
            "the reshape layer changes the number of elements");
        return plan_.tensors[layer_.output].shape;
      case LayerKind::resize_bilinear:
        return resized();
    }
    return {};
  }

  const NetPlan& plan_;
  const NetLayer& layer_;
  std::size_t number_;
};

void check_sizes(const NetPlan& plan) {
  std::size_t total = 0;
  for (std::size_t k = 0; k < plan.tensors.size(); ++k) {
    const NetTensor& tensor = plan.tensors[k];
    std::size_t numbers = 1;
    for (const std::size_t n : tensor.shape) {
      if (n == 0 || n > most_of_dimension || n * numbers > most_numbers)
        throw InputError(fmt::format("tensor {} has the shape [{}]: it is empty or too large", k,
                                     fmt::join(tensor.shape, ", ")));
      numbers *= n;
    }
    if (!tensor.values.empty() && tensor.values.size() != numbers)
      throw InputError(
          fmt::format("tensor {} has {} numbers, but its shape needs {}", k, tensor.values.size(), numbers));
    total += numbers;
  }
  if (total > most_in_all)
    throw InputError(fmt::format("the network's tensors have {} numbers in all, at most {} are allowed",
                                 total, most_in_all));
}

}  // namespace

std::size_t tensor_size(const std::vector<std::size_t>& shape) {
  std::size_t out = 1;
  for (const std::size_t n : shape) out *= n;
  return out;
}

void check(const NetPlan& plan) {
  check_sizes(plan);
  const auto is_tensor = [&](std::size_t t) { return t < plan.tensors.size(); };
  if (!is_tensor(plan.input)) throw InputError("the network's input is not one of its tensors");
  std::vector<bool> made(plan.tensors.size());
  for (std::size_t t = 0; t < made.size(); ++t) made[t] = !plan.tensors[t].values.empty();
  if (made[plan.input]) throw InputError("its input is constant");
  made[plan.input] = true;
  for (std::size_t k = 0; k < plan.layers.size(); ++k) {
    const NetLayer& layer = plan.layers[k];
    for (const std::size_t t : layer.inputs)
      if (!is_tensor(t) || !made[t])
        throw InputError(
            fmt::format("layer {}: its input tensor {} is not produced by an earlier layer", k, t));
    if (layer.inputs.empty() || !is_tensor(layer.output) || made[layer.output])
      throw InputError(
          fmt::format("layer {}: must have an input, and an output that no other layer produces", k));
    LayerCheck(plan, k).take();
    made[layer.output] = true;
  }
  if (plan.outputs.empty()) throw InputError("it has no output");
  for (const std::size_t t : plan.outputs)
    if (!is_tensor(t) || !made[t] || t == plan.input || !plan.tensors[t].values.empty())
      throw InputError(fmt::format("the network's output tensor {} is not produced by any layer", t));
}

}  // namespace prosector
