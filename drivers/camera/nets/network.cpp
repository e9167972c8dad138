// Builds an XNNPACK subgraph: a value for each tensor, a node for each layer. Plans store filters in
// XNNPACK's layout.
#include "drivers/camera/nets/network.h"

#include <fmt/format.h>
#include <xnnpack.h>

#include <algorithm>
#include <limits>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t spare =
    XNN_EXTRA_BYTES / sizeof(float);  // numbers that XNNPACK may read beyond a buffer's end

struct DeleteSubgraph {
  void operator()(xnn_subgraph_t subgraph) const { xnn_delete_subgraph(subgraph); }
};
struct DeleteRuntime {
  void operator()(xnn_runtime_t runtime) const { xnn_delete_runtime(runtime); }
};

void ask(xnn_status status, const std::string& what) {
  if (status != xnn_status_success)
    throw InputError(
        fmt::format("{} cannot be run on this machine (XNNPACK status {})", what, static_cast<int>(status)));
}

/// Buffer position of an external tensor.
struct ExternalTensor {
  std::size_t tensor = 0;
  std::size_t buffer = 0;  // 0: input; from 1: outputs
  std::size_t first = 0;   // index in that buffer
};

/// Lists the buffer positions of the input and the outputs. The inputs of a concatenation are written
/// directly to their parts of its output.
std::vector<ExternalTensor> external_tensors(const NetPlan& plan) {
  std::vector<ExternalTensor> out = {{plan.input, 0, 0}};
  for (std::size_t k = 0; k < plan.outputs.size(); ++k) {
    const auto joined = std::find_if(plan.layers.begin(), plan.layers.end(), [&](const NetLayer& layer) {
      return layer.kind == LayerKind::concatenation && layer.output == plan.outputs[k];
    });
    if (joined == plan.layers.end()) {
      out.push_back({plan.outputs[k], k + 1, 0});
      continue;
    }
    std::size_t first = 0;
    for (const std::size_t t : joined->inputs) {
      out.push_back({t, k + 1, first});
      first += tensor_size(plan.tensors[t].shape);
    }
  }
  std::vector<std::size_t> tensors;
  for (const ExternalTensor& place : out) tensors.push_back(place.tensor);
  std::sort(tensors.begin(), tensors.end());
  if (std::adjacent_find(tensors.begin(), tensors.end()) != tensors.end())
    throw InputError("a tensor is listed twice in the network's outputs");
  return out;
}

class SubgraphBuilder {
 public:
  explicit SubgraphBuilder(const NetPlan& plan) : plan_(plan) {
    ask(xnn_initialize(nullptr), "a network");
    xnn_subgraph_t made = nullptr;
    ask(xnn_create_subgraph(static_cast<std::uint32_t>(plan.tensors.size()), 0, &made), "a network");
    subgraph_.reset(made);
  }

  xnn_subgraph_t build(const std::vector<ExternalTensor>& outer) {
    std::vector<std::uint32_t> flags(plan_.tensors.size());
    for (const ExternalTensor& place : outer)
      flags[place.tensor] =
          place.buffer == 0 ? XNN_VALUE_FLAG_EXTERNAL_INPUT : XNN_VALUE_FLAG_EXTERNAL_OUTPUT;
    std::vector<bool> used(plan_.tensors.size());
    for (const NetLayer& layer : plan_.layers) {
      for (const std::size_t t : layer.inputs) used[t] = true;
      used[layer.output] = layer.kind != LayerKind::concatenation;
    }
    for (std::size_t t = 0; t < plan_.tensors.size(); ++t)
      if (used[t]) define_tensor(t, flags[t]);
    for (std::size_t k = 0; k < plan_.layers.size(); ++k)
      ask(define(plan_.layers[k]), fmt::format("layer {}", k));
    return subgraph_.get();
  }

 private:
  static std::uint32_t id(std::size_t tensor) { return static_cast<std::uint32_t>(tensor); }

  void define_tensor(std::size_t t, std::uint32_t flags) {
    const NetTensor& tensor = plan_.tensors[t];
    std::vector<std::size_t> shape = tensor.shape;
    // XNNPACK wants slopes with one dimension, and means with all dimensions.
    for (const NetLayer& layer : plan_.layers) {
      if (layer.kind == LayerKind::prelu && layer.inputs[1] == t) shape = {tensor_size(shape)};
      if (layer.kind == LayerKind::mean && layer.output == t) shape = {1, 1, 1, shape.back()};
    }
    std::uint32_t got = 0;
    ask(xnn_define_tensor_value(subgraph_.get(), xnn_datatype_fp32, shape.size(), shape.data(),
                                tensor.values.empty() ? nullptr : tensor.values.data(), id(t), flags, &got),
        fmt::format("tensor {}", t));
  }

  static float lowest(const NetLayer& layer) {
    return layer.activation == Activation::none ? -std::numeric_limits<float>::infinity() : 0;
  }
  static float highest(const NetLayer& layer) {
    return layer.activation == Activation::relu6 ? 6 : std::numeric_limits<float>::infinity();
  }
  static std::uint32_t bias(const NetLayer& layer) {
    return layer.inputs.size() > 2 ? id(layer.inputs[2]) : XNN_INVALID_VALUE_ID;
  }
  static std::uint32_t padding(const NetLayer& layer) {
    return layer.same ? XNN_FLAG_TENSORFLOW_SAME_PADDING : 0;
  }
  static std::uint32_t size(std::size_t n) { return static_cast<std::uint32_t>(n); }

  xnn_status convolve(const NetLayer& l) {
    const auto& filter = plan_.tensors[l.inputs[1]].shape;
    return xnn_define_convolution_2d(subgraph_.get(), 0, 0, 0, 0, size(filter[1]), size(filter[2]),
                                     size(l.stride_y), size(l.stride_x), size(l.dilation_y),
                                     size(l.dilation_x), 1, filter[3], filter[0], lowest(l), highest(l),
                                     id(l.inputs[0]), id(l.inputs[1]), bias(l), id(l.output), padding(l));
  }
  xnn_status convolve_each(const NetLayer& l) {
    const auto& filter = plan_.tensors[l.inputs[1]].shape;
    const std::size_t channels = plan_.tensors[l.inputs[0]].shape[3];
    return xnn_define_depthwise_convolution_2d(
        subgraph_.get(), 0, 0, 0, 0, size(filter[1]), size(filter[2]), size(l.stride_y), size(l.stride_x),
        size(l.dilation_y), size(l.dilation_x), size(filter[3] / channels), channels, lowest(l), highest(l),
        id(l.inputs[0]), id(l.inputs[1]), bias(l), id(l.output), padding(l));
  }
  xnn_status define(const NetLayer& l) {
    const xnn_subgraph_t graph = subgraph_.get();
    const std::uint32_t in = id(l.inputs[0]), out = id(l.output);
    const auto& shape = plan_.tensors[l.output].shape;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    switch (l.kind) {
      case LayerKind::add:
        return xnn_define_add2(graph, lowest(l), highest(l), in, id(l.inputs[1]), out, 0);
      case LayerKind::concatenation:
        return xnn_status_success;
      case LayerKind::convolution:
        return convolve(l);
      case LayerKind::depthwise:
        return convolve_each(l);
      case LayerKind::fully_connected:
        return xnn_define_fully_connected(graph, lowest(l), highest(l), in, id(l.inputs[1]), bias(l), out,
                                          XNN_FLAG_TENSORFLOW_RESHAPE_2D);
      case LayerKind::logistic:
        return xnn_define_sigmoid(graph, in, out, 0);
      case LayerKind::max_pool:
        return xnn_define_max_pooling_2d(graph, 0, 0, 0, 0, size(l.window_y), size(l.window_x),
                                         size(l.stride_y), size(l.stride_x), size(l.dilation_y),
                                         size(l.dilation_x), -infinity, infinity, in, out, padding(l));
      case LayerKind::mean:
        return xnn_define_global_average_pooling_2d(graph, -infinity, infinity, in, out, 0);
      case LayerKind::pad:
        return xnn_define_static_constant_pad(graph, l.before.data(), l.after.data(), 0, in, out, 0);
      case LayerKind::prelu:
        return xnn_define_prelu(graph, in, id(l.inputs[1]), out, 0);
      case LayerKind::relu:
        return xnn_define_clamp(graph, 0, infinity, in, out, 0);
      case LayerKind::reshape:
        return xnn_define_static_reshape(graph, shape.size(), shape.data(), in, out, 0);
      case LayerKind::resize_bilinear:
        return xnn_define_static_resize_bilinear_2d(graph, shape[1], shape[2], in, out, 0);
    }
    return xnn_status_invalid_parameter;
  }

  const NetPlan& plan_;
  std::unique_ptr<xnn_subgraph, DeleteSubgraph> subgraph_;
};

}  // namespace

struct Network::Runtime {
  explicit Runtime(NetPlan described) : plan(std::move(described)) {
    check(plan);
    const std::vector<ExternalTensor> outer = external_tensors(plan);
    buffers.emplace_back(tensor_size(plan.tensors[plan.input].shape) + spare);
    for (const std::size_t t : plan.outputs) buffers.emplace_back(tensor_size(plan.tensors[t].shape) + spare);
    SubgraphBuilder builder(plan);
    xnn_runtime_t made = nullptr;
    ask(xnn_create_runtime_v2(builder.build(outer), nullptr, 0, &made), "a network");
    runtime.reset(made);
    std::vector<xnn_external_value> values;
    for (const ExternalTensor& place : outer)
      values.push_back(
          {static_cast<std::uint32_t>(place.tensor), buffers[place.buffer].data() + place.first});
    ask(xnn_setup_runtime(made, values.size(), values.data()), "a network");
  }

  NetPlan plan;                             // XNNPACK points to its constants
  std::vector<std::vector<float>> buffers;  // the input, then the outputs
  std::unique_ptr<xnn_runtime, DeleteRuntime> runtime;
};

Network::Network(NetPlan plan) : runtime_(std::make_unique<Runtime>(std::move(plan))) {}
Network::~Network() = default;
Network::Network(Network&&) noexcept = default;
Network& Network::operator=(Network&&) noexcept = default;

std::size_t Network::outputs() const {
  return runtime_->plan.outputs.size();
}

std::span<float> Network::input() {
  return std::span(runtime_->buffers[0]).first(runtime_->buffers[0].size() - spare);
}

void Network::run() {
  ask(xnn_invoke_runtime(runtime_->runtime.get()), "a network");
}

std::span<const float> Network::output(std::size_t number) const {
  const std::vector<float>& buffer = runtime_->buffers.at(number + 1);
  return std::span(buffer).first(buffer.size() - spare);
}

}  // namespace prosector
