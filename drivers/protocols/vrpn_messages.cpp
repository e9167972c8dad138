#include "drivers/protocols/vrpn_messages.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace prosector::vrpn {
namespace {

constexpr std::string_view magic = "vrpn: ver. 07.35";  // 16 characters; the first 14, up to the dot after
                                                        // 07, must match
constexpr std::size_t must_fit = 14, cookie_bytes = 24, header_bytes = 24, block = 8;
constexpr std::size_t longest_message = 65536;  // bytes: far more than any message type used here
constexpr std::size_t most_names = 2000;

template <class Word>
void put_word(Bytes& out, Word word) {
  for (std::size_t i = sizeof(Word); i-- > 0;)
    out.push_back(static_cast<std::uint8_t>(word >> (8 * i) & 0xff));
}
void put_int(Bytes& out, std::int32_t value) {
  put_word(out, static_cast<std::uint32_t>(value));
}
void put_double(Bytes& out, double value) {
  put_word(out, std::bit_cast<std::uint64_t>(value));
}
void put_float(Bytes& out, double value) {
  put_word(out, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

/// Decodes consecutive numbers. The caller ensures that enough bytes are available.
class Numbers {
 public:
  explicit Numbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::int32_t integer() { return static_cast<std::int32_t>(word<std::uint32_t>()); }
  double real() { return std::bit_cast<double>(word<std::uint64_t>()); }
  double single() { return static_cast<double>(std::bit_cast<float>(word<std::uint32_t>())); }

 private:
  std::span<const std::uint8_t> bytes_;
  template <class Word>
  Word word() {
    Word out = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i) out = static_cast<Word>(out << 8 | bytes_[i]);
    bytes_ = bytes_.subspan(sizeof(Word));
    return out;
  }
};

std::size_t padded(std::size_t size) {
  return (size + block - 1) / block * block;
}

}  // namespace

std::optional<Place> parse_device_location(const std::string& text) {
  const auto sign = text.find('@');
  if (sign == 0 || sign == std::string::npos) return std::nullopt;
  const auto at = parse_host_port(text.substr(sign + 1), default_port);
  if (!at) return std::nullopt;
  return Place{text.substr(0, sign), *at};
}

Bytes cookie() {
  Bytes out(cookie_bytes, 0);
  std::fill_n(out.begin(), magic.size() + 2, ' ');
  std::copy(magic.begin(), magic.end(), out.begin());
  out[magic.size() + 2] = '0';  // logging is off
  return out;
}

void put(Bytes& out, const Message& message) {
  put_int(out, static_cast<std::int32_t>(header_bytes + message.body.size()));
  put_int(out, static_cast<std::int32_t>(message.time_ns / 1'000'000'000));
  put_int(out, static_cast<std::int32_t>(message.time_ns % 1'000'000'000 / 1000));  // µs
  put_int(out, message.sender);
  put_int(out, message.type);
  put_int(out, 0);
  const std::size_t begin = out.size();
  out.insert(out.end(), message.body.begin(), message.body.end());
  out.resize(begin + padded(message.body.size()), 0);
}

Message naming(std::int32_t kind, std::int32_t number, const std::string& name) {
  Message out{number, kind, {}};
  put_int(out.body, static_cast<std::int32_t>(name.size() + 1));
  for (const char c : name) out.body.push_back(static_cast<std::uint8_t>(c));
  out.body.push_back(0);
  return out;
}

Bytes body_of(const TrackerPose& pose) {
  Bytes out;
  put_int(out, pose.sensor);
  put_int(out, 0);
  for (const double x : pose.place) put_double(out, x);
  for (const double x : pose.turn.coeffs()) put_double(out, x);  // x, y, z, w
  return out;
}

std::optional<TrackerPose> tracker_pose_of(const Bytes& body) {
  if (body.size() != 64) return std::nullopt;
  Numbers in(body);
  TrackerPose out;
  out.sensor = in.integer();
  in.integer();
  for (double& x : out.place) x = in.real();
  for (double& x : out.turn.coeffs()) x = in.real();
  return out;
}

Bytes body_of(const Button& button) {
  Bytes out;
  put_int(out, button.number);
  put_int(out, button.pressed ? 1 : 0);
  return out;
}

std::optional<Button> button_of(const Bytes& body) {
  if (body.size() != 8) return std::nullopt;
  Numbers in(body);
  Button out;
  out.number = in.integer();
  out.pressed = in.integer() != 0;
  return out;
}

Bytes body_of(const Channels& channels) {
  Bytes out;
  put_double(out, static_cast<double>(channels.size()));
  for (const double x : channels) put_double(out, x);
  return out;
}

std::optional<Channels> channels_of(const Bytes& body) {
  if (body.size() < 8 || body.size() % 8 != 0) return std::nullopt;
  Numbers in(body);
  if (in.real() != static_cast<double>(body.size() / 8 - 1)) return std::nullopt;
  Channels out(body.size() / 8 - 1);
  for (double& x : out) x = in.real();
  return out;
}

Bytes body_of(const Dial& dial) {
  Bytes out;
  put_double(out, dial.turned);
  put_int(out, dial.number);
  return out;
}

std::optional<Dial> dial_of(const Bytes& body) {
  if (body.size() != 12) return std::nullopt;
  Numbers in(body);
  Dial out;
  out.turned = in.real();
  out.number = in.integer();
  return out;
}

Bytes body_of(const ForceField& field) {
  Bytes out;
  for (const double x : field.origin) put_float(out, x);
  for (const double x : field.force) put_float(out, x);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) put_float(out, field.jacobian(i, j));
  put_float(out, field.radius);
  return out;
}

std::optional<ForceField> field_of(const Bytes& body) {
  if (body.size() != 64) return std::nullopt;
  Numbers in(body);
  ForceField out;
  for (double& x : out.origin) x = in.single();
  for (double& x : out.force) x = in.single();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.jacobian(i, j) = in.single();
  out.radius = in.single();
  return out;
}

Bytes body_of(std::int32_t code) {
  Bytes out;
  put_int(out, code);
  return out;
}

std::optional<std::int32_t> code_of(const Bytes& body) {
  if (body.size() != 4) return std::nullopt;
  return Numbers(body).integer();
}

void Reader::take(std::span<const std::uint8_t> bytes, std::int64_t time_ns) {
  if (!broken_) waiting_.append(bytes, time_ns);
}

std::optional<Message> Reader::next() {
  if (broken_) return std::nullopt;
  if (!greeted_) {
    const auto known = waiting_.bytes().first(std::min(waiting_.bytes().size(), must_fit));
    broken_ = !std::equal(known.begin(), known.end(), magic.begin());
    if (broken_ || waiting_.bytes().size() < cookie_bytes) return std::nullopt;
    waiting_.drop(cookie_bytes);
    greeted_ = true;
  }
  const auto bytes = waiting_.bytes();
  if (bytes.size() < header_bytes) return std::nullopt;
  Numbers header(bytes);
  const std::int32_t length = header.integer();
  if (length < static_cast<std::int32_t>(header_bytes) ||
      length > static_cast<std::int32_t>(longest_message)) {
    broken_ = true;
    return std::nullopt;
  }
  const std::size_t size = static_cast<std::size_t>(length) - header_bytes;
  if (bytes.size() < header_bytes + padded(size)) return std::nullopt;
  header.integer();
  header.integer();
  Message out;
  out.sender = header.integer();
  out.type = header.integer();
  out.time_ns = waiting_.time_ns();
  const auto body = bytes.subspan(header_bytes, size);
  out.body.assign(body.begin(), body.end());
  waiting_.drop(header_bytes + padded(size));
  learn(out);
  return out;
}

/// Stores a name that the peer announced.
void Reader::learn(const Message& message) {
  if (message.type != names_sender && message.type != names_type) return;
  Names& names = message.type == names_sender ? senders_ : types_;
  if (message.body.size() < 5 || names.size() >= most_names) return;
  names[message.sender] = std::string(message.body.begin() + 4, message.body.end() - 1);
}

const std::string& Reader::name(const Names& names, std::int32_t number) {
  static const std::string none;
  const auto found = names.find(number);
  return found == names.end() ? none : found->second;
}

}  // namespace prosector::vrpn
