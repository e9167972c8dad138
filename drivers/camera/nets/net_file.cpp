// Tables and fields of the format: tensorflow/lite/schema/schema.fbs, version 3.
#include "drivers/camera/nets/net_file.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <map>

#include "common/error.h"
#include "common/regular_file.h"
#include "drivers/camera/nets/flat_table.h"

namespace prosector {
namespace {

constexpr std::size_t most_file_bytes = 256u << 20;
constexpr std::size_t most_entries = 20000;  // limit on tensors, layers and buffers
constexpr std::size_t most_dimensions = 6;
constexpr std::size_t most_inputs = 64;  // limit per layer
constexpr std::uint32_t known_version = 3;

// Field indices of the tables, and values of their enumerations.
enum ModelField : std::uint8_t { model_version, model_codes, model_graphs, model_description, model_buffers };
enum CodeField : std::uint8_t { code_old = 0, code_new = 3 };
enum GraphField : std::uint8_t { graph_tensors, graph_inputs, graph_outputs, graph_layers };
enum TensorField : std::uint8_t { tensor_shape, tensor_type, tensor_buffer };
enum LayerField : std::uint8_t { layer_code, layer_inputs, layer_outputs, layer_options = 4 };
enum TensorType : std::uint8_t { float32 = 0, float16 = 1, int32 = 2 };
constexpr std::int32_t dequantize_code = 6, pad_code = 34, mean_code = 40;
const std::map<std::int32_t, LayerKind> kinds = {{0, LayerKind::add},
                                                 {2, LayerKind::concatenation},
                                                 {3, LayerKind::convolution},
                                                 {4, LayerKind::depthwise},
                                                 {9, LayerKind::fully_connected},
                                                 {14, LayerKind::logistic},
                                                 {17, LayerKind::max_pool},
                                                 {19, LayerKind::relu},
                                                 {22, LayerKind::reshape},
                                                 {23, LayerKind::resize_bilinear},
                                                 {pad_code, LayerKind::pad},
                                                 {mean_code, LayerKind::mean},
                                                 {54, LayerKind::prelu}};

template <typename Number>
Number number_at(FlatTable::Bytes data, std::size_t k) {
  Number out;
  std::memcpy(&out, data.data() + k * sizeof(Number), sizeof(Number));
  return out;
}

/// Parser of a file's single graph into a plan.
class GraphReader {
 public:
  explicit GraphReader(FlatTable::Bytes file) : model_(FlatTable::root(file)) {
    if (const auto version = model_.number<std::uint32_t>(model_version, 0); version != known_version)
      throw InputError(fmt::format("has version {}, supported: {}", version, known_version));
    for (const FlatTable& code : model_.tables(model_codes, most_entries))
      codes_.push_back(std::max<std::int32_t>(code.number<std::int8_t>(code_old, 0),
                                              code.number<std::int32_t>(code_new, 0)));
    buffers_ = model_.tables(model_buffers, most_entries);
    budget_ = 2 * file.size();
  }

  NetPlan read() {
    const auto graphs = model_.tables(model_graphs, most_entries);
    if (graphs.size() != 1) throw InputError(fmt::format("has {} graphs, must be 1", graphs.size()));
    for (const FlatTable& tensor : graphs[0].tables(graph_tensors, most_entries)) take_tensor(tensor);
    const auto inputs = graphs[0].integers(graph_inputs, most_inputs);
    if (inputs.size() != 1) throw InputError(fmt::format("has {} inputs, must be 1", inputs.size()));
    plan_.input = tensor_of(inputs[0]);
    for (const std::int32_t t : graphs[0].integers(graph_outputs, most_inputs))
      plan_.outputs.push_back(tensor_of(t));
    for (const FlatTable& layer : graphs[0].tables(graph_layers, most_entries)) take_layer(layer);
    check(plan_);
    return std::move(plan_);
  }

 private:
  std::size_t tensor_of(std::int32_t number) const {
    if (number < 0 || static_cast<std::size_t>(number) >= plan_.tensors.size())
      throw InputError(fmt::format("the network refers to tensor {}, but there are only {} tensors", number,
                                   plan_.tensors.size()));
    return static_cast<std::size_t>(number);
  }

  void take_tensor(const FlatTable& table) {
    NetTensor tensor;
    for (const std::int32_t n : table.integers(tensor_shape, most_dimensions)) {
      if (n <= 0) throw InputError(fmt::format("tensor {} has a dimension of {}", plan_.tensors.size(), n));
      tensor.shape.push_back(static_cast<std::size_t>(n));
    }
    const auto type = table.number<std::int8_t>(tensor_type, 0);
    const auto buffer = table.number<std::uint32_t>(tensor_buffer, 0);
    if (buffer >= buffers_.size())
      throw InputError(fmt::format("the network refers to buffer {}, but there are only {} buffers", buffer,
                                   buffers_.size()));
    const FlatTable::Bytes data = buffers_[buffer].bytes(0);
    take_data(type, data, tensor);
    plan_.tensors.push_back(std::move(tensor));
  }

  void take_data(std::int8_t type, FlatTable::Bytes data, NetTensor& tensor) {
    integers_.emplace_back();
    if (data.size() > budget_)
      throw InputError(
          "the network's tensors use the same buffers too often: they exceed twice the file's size");
    budget_ -= data.size();
    if (type == float32)
      for (std::size_t k = 0; k < data.size() / 4; ++k) tensor.values.push_back(number_at<float>(data, k));
    else if (type == float16)
      for (std::size_t k = 0; k < data.size() / 2; ++k)
        tensor.values.push_back(from_half(number_at<std::uint16_t>(data, k)));
    else if (type == int32)
      for (std::size_t k = 0; k < data.size() / 4; ++k)
        integers_.back().push_back(number_at<std::int32_t>(data, k));
    else
      throw InputError(fmt::format("tensor {} has type {}; supported: float32, float16 and int32",
                                   plan_.tensors.size(), type));
    for (const float x : tensor.values)
      if (!std::isfinite(x)) throw InputError(fmt::format("tensor {} contains NaN", plan_.tensors.size()));
  }

  void take_layer(const FlatTable& table) {
    const auto code_number = table.number<std::uint32_t>(layer_code, 0);
    if (code_number >= codes_.size())
      throw InputError(fmt::format("the network refers to layer code {}, but there are only {} codes",
                                   code_number, codes_.size()));
    const std::int32_t code = codes_[code_number];
    std::vector<std::size_t> inputs;
    for (const std::int32_t t : table.integers(layer_inputs, most_inputs))
      if (t != -1) inputs.push_back(tensor_of(t));
    const auto outputs = table.integers(layer_outputs, most_inputs);
    if (outputs.size() != 1 || inputs.empty())
      throw InputError("the network has a layer without input, or without exactly one output");
    const std::size_t output = tensor_of(outputs[0]);
    if (code == dequantize_code) {
      plan_.tensors[output].values = plan_.tensors[inputs[0]].values;  // converted from halves when read
      return;
    }
    const auto kind = kinds.find(code);
    if (kind == kinds.end())
      throw InputError(fmt::format(
          "the network uses layers of kind {} (TensorFlow Lite operator code), which are not supported",
          code));
    NetLayer layer{.kind = kind->second, .inputs = std::move(inputs), .output = output};
    if (const auto options = table.table(layer_options)) take_options(*options, layer);
    take_integers(layer);
    plan_.layers.push_back(std::move(layer));
  }

  /// Reads constant inputs that are parameters of the layer; they are not tensors of the plan.
  void take_integers(NetLayer& layer) const {
    const bool how = layer.kind == LayerKind::pad || layer.kind == LayerKind::mean ||
                     layer.kind == LayerKind::reshape || layer.kind == LayerKind::resize_bilinear;
    if (!how) return;
    const std::vector<std::int32_t> none,
        &parameters = layer.inputs.size() > 1 ? integers_[layer.inputs[1]] : none;
    if (layer.inputs.size() > 1) layer.inputs.erase(layer.inputs.begin() + 1, layer.inputs.end());
    if (layer.kind == LayerKind::mean && parameters != std::vector<std::int32_t>{1, 2})
      throw InputError(
          "the network has a mean over dimensions other than height and width, which is not supported");
    if (layer.kind != LayerKind::pad) return;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      if (parameters[k] < 0) throw InputError(fmt::format("pads by {}", parameters[k]));
      (k % 2 == 0 ? layer.before : layer.after).push_back(static_cast<std::size_t>(parameters[k]));
    }
  }

  static std::size_t size_of(const FlatTable& options, std::size_t field, std::int32_t otherwise = 0) {
    const auto n = options.number<std::int32_t>(field, otherwise);
    if (n < 0)
      throw InputError(fmt::format(
          "the network has a layer with a window, stride or dilation of {}; it must not be negative", n));
    return static_cast<std::size_t>(n);
  }

  static void take_activation(const FlatTable& options, std::size_t field, NetLayer& layer) {
    const auto code = options.number<std::int8_t>(field, 0);
    if (code != 0 && code != 1 && code != 3)
      throw InputError(
          fmt::format("the network has a layer with activation {}; supported: none, relu and relu6", code));
    layer.activation = code == 0 ? Activation::none : code == 1 ? Activation::relu : Activation::relu6;
  }

  static void take_options(const FlatTable& options, NetLayer& layer) {
    const bool depthwise = layer.kind == LayerKind::depthwise, pool = layer.kind == LayerKind::max_pool;
    switch (layer.kind) {
      case LayerKind::convolution:
      case LayerKind::depthwise:
      case LayerKind::max_pool:
        layer.same = options.number<std::int8_t>(0, 0) == 0;
        layer.stride_x = size_of(options, 1);
        layer.stride_y = size_of(options, 2);
        if (pool) {
          layer.window_x = size_of(options, 3);
          layer.window_y = size_of(options, 4);
        } else {
          layer.dilation_x = size_of(options, depthwise ? 5 : 4, 1);
          layer.dilation_y = size_of(options, depthwise ? 6 : 5, 1);
        }
        return take_activation(options, pool ? 5 : depthwise ? 4 : 3, layer);
      case LayerKind::add:
      case LayerKind::fully_connected:
        return take_activation(options, 0, layer);
      case LayerKind::concatenation:
        if (options.number<std::int32_t>(0, 0) != 1)
          throw InputError(
              "the network concatenates along a dimension other than the second, which is not supported");
        return;
      case LayerKind::resize_bilinear:
        if (options.number<std::int8_t>(2, 0) != 0 || options.number<std::int8_t>(3, 0) == 0)
          throw InputError("the network resizes images without half-pixel centres, which is not supported");
        return;
      default:
        return;
    }
  }

  FlatTable model_;
  std::vector<std::int32_t> codes_;
  std::vector<FlatTable> buffers_;
  std::vector<std::vector<std::int32_t>>
      integers_;            // one list per tensor; empty unless it is an integer constant
  std::size_t budget_ = 0;  // bytes of constants that may still be read
  NetPlan plan_;
};

}  // namespace

float from_half(std::uint16_t half) {
  const std::uint32_t sign = static_cast<std::uint32_t>(half & 0x8000u) << 16,
                      exponent = (half >> 10) & 0x1fu, rest = half & 0x3ffu;
  if (exponent == 0x1f) return std::bit_cast<float>(sign | 0x7f800000u | rest << 13);
  if (exponent == 0)
    return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(static_cast<float>(rest) * 0x1p-24F));
  return std::bit_cast<float>(sign | (exponent + 112) << 23 | rest << 13);
}

NetPlan read_net(std::span<const std::uint8_t> file) {
  if (file.size() < 8 || std::memcmp(file.data() + 4, "TFL3", 4) != 0)
    throw InputError("the file is not a TensorFlow Lite file");
  return GraphReader(file).read();
}

NetPlan load_fetched_net(const std::filesystem::path& folder, const std::string& name,
                         const std::string& what) {
  const std::filesystem::path file = folder / name;
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw InputError(fmt::format(
        "{} need the network file '{}', which is missing: run deploy/fetch_models.sh", what, file.string()));
  return load_net(file);
}

NetPlan load_net(const std::filesystem::path& file) {
  const std::string bytes = read_regular_file(file, most_file_bytes);
  try {
    return read_net({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  } catch (const InputError& error) {
    throw InputError(fmt::format("network '{}': {}", file.string(), error.what()));
  }
}

}  // namespace prosector
