#include "server/session/journal/input_bytes.h"

#include <tuple>

#include "common/byte_stream.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::uint8_t said_of_hand = 2, arm_of_hand = 4;  // flags in the byte of a hand index
constexpr const char* no_such_hand = "no such hand";

// Each kind of input is described once, for writing and for reading: an Io processes the members of an entry
// in the order of their bytes. Structured bindings name all members, so that a new member doesn't compile
// until it is added here.

class Writer {
 public:
  template <class T>
  using Entry = const T;

  template <class T>
  void number(const T& value) {
    bytes_.add(value);
  }
  template <class T>
  void numbers(const T* values, int count) {
    for (int k = 0; k < count; ++k) bytes_.add(values[k]);
  }
  /// Adds a value as `Wire`. The reader checks that it is at most `last`.
  template <class Wire, class T>
  void limited(const T& value, Wire, const char*) {
    bytes_.add(static_cast<Wire>(value));
  }
  /// Adds the index of a hand, a flag, and whether there is a number, as one byte.
  void hand(const std::size_t& hand, const bool& said, const std::optional<double>& number) {
    bytes_.add(static_cast<std::uint8_t>(hand | (said ? said_of_hand : 0) | (number ? arm_of_hand : 0)));
  }
  void require(bool, const char*) {}
  void block(const std::shared_ptr<const std::vector<std::uint8_t>>& block) {
    const std::size_t size = block ? block->size() : 0;
    bytes_.add(static_cast<std::uint32_t>(size));
    if (size > 0) bytes_.raw(block->data(), size);
  }
  template <class T>
  void count(const std::vector<T>& entries) {
    bytes_.add(static_cast<std::uint32_t>(entries.size()));
  }
  std::vector<std::uint8_t> take() { return bytes_.take(); }

 private:
  ByteWriter bytes_;
};

class Reader {
 public:
  template <class T>
  using Entry = T;

  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes, "journal: a tick's input") {}

  template <class T>
  void number(T& value) {
    value = bytes_.bits<T>();
  }
  template <class T>
  void numbers(T* values, int count) {
    for (int k = 0; k < count; ++k) values[k] = bytes_.bits<T>();
  }
  template <class Wire, class T>
  void limited(T& value, Wire last, const char* problem) {
    const auto read = bytes_.bits<Wire>();
    bytes_.require(read <= last, problem);
    value = static_cast<T>(read);
  }
  void hand(std::size_t& hand, bool& said, std::optional<double>& number) {
    const auto read = bytes_.bits<std::uint8_t>();
    said = (read & said_of_hand) != 0;
    if ((read & arm_of_hand) != 0) number = 0;
    hand = read & ~std::size_t{said_of_hand | arm_of_hand};
    bytes_.require(hand <= right_hand, no_such_hand);
  }
  void require(bool good, const char* problem) { bytes_.require(good, problem); }
  void block(std::shared_ptr<const std::vector<std::uint8_t>>& block) {
    const auto bytes = bytes_.block(bytes_.records(1));
    block = std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end());
  }
  template <class T>
  void count(std::vector<T>& entries) {
    entries.resize(bytes_.records(1));
  }
  void end() const { bytes_.end(); }

 private:
  ByteReader bytes_;
};

template <class Io>
void entry(Io& io, typename Io::template Entry<InputKey>& e) {
  auto& [participant, sequence] = e;
  io.number(participant);
  io.number(sequence);
}

template <class Io>
void entry(Io& io, typename Io::template Entry<EffortChange>& e) {
  auto& [body, steps_down] = e;
  io.number(body);
  io.limited(steps_down, std::uint8_t{max_steps_down},
             "the reduction of a body's solver effort is out of range");
}

template <class Io>
void entry(Io& io, typename Io::template Entry<HandEvent>& e) {
  auto& [kind, participant, hand, body] = e;
  io.limited(kind, HandEvent::Kind::regrasp, "no such event");
  io.number(participant);
  io.limited(hand, std::uint8_t{right_hand}, no_such_hand);
  io.number(body);
}

template <class Io>
void entry(Io& io, typename Io::template Entry<PartEvent>& e) {
  auto& [kind, participant, body, shape, value] = e;
  io.limited(kind, last_part_event, "unknown kind of event of an anatomical part");
  io.number(participant);
  io.number(body);
  for (int k = 0; k < 9; ++k) io.number(shape.A(k / 3, k % 3));
  io.numbers(shape.p.data(), 3);
  io.number(value);
}

template <class Io>
void entry(Io& io, typename Io::template Entry<HandTarget>& e) {
  auto& [participant, hand, target, flexion, draws, reaction] = e;
  io.number(participant);
  io.hand(hand, draws, reaction);
  io.numbers(target.p.data(), 3);
  io.numbers(target.q.coeffs().data(), 4);
  io.numbers(flexion.data(), fingers);
  if (reaction) io.number(*reaction);
  io.require(is_finite(target), "a pose is not finite");
  io.require(!reaction || *reaction >= 0,
             "the force of a haptic arm on a hand is negative or not a number; allowed: 0 N or more");
}

template <class Io>
void entry(Io& io, typename Io::template Entry<panel::HeadPlace>& e) {
  auto& [participant, at, ahead] = e;
  io.number(participant);
  io.numbers(at.data(), 3);
  io.numbers(ahead.data(), 3);
}

template <class Io>
void entry(Io& io, typename Io::template Entry<panel::PanelEvent>& e) {
  auto& [kind, participant, body, control, value, at] = e;
  io.limited(kind, panel::last_panel_event, "unknown kind of event of a panel");
  io.number(participant);
  io.number(body);
  io.limited(control, PanelControl::stiffness, "no such control");
  io.number(value);
  io.numbers(at.data(), 3);
}

template <class Io>
void entry(Io& io, typename Io::template Entry<panel::HeldPlace>& e) {
  auto& [participant, thing, seen, at] = e;
  io.number(participant);
  io.limited(thing, HeldObject::stylus, "nothing that is held");
  io.limited(seen, std::uint8_t{1}, "invalid visibility flag");
  io.numbers(at.p.data(), 3);
  io.numbers(at.q.coeffs().data(), 4);
  io.require(is_finite(at), "a pose is not finite");
}

template <class Io>
void entry(Io& io, typename Io::template Entry<CutEvent>& e) {
  auto& [kind, participant, body, revision, state] = e;
  io.limited(kind, last_cut_event, "unknown kind of event of a cut");
  io.number(participant);
  io.number(body);
  io.number(revision);
  if (kind == CutEvent::Kind::rewind) io.block(state);
}

template <class... Kind>
constexpr std::size_t size_of(const std::tuple<Kind&...>&) {
  return (sizeof(Kind) + ...);
}

/// Lists all kinds of input that a session's tick consumes, in the order of their bytes.
template <class Consumed>
auto kinds(Consumed& consumed) {
  auto& [input, keys] = consumed;
  auto& [efforts, events, targets, heads, panels, held, parts, cuts, kinematic_targets] = input;
  if (!kinematic_targets.empty())
    throw InternalError(
        "journal: inputs that drive bodies along a trajectory cannot be recorded; sessions do not use them");
  const auto all = std::tie(keys, efforts, events, parts, targets, heads, panels, held, cuts);
  static_assert(size_of(all) + sizeof kinematic_targets == sizeof consumed,
                "each kind of input of a tick must be in the list `all`, so that the journal records it");
  return all;
}

template <class Io, class Consumed>
void all_entries(Io& io, Consumed& consumed) {
  const auto entries = [&io](auto& of_a_kind) {
    io.count(of_a_kind);
    for (auto& e : of_a_kind) entry(io, e);
  };
  std::apply([&](auto&... kind) { (entries(kind), ...); }, kinds(consumed));
}

}  // namespace

std::vector<std::uint8_t> encode_input(const ConsumedInput& input) {
  if (std::apply([](const auto&... kind) { return (kind.empty() && ...); }, kinds(input))) return {};
  Writer out;
  all_entries(out, input);
  return out.take();
}

ConsumedInput decode_input(std::span<const std::uint8_t> bytes) {
  ConsumedInput out;
  if (bytes.empty()) return out;
  Reader in(bytes);
  all_entries(in, out);
  in.end();
  return out;
}

}  // namespace prosector
