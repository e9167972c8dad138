// Writes FlatBuffers front to back: a table, then what it points to.
#include <cmath>
#include <cstring>
#include <functional>
#include <optional>

#include "tests/hands/reference_net.h"

namespace prosector {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Write = std::function<void(Bytes&)>;  // appends an object; its offset is to its first byte

template <typename Number>
void put(Bytes& out, Number x) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(&x);
  out.insert(out.end(), from, from + sizeof x);
}

void align(Bytes& out) {
  while (out.size() % 4 != 0) out.push_back(0);
}

/// A field: its number in place, or what its offset names.
struct Field {
  std::size_t index;
  std::uint32_t number = 0;
  Write object = {};
};

void patch(Bytes& out, std::size_t at, std::uint32_t x) {
  std::memcpy(out.data() + at, &x, sizeof x);
}

/// Appends a table whose fields take 4 bytes each.
void put_table(Bytes& out, const std::vector<Field>& fields) {
  std::size_t entries = 0;
  for (const Field& f : fields) entries = std::max(entries, f.index + 1);
  std::vector<std::uint16_t> at(entries);
  for (std::size_t k = 0; k < fields.size(); ++k) at[fields[k].index] = static_cast<std::uint16_t>(4 + 4 * k);
  const std::size_t table = out.size();
  put(out, std::uint32_t{0});
  for (const Field& f : fields) put(out, f.number);
  const std::size_t list = out.size();
  patch(out, table,
        static_cast<std::uint32_t>(static_cast<std::int32_t>(table) - static_cast<std::int32_t>(list)));
  put(out, static_cast<std::uint16_t>(4 + 2 * entries));
  put(out, static_cast<std::uint16_t>(4 + 4 * fields.size()));
  for (const std::uint16_t a : at) put(out, a);
  align(out);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    if (!fields[k].object) continue;
    const std::size_t place = table + 4 + 4 * k;
    patch(out, place, static_cast<std::uint32_t>(out.size() - place));
    fields[k].object(out);
    align(out);
  }
}

template <typename Number>
Write list_of(std::vector<Number> numbers) {
  return [numbers](Bytes& out) {
    put(out, static_cast<std::uint32_t>(numbers.size()));
    for (const Number x : numbers) put(out, x);
  };
}

template <typename Number, typename From>
Write cast_list(const std::vector<From>& from) {
  std::vector<Number> numbers;
  for (const From x : from) numbers.push_back(static_cast<Number>(x));
  return list_of(numbers);
}

Write table_of(std::vector<Field> fields) {
  return [fields](Bytes& out) { put_table(out, fields); };
}

Write tables_of(std::vector<Write> tables) {
  return [tables](Bytes& out) {
    const std::size_t start = out.size();
    put(out, static_cast<std::uint32_t>(tables.size()));
    for (std::size_t k = 0; k < tables.size(); ++k) put(out, std::uint32_t{0});
    for (std::size_t k = 0; k < tables.size(); ++k) {
      const std::size_t place = start + 4 + 4 * k;
      patch(out, place, static_cast<std::uint32_t>(out.size() - place));
      tables[k](out);
      align(out);
    }
  };
}

/// Rounds to a half-precision float, of normal size or 0.
std::uint16_t to_half(float x) {
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  const std::uint32_t sign = (bits >> 16) & 0x8000u, size = (bits & 0x7fffffffu) + 0x1000u;
  if (size < 0x38800000u) return static_cast<std::uint16_t>(sign);
  return static_cast<std::uint16_t>(sign | ((size >> 13) - (112u << 10)));
}

std::int32_t code_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::add:
      return 0;
    case LayerKind::concatenation:
      return 2;
    case LayerKind::convolution:
      return 3;
    case LayerKind::depthwise:
      return 4;
    case LayerKind::fully_connected:
      return 9;
    case LayerKind::logistic:
      return 14;
    case LayerKind::max_pool:
      return 17;
    case LayerKind::mean:
      return 40;
    case LayerKind::pad:
      return 34;
    case LayerKind::prelu:
      return 54;
    case LayerKind::relu:
      return 19;
    case LayerKind::reshape:
      return 22;
    case LayerKind::resize_bilinear:
      return 23;
  }
  return -1;
}

class NetWriter {
 public:
  NetWriter(const NetPlan& plan, bool halves) : plan_(plan), halves_(halves) {
    buffers_.push_back(table_of({}));  // the first one is empty
    for (const NetTensor& t : plan.tensors) take(t);
    for (const NetLayer& l : plan.layers) take(l);
  }

  Bytes write() const {
    std::vector<std::uint32_t> outputs(plan_.outputs.begin(), plan_.outputs.end());
    const Write graph = table_of({{0, 0, tables_of(tensors_)},
                                  {1, 0, list_of<std::uint32_t>({static_cast<std::uint32_t>(plan_.input)})},
                                  {2, 0, list_of(outputs)},
                                  {3, 0, tables_of(layers_)}});
    Bytes out = {0, 0, 0, 0, 'T', 'F', 'L', '3'};
    patch(out, 0, 8);
    table_of({{0, 3}, {1, 0, tables_of(codes_)}, {2, 0, tables_of({graph})}, {4, 0, tables_of(buffers_)}})(
        out);
    return out;
  }

 private:
  std::uint32_t buffer(const Write& data) {
    buffers_.push_back(table_of({{0, 0, data}}));
    return static_cast<std::uint32_t>(buffers_.size() - 1);
  }
  template <typename Number>
  std::uint32_t buffer_of(const std::vector<Number>& numbers) {
    Bytes bytes;
    for (const Number x : numbers) put(bytes, x);
    return buffer(list_of(bytes));
  }
  std::uint32_t tensor(const Write& shape, std::uint32_t type, std::uint32_t buffer_number) {
    tensors_.push_back(table_of({{0, 0, shape}, {1, type}, {2, buffer_number}}));
    return static_cast<std::uint32_t>(tensors_.size() - 1);
  }
  void take(const NetTensor& t) {
    const Write shape = cast_list<std::uint32_t>(t.shape);
    const bool half = halves_ && !t.values.empty();
    tensor(shape, 0, t.values.empty() || half ? 0 : buffer_of(t.values));
    if (half) halved_.push_back(tensors_.size() - 1);
  }
  std::uint32_t code(std::int32_t number) {
    codes_.push_back(
        table_of({{0, static_cast<std::uint32_t>(number)}, {3, static_cast<std::uint32_t>(number)}}));
    return static_cast<std::uint32_t>(codes_.size() - 1);
  }
  void layer(std::int32_t kind, std::vector<std::uint32_t> in, std::uint32_t out,
             const std::vector<Field>& options) {
    layers_.push_back(table_of({{0, code(kind)},
                                {1, 0, list_of(in)},
                                {2, 0, list_of<std::uint32_t>({out})},
                                {4, 0, table_of(options)}}));
  }

  void take(const NetLayer& l) {
    if (!halved_.empty()) write_halves();
    std::vector<std::uint32_t> in(l.inputs.begin(), l.inputs.end());
    const auto integers = [&](const std::vector<std::int32_t>& numbers) {
      in.push_back(tensor(list_of<std::uint32_t>({static_cast<std::uint32_t>(numbers.size())}), 2,
                          buffer_of(numbers)));
    };
    if (l.kind == LayerKind::mean) integers({1, 2});
    if (l.kind == LayerKind::pad) {
      std::vector<std::int32_t> pads;
      for (std::size_t d = 0; d < 4; ++d) {
        pads.push_back(static_cast<std::int32_t>(l.before[d]));
        pads.push_back(static_cast<std::int32_t>(l.after[d]));
      }
      integers(pads);
    }
    layer(code_of(l.kind), in, static_cast<std::uint32_t>(l.output), options(l));
  }

  static std::vector<Field> options(const NetLayer& l) {
    const auto n = [](std::size_t x) { return static_cast<std::uint32_t>(x); };
    const std::uint32_t activation = l.activation == Activation::relu6  ? 3
                                     : l.activation == Activation::relu ? 1
                                                                        : 0;
    std::vector<Field> slid = {{0, l.same ? 0u : 1u}, {1, n(l.stride_x)}, {2, n(l.stride_y)}};
    switch (l.kind) {
      case LayerKind::convolution:
        slid.push_back({3, activation});
        return slid;
      case LayerKind::depthwise:
        slid.push_back({4, activation});
        return slid;
      case LayerKind::max_pool:
        slid.push_back({3, n(l.window_x)});
        slid.push_back({4, n(l.window_y)});
        return slid;
      case LayerKind::add:
      case LayerKind::fully_connected:
        return {{0, activation}};
      case LayerKind::concatenation:
        return {{0, 1}};
      case LayerKind::resize_bilinear:
        return {{3, 1}};
      default:
        return {};
    }
  }

  /// Writes constants as halves, each with the layer that makes floats of it.
  void write_halves() {
    for (const std::size_t t : halved_) {
      std::vector<std::uint16_t> halves;
      for (const float x : plan_.tensors[t].values) halves.push_back(to_half(x));
      const std::uint32_t half =
          tensor(cast_list<std::uint32_t>(plan_.tensors[t].shape), 1, buffer_of(halves));
      layer(6, {half}, static_cast<std::uint32_t>(t), {});
    }
    halved_.clear();
  }

  const NetPlan& plan_;
  bool halves_;
  std::vector<std::size_t> halved_;  // tensors whose halves are still to be written
  std::vector<Write> buffers_, tensors_, layers_, codes_;
};

}  // namespace

std::vector<std::uint8_t> write_net(const NetPlan& plan, bool halves) {
  return NetWriter(plan, halves).write();
}

}  // namespace prosector
