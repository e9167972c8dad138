#include "server/session/input_bytes.h"

#include <bit>
#include <cstring>

#include "common/error.h"

namespace prosector {
namespace {

static_assert(std::endian::native == std::endian::little, "journals are little endian");

template <class T>
void put(std::vector<std::uint8_t>& out, const T& value) {
  const std::size_t at = out.size();
  out.resize(at + sizeof(T));
  std::memcpy(out.data() + at, &value, sizeof(T));
}

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  template <class T>
  T get() {
    if (bytes_.size() < sizeof(T)) throw InputError("journal: a tick's input is truncated");
    T value;
    std::memcpy(&value, bytes_.data(), sizeof(T));
    bytes_ = bytes_.subspan(sizeof(T));
    return value;
  }
  std::uint32_t count() {
    const auto n = get<std::uint32_t>();
    if (n > bytes_.size()) throw InputError("journal: a tick's input is truncated");
    return n;
  }
  std::shared_ptr<const std::vector<std::uint8_t>> block() {
    const std::uint32_t size = count();
    const auto bytes = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end());
  }
  void end() const {
    if (!bytes_.empty()) throw InputError("journal: a tick's input is too long");
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

std::size_t get_hand(Reader& in) {
  const auto hand = in.get<std::uint8_t>();
  if (hand > right_hand) throw InputError("journal: no such hand");
  return hand;
}

}  // namespace

std::vector<std::uint8_t> encode_input(const ConsumedInput& input) {
  std::vector<std::uint8_t> out;
  if (input.keys.empty() && input.input.efforts.empty() && input.input.events.empty() &&
      input.input.parts.empty() && input.input.targets.empty() && input.input.panels.empty() &&
      input.input.heads.empty() && input.input.cuts.empty())
    return out;
  out.reserve(16 + 5 * input.input.efforts.size() + 16 * input.keys.size() + 16 * input.input.events.size() +
              120 * input.input.parts.size() + 112 * input.input.targets.size());
  put(out, static_cast<std::uint32_t>(input.keys.size()));
  for (const InputKey& key : input.keys) {
    put(out, key.participant);
    put(out, key.sequence);
  }
  put(out, static_cast<std::uint32_t>(input.input.efforts.size()));
  for (const EffortChange& change : input.input.efforts) {
    put(out, change.body);
    put(out, static_cast<std::uint8_t>(change.steps_down));
  }
  put(out, static_cast<std::uint32_t>(input.input.events.size()));
  for (const HandEvent& e : input.input.events) {
    put(out, e.kind);
    put(out, e.participant);
    put(out, static_cast<std::uint8_t>(e.hand));
    put(out, e.body);
  }
  put(out, static_cast<std::uint32_t>(input.input.parts.size()));
  for (const PartEvent& e : input.input.parts) {
    put(out, e.kind);
    put(out, e.participant);
    put(out, e.body);
    for (int k = 0; k < 9; ++k) put(out, e.shape.A(k / 3, k % 3));
    for (int k = 0; k < 3; ++k) put(out, e.shape.p[k]);
    put(out, e.value);
  }
  put(out, static_cast<std::uint32_t>(input.input.targets.size()));
  for (const HandTarget& t : input.input.targets) {
    put(out, t.participant);
    put(out, static_cast<std::uint8_t>(t.hand));
    for (int k = 0; k < 3; ++k) put(out, t.target.p[k]);
    for (int k = 0; k < 4; ++k) put(out, t.target.q.coeffs()[k]);
    for (double f : t.flexion) put(out, f);
  }
  put(out, static_cast<std::uint32_t>(input.input.heads.size()));
  for (const HeadPlace& head : input.input.heads) {
    put(out, head.participant);
    for (int k = 0; k < 3; ++k) put(out, head.at[k]);
  }
  put(out, static_cast<std::uint32_t>(input.input.panels.size()));
  for (const PanelEvent& e : input.input.panels) {
    put(out, e.kind);
    put(out, e.participant);
    put(out, e.body);
    put(out, e.control);
    put(out, e.value);
  }
  put(out, static_cast<std::uint32_t>(input.input.cuts.size()));
  for (const CutEvent& e : input.input.cuts) {
    put(out, e.kind);
    put(out, e.participant);
    put(out, e.body);
    put(out, e.revision);
    if (e.kind != CutEvent::Kind::rewind) continue;
    const std::size_t size = e.state ? e.state->size() : 0;
    put(out, static_cast<std::uint32_t>(size));
    if (size > 0) out.insert(out.end(), e.state->begin(), e.state->end());
  }
  return out;
}

ConsumedInput decode_input(std::span<const std::uint8_t> bytes) {
  ConsumedInput out;
  if (bytes.empty()) return out;
  Reader in(bytes);
  out.keys.resize(in.count());
  for (InputKey& key : out.keys) {
    key.participant = in.get<ParticipantId>();
    key.sequence = in.get<std::uint64_t>();
  }
  out.input.efforts.resize(in.count());
  for (EffortChange& change : out.input.efforts) {
    change.body = in.get<BodyId>();
    change.steps_down = in.get<std::uint8_t>();
    if (change.steps_down > static_cast<int>(max_steps_down))
      throw InputError("journal: stepped down too far");
  }
  out.input.events.resize(in.count());
  for (HandEvent& e : out.input.events) {
    e.kind = in.get<HandEvent::Kind>();
    if (e.kind > HandEvent::Kind::reset_body) throw InputError("journal: no such event");
    e.participant = in.get<ParticipantId>();
    e.hand = get_hand(in);
    e.body = in.get<BodyId>();
  }
  out.input.parts.resize(in.count());
  for (PartEvent& e : out.input.parts) {
    e.kind = in.get<PartEvent::Kind>();
    if (e.kind > last_part_event) throw InputError("journal: no such event of a part");
    e.participant = in.get<ParticipantId>();
    e.body = in.get<BodyId>();
    for (int k = 0; k < 9; ++k) e.shape.A(k / 3, k % 3) = in.get<double>();
    for (int k = 0; k < 3; ++k) e.shape.p[k] = in.get<double>();
    e.value = in.get<double>();
  }
  out.input.targets.resize(in.count());
  for (HandTarget& t : out.input.targets) {
    t.participant = in.get<ParticipantId>();
    t.hand = get_hand(in);
    for (int k = 0; k < 3; ++k) t.target.p[k] = in.get<double>();
    for (int k = 0; k < 4; ++k) t.target.q.coeffs()[k] = in.get<double>();
    for (double& f : t.flexion) f = in.get<double>();
    if (!is_finite(t.target)) throw InputError("journal: a pose is not finite");
  }
  out.input.heads.resize(in.count());
  for (HeadPlace& head : out.input.heads) {
    head.participant = in.get<ParticipantId>();
    for (int k = 0; k < 3; ++k) head.at[k] = in.get<double>();
  }
  out.input.panels.resize(in.count());
  for (PanelEvent& e : out.input.panels) {
    e.kind = in.get<PanelEvent::Kind>();
    if (e.kind > last_panel_event) throw InputError("journal: no such event of a panel");
    e.participant = in.get<ParticipantId>();
    e.body = in.get<BodyId>();
    e.control = in.get<PanelControl>();
    e.value = in.get<double>();
  }
  out.input.cuts.resize(in.count());
  for (CutEvent& e : out.input.cuts) {
    e.kind = in.get<CutEvent::Kind>();
    if (e.kind > last_cut_event) throw InputError("journal: no such event of a cut");
    e.participant = in.get<ParticipantId>();
    e.body = in.get<BodyId>();
    e.revision = in.get<std::uint32_t>();
    if (e.kind == CutEvent::Kind::rewind) e.state = in.block();
  }
  in.end();
  return out;
}

}  // namespace prosector
