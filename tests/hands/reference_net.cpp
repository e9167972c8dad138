#include "tests/hands/reference_net.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosector {
namespace {

using Numbers = std::vector<float>;
using Shape = std::vector<std::size_t>;

/// One picture with its shape.
struct Picture {
  const Shape& shape;
  const Numbers& x;
  float at(long y, long column, std::size_t c) const {
    return x[(static_cast<std::size_t>(y) * shape[2] + static_cast<std::size_t>(column)) * shape[3] + c];
  }
  bool inside(long y, long column) const {
    return y >= 0 && column >= 0 && y < static_cast<long>(shape[1]) && column < static_cast<long>(shape[2]);
  }
};

float activated(float x, Activation activation) {
  if (activation != Activation::none) x = std::max(x, 0.F);
  return activation == Activation::relu6 ? std::min(x, 6.F) : x;
}

/// Returns how many zeros go before the first pixel, as TensorFlow counts them.
long before_first(std::size_t in, std::size_t out, std::size_t stride, std::size_t window,
                  std::size_t dilation, bool same) {
  const long needed =
      static_cast<long>((out - 1) * stride + (window - 1) * dilation + 1) - static_cast<long>(in);
  return same ? std::max(needed, 0L) / 2 : 0;
}

/// Calls `use(output index, y, x of the input, place in the window)` for each pixel below each window.
template <typename Use>
void slide(const NetLayer& l, const Shape& in, const Shape& out, std::size_t wy, std::size_t wx,
           const Use& use) {
  const long top = before_first(in[1], out[1], l.stride_y, wy, l.dilation_y, l.same);
  const long left = before_first(in[2], out[2], l.stride_x, wx, l.dilation_x, l.same);
  for (std::size_t y = 0; y < out[1]; ++y)
    for (std::size_t x = 0; x < out[2]; ++x)
      for (std::size_t v = 0; v < wy; ++v)
        for (std::size_t u = 0; u < wx; ++u)
          use(y * out[2] + x, static_cast<long>(y * l.stride_y + v * l.dilation_y) - top,
              static_cast<long>(x * l.stride_x + u * l.dilation_x) - left, v * wx + u);
}

Numbers convolved(const NetPlan& plan, const NetLayer& l, const Picture& in) {
  const NetTensor& filter = plan.tensors[l.inputs[1]];
  const Shape& shape = plan.tensors[l.output].shape;
  const bool each = l.kind == LayerKind::depthwise;
  const std::size_t channels = in.shape[3], made = shape[3], wy = filter.shape[1], wx = filter.shape[2];
  Numbers out(tensor_size(shape));
  if (l.inputs.size() > 2)
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = plan.tensors[l.inputs[2]].values[k % made];
  slide(l, in.shape, shape, wy, wx, [&](std::size_t pixel, long y, long x, std::size_t w) {
    if (!in.inside(y, x)) return;
    for (std::size_t o = 0; o < made; ++o)
      if (each)
        out[pixel * made + o] += in.at(y, x, o * channels / made) * filter.values[w * made + o];
      else
        for (std::size_t c = 0; c < channels; ++c)
          out[pixel * made + o] += in.at(y, x, c) * filter.values[(o * wy * wx + w) * channels + c];
  });
  return out;
}

Numbers pooled(const NetPlan& plan, const NetLayer& l, const Picture& in) {
  const Shape& shape = plan.tensors[l.output].shape;
  Numbers out(tensor_size(shape), -std::numeric_limits<float>::infinity());
  slide(l, in.shape, shape, l.window_y, l.window_x, [&](std::size_t pixel, long y, long x, std::size_t) {
    if (!in.inside(y, x)) return;
    for (std::size_t c = 0; c < shape[3]; ++c)
      out[pixel * shape[3] + c] = std::max(out[pixel * shape[3] + c], in.at(y, x, c));
  });
  return out;
}

Numbers resized(const NetPlan& plan, const NetLayer& l, const Picture& in) {
  const Shape& shape = plan.tensors[l.output].shape;
  Numbers out;
  const auto source = [](std::size_t k, std::size_t from, std::size_t to) {
    return std::max((static_cast<float>(k) + 0.5F) * static_cast<float>(from) / static_cast<float>(to) - 0.5F,
                    0.F);
  };
  for (std::size_t y = 0; y < shape[1]; ++y)
    for (std::size_t x = 0; x < shape[2]; ++x)
      for (std::size_t c = 0; c < shape[3]; ++c) {
        const float v = source(y, in.shape[1], shape[1]), u = source(x, in.shape[2], shape[2]);
        const long top = static_cast<long>(v), left = static_cast<long>(u);
        const long bottom = std::min(top + 1, static_cast<long>(in.shape[1]) - 1),
                   right = std::min(left + 1, static_cast<long>(in.shape[2]) - 1);
        const float b = v - static_cast<float>(top), a = u - static_cast<float>(left);
        out.push_back((1 - b) * ((1 - a) * in.at(top, left, c) + a * in.at(top, right, c)) +
                      b * ((1 - a) * in.at(bottom, left, c) + a * in.at(bottom, right, c)));
      }
  return out;
}

Numbers padded(const NetPlan& plan, const NetLayer& l, const Picture& in) {
  const Shape& shape = plan.tensors[l.output].shape;
  Numbers out(tensor_size(shape));
  for (std::size_t y = 0; y < in.shape[1]; ++y)
    for (std::size_t x = 0; x < in.shape[2]; ++x)
      for (std::size_t c = 0; c < in.shape[3]; ++c)
        out[((y + l.before[1]) * shape[2] + x + l.before[2]) * shape[3] + c + l.before[3]] =
            in.at(static_cast<long>(y), static_cast<long>(x), c);
  return out;
}

Numbers averaged(const Picture& in) {
  Numbers out(in.shape[3]);
  for (std::size_t k = 0; k < in.x.size(); ++k) out[k % out.size()] += in.x[k];
  for (float& x : out) x /= static_cast<float>(in.shape[1] * in.shape[2]);
  return out;
}

Numbers connected(const NetPlan& plan, const NetLayer& l, const Numbers& in) {
  const NetTensor& filter = plan.tensors[l.inputs[1]];
  Numbers out(filter.shape[0]);
  for (std::size_t o = 0; o < out.size(); ++o) {
    if (l.inputs.size() > 2) out[o] = plan.tensors[l.inputs[2]].values[o];
    for (std::size_t k = 0; k < in.size(); ++k) out[o] += in[k] * filter.values[o * in.size() + k];
  }
  return out;
}

Numbers made_by(const NetPlan& plan, const NetLayer& l, const std::vector<Numbers>& known) {
  const Numbers& first = known[l.inputs[0]];
  const Picture in{plan.tensors[l.inputs[0]].shape, first};
  Numbers out = first;
  switch (l.kind) {
    case LayerKind::add:
      for (std::size_t k = 0; k < out.size(); ++k) out[k] += known[l.inputs[1]][k];
      return out;
    case LayerKind::concatenation:
      for (std::size_t k = 1; k < l.inputs.size(); ++k)
        out.insert(out.end(), known[l.inputs[k]].begin(), known[l.inputs[k]].end());
      return out;
    case LayerKind::convolution:
    case LayerKind::depthwise:
      return convolved(plan, l, in);
    case LayerKind::fully_connected:
      return connected(plan, l, first);
    case LayerKind::logistic:
      for (float& x : out) x = 1 / (1 + std::exp(-x));
      return out;
    case LayerKind::max_pool:
      return pooled(plan, l, in);
    case LayerKind::mean:
      return averaged(in);
    case LayerKind::pad:
      return padded(plan, l, in);
    case LayerKind::prelu:
      for (std::size_t k = 0; k < out.size(); ++k)
        if (const Numbers& slopes = known[l.inputs[1]]; out[k] < 0) out[k] *= slopes[k % slopes.size()];
      return out;
    case LayerKind::relu:
      for (float& x : out) x = std::max(x, 0.F);
      return out;
    case LayerKind::reshape:
      return out;
    case LayerKind::resize_bilinear:
      return resized(plan, l, in);
  }
  return out;
}

/// Makes a network layer after layer.
class NetMaker {
 public:
  explicit NetMaker(Random& random) : random_(random) {}

  std::size_t open(Shape shape) {
    plan.tensors.push_back({std::move(shape)});
    return plan.tensors.size() - 1;
  }
  std::size_t constant(Shape shape, double reach) {
    const std::size_t out = open(std::move(shape));
    for (std::size_t k = 0; k < tensor_size(plan.tensors[out].shape); ++k)
      plan.tensors[out].values.push_back(static_cast<float>(random_.uniform(-reach, reach)));
    return out;
  }
  std::size_t add(NetLayer layer, Shape shape) {
    layer.output = open(std::move(shape));
    plan.layers.push_back(std::move(layer));
    return plan.layers.back().output;
  }
  const Shape& shape(std::size_t tensor) const { return plan.tensors[tensor].shape; }

  std::size_t slide(LayerKind kind, std::size_t in, std::size_t channels, std::size_t window,
                    Activation activation) {
    const Shape from = shape(in);
    NetLayer l{.kind = kind, .inputs = {in}, .activation = activation};
    l.same = random_.below(3) != 0;
    l.stride_x = l.stride_y = 1 + random_.below(2);
    const std::size_t taken = l.same ? 0 : window - 1;
    if (kind == LayerKind::max_pool)
      l.window_x = l.window_y = window;
    else {
      const bool each = kind == LayerKind::depthwise;
      l.inputs.push_back(constant(
          each ? Shape{1, window, window, channels} : Shape{channels, window, window, from[3]}, 0.5));
      l.inputs.push_back(constant({channels}, 0.5));
    }
    const auto along = [&](std::size_t n) { return (n - taken + l.stride_x - 1) / l.stride_x; };
    return add(std::move(l), {1, along(from[1]), along(from[2]), channels});
  }

  NetPlan plan;

 private:
  Random& random_;
};

}  // namespace

std::vector<std::vector<float>> run_slowly(const NetPlan& plan, const std::vector<float>& input) {
  std::vector<Numbers> known;
  for (const NetTensor& tensor : plan.tensors) known.push_back(tensor.values);
  known[plan.input] = input;
  for (const NetLayer& l : plan.layers) {
    known[l.output] = made_by(plan, l, known);
    for (float& x : known[l.output]) x = activated(x, l.activation);
  }
  std::vector<Numbers> out;
  for (const std::size_t t : plan.outputs) out.push_back(known[t]);
  return out;
}

NetPlan random_net(Random& random) {
  NetMaker net(random);
  const std::size_t size = 13 + random.below(8), channels = 1 + random.below(9);
  const auto window = [&] { return 1 + random.below(4); };
  net.plan.input = net.open({1, size, size + random.below(4), 3});
  std::size_t x = net.slide(LayerKind::convolution, net.plan.input, channels, window(), Activation::relu6);
  x = net.slide(LayerKind::depthwise, x, channels, window(), Activation::none);
  x = net.add({.kind = LayerKind::prelu, .inputs = {x, net.constant({1, 1, channels}, 1)}}, net.shape(x));
  const Shape wider = {1, net.shape(x)[1], net.shape(x)[2], channels + 2};
  x = net.add({.kind = LayerKind::pad, .inputs = {x}, .before = {0, 0, 0, 0}, .after = {0, 0, 0, 2}}, wider);
  x = net.slide(LayerKind::max_pool, x, channels + 2, 2, Activation::none);
  const Shape doubled = {1, 2 * net.shape(x)[1], 2 * net.shape(x)[2], channels + 2};
  x = net.add({.kind = LayerKind::resize_bilinear, .inputs = {x}}, doubled);
  const std::size_t one = net.add({.kind = LayerKind::relu, .inputs = {x}}, net.shape(x));
  x = net.add({.kind = LayerKind::add, .inputs = {x, one}, .activation = Activation::relu}, net.shape(x));
  const std::size_t pixels = doubled[1] * doubled[2] * (channels + 2);
  const std::size_t flat = net.add({.kind = LayerKind::reshape, .inputs = {x}}, {1, pixels, 1});
  const std::size_t small = net.slide(LayerKind::convolution, x, 4, 1, Activation::none);
  const std::size_t rest = tensor_size(net.shape(small));
  const std::size_t other = net.add({.kind = LayerKind::reshape, .inputs = {small}}, {1, rest, 1});
  net.plan.outputs.push_back(
      net.add({.kind = LayerKind::concatenation, .inputs = {flat, other}}, {1, pixels + rest, 1}));
  x = net.add({.kind = LayerKind::mean, .inputs = {x}}, {1, channels + 2});
  x = net.add({.kind = LayerKind::fully_connected,
               .inputs = {x, net.constant({5, channels + 2}, 1), net.constant({5}, 1)}},
              {1, 5});
  net.plan.outputs.push_back(net.add({.kind = LayerKind::logistic, .inputs = {x}}, {1, 5}));
  return net.plan;
}

}  // namespace prosector
