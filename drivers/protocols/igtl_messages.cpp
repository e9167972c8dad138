#include "drivers/protocols/igtl_messages.h"

#include <fmt/format.h>
#include <igtl_header.h>
#include <igtl_image.h>
#include <igtl_tdata.h>
#include <igtl_transform.h>
#include <igtl_util.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace prosector::igtl {
namespace {

constexpr std::uint16_t newest_version = 2;         // of headers; version 2 has a second header
constexpr std::uint64_t longest_body = 1u << 30;    // bytes: a volume, which is skipped
constexpr std::uint64_t max_buffered_body = 65536;  // bytes: hundreds of tools
constexpr std::uint64_t longest_image = 1u << 26;   // bytes: 4096 × 4096 pixels of 3 bytes
constexpr int most_side = 8192;                     // pixels
constexpr std::size_t extended_size = 12;           // bytes, of version 2's second header
constexpr double m_per_mm = 1e-3, mm_per_m = 1e3;
constexpr std::array<const char*, 5> kept_types = {transform_type, tools_type, start_tools_type,
                                                   stop_tools_type, started_tools_type};

template <std::size_t N>
std::string text_of(const char (&field)[N]) {
  return {field, ::strnlen(field, N)};
}
template <std::size_t N>
void put_text(char (&field)[N], const std::string& text) {
  std::fill(std::begin(field), std::end(field), '\0');
  text.copy(field, N);
}

bool is_type_name(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::uint64_t sum_of(std::span<const std::uint8_t> body) {
  Bytes copy(body.begin(), body.end());  // the library's function takes no const bytes
  return ::crc64(copy.data(), copy.size(), 0);
}

template <class Record>
void append(Bytes& out, const Record& record) {
  const std::size_t before = out.size();
  out.resize(before + sizeof(Record));
  std::memcpy(out.data() + before, &record, sizeof(Record));
}
template <class Record>
Record record_at(std::span<const std::uint8_t> bytes) {
  Record out;
  std::memcpy(&out, bytes.data(), sizeof(Record));
  return out;
}

using Matrix = std::array<igtl_float32, 12>;  // three columns of the rotation, then the position in mm

Matrix matrix_of(const Tool& tool) {
  Matrix out{};
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      out[static_cast<std::size_t>(3 * column + row)] = static_cast<float>(tool.turn(row, column));
  for (int row = 0; row < 3; ++row)
    out[static_cast<std::size_t>(9 + row)] = static_cast<float>(mm_per_m * tool.place[row]);
  return out;
}
Tool tool_of(std::string name, const Matrix& matrix) {
  Tool out;
  out.name = std::move(name);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      out.turn(row, column) = static_cast<double>(matrix[static_cast<std::size_t>(3 * column + row)]);
  for (int row = 0; row < 3; ++row)
    out.place[row] = m_per_mm * static_cast<double>(matrix[static_cast<std::size_t>(9 + row)]);
  return out;
}

/// Scales 16-bit numbers linearly, so that the minimum becomes 0 and the maximum 255.
Bytes stretched(std::span<const std::uint8_t> words, bool has_sign, bool big_first) {
  std::vector<int> numbers;
  numbers.reserve(words.size() / 2);
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
    const int high = words[big_first ? i : i + 1], low = words[big_first ? i + 1 : i];
    const int number = high << 8 | low;
    numbers.push_back(has_sign && number >= 1 << 15 ? number - (1 << 16) : number);
  }
  const auto [least, most] = std::ranges::minmax(numbers);
  Bytes out;
  for (const int number : numbers)
    out.push_back(static_cast<std::uint8_t>(255 * (number - least) / std::max(1, most - least)));
  return out;
}

/// Returns the content of a version 2 body, between its second header and its metadata. Returns nothing if
/// the lengths are inconsistent.
std::optional<std::span<const std::uint8_t>> content_of(std::span<const std::uint8_t> body) {
  if (body.size() < extended_size) return std::nullopt;
  const auto number = [&](std::size_t at, std::size_t width) {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < width; ++i) out = out << 8 | body[at + i];
    return out;
  };
  const std::uint64_t front = number(0, 2), back = number(2, 2) + number(4, 4);
  if (front < extended_size || front + back > body.size()) return std::nullopt;
  return body.subspan(front, body.size() - front - back);
}

}  // namespace

void put(Bytes& out, const Message& message, std::uint16_t version) {
  igtl_header header{};
  header.version = version;
  put_text(header.name, message.type);
  put_text(header.device_name, message.device);
  const auto seconds = static_cast<std::uint64_t>(message.time_ns / 1'000'000'000);
  const auto rest = static_cast<std::uint64_t>(message.time_ns % 1'000'000'000);
  header.timestamp = seconds << 32 | (rest << 32) / 1'000'000'000;
  header.body_size = message.body.size();
  header.crc = sum_of(message.body);
  ::igtl_header_convert_byte_order(&header);
  append(out, header);
  out.insert(out.end(), message.body.begin(), message.body.end());
}

Bytes transform_body(const Tool& tool) {
  Matrix matrix = matrix_of(tool);
  ::igtl_transform_convert_byte_order(matrix.data());
  Bytes out;
  append(out, matrix);
  return out;
}

std::optional<Tool> transform_of(const Message& message) {
  if (message.body.size() != IGTL_TRANSFORM_SIZE) return std::nullopt;
  Matrix matrix = record_at<Matrix>(message.body);
  ::igtl_transform_convert_byte_order(matrix.data());
  return tool_of(message.device, matrix);
}

Bytes tools_body(const std::vector<Tool>& tools) {
  Bytes out;
  for (const Tool& tool : tools) {
    igtl_tdata_element element{};
    put_text(element.name, tool.name);
    element.type = IGTL_TDATA_TYPE_6D;
    const Matrix matrix = matrix_of(tool);
    std::ranges::copy(matrix, std::begin(element.transform));
    ::igtl_tdata_convert_byte_order(&element, 1);
    append(out, element);
  }
  return out;
}

std::optional<std::vector<Tool>> tools_of(const Message& message) {
  if (message.body.size() % IGTL_TDATA_ELEMENT_SIZE != 0) return std::nullopt;
  std::vector<Tool> out;
  for (std::span<const std::uint8_t> rest(message.body); !rest.empty();
       rest = rest.subspan(IGTL_TDATA_ELEMENT_SIZE)) {
    auto element = record_at<igtl_tdata_element>(rest);
    ::igtl_tdata_convert_byte_order(&element, 1);
    Matrix matrix;
    std::copy(std::begin(element.transform), std::end(element.transform), matrix.begin());
    out.push_back(tool_of(text_of(element.name), matrix));
  }
  return out;
}

Bytes start_body(std::int32_t interval_ms) {
  igtl_stt_tdata start{};
  start.resolution = interval_ms;
  ::igtl_stt_tdata_convert_byte_order(&start);
  Bytes out;
  append(out, start);
  return out;
}

std::optional<std::int32_t> interval_of(const Message& message) {
  if (message.body.size() != IGTL_STT_TDATA_SIZE) return std::nullopt;
  auto start = record_at<igtl_stt_tdata>(message.body);
  ::igtl_stt_tdata_convert_byte_order(&start);
  return start.resolution;
}

Bytes started_body() {
  return {0};
}

Bytes image_body(const Image& image) {
  igtl_image_header header{};
  header.version = 1;
  header.num_components = 3;
  header.scalar_type = IGTL_IMAGE_STYPE_TYPE_UINT8;
  header.endian = IGTL_IMAGE_ENDIAN_LITTLE;
  header.coord = IGTL_IMAGE_COORD_RAS;
  const std::array<int, 3> size = {image.width, image.height, 1};
  for (std::size_t i = 0; i < size.size(); ++i) {
    header.size[i] = header.subvol_size[i] = static_cast<igtl_uint16>(size[i]);
    header.matrix[4 * i] = 1;  // mm per pixel, along its own axis
  }
  ::igtl_image_convert_byte_order(&header);
  Bytes out;
  out.reserve(sizeof(header) + image.rgb.size());
  append(out, header);
  out.insert(out.end(), image.rgb.begin(), image.rgb.end());
  return out;
}

std::optional<Image> image_of(const Message& message) {
  if (message.body.size() < IGTL_IMAGE_HEADER_SIZE) return std::nullopt;
  auto header = record_at<igtl_image_header>(message.body);
  ::igtl_image_convert_byte_order(&header);
  const int width = header.size[0], height = header.size[1];
  for (std::size_t i = 0; i < 3; ++i)
    if (header.subvol_offset[i] != 0 || header.subvol_size[i] != header.size[i]) return std::nullopt;
  if (width < 1 || height < 1 || width > most_side || height > most_side || header.size[2] != 1)
    return std::nullopt;
  const bool is_bytes = header.scalar_type == IGTL_IMAGE_STYPE_TYPE_UINT8;
  const bool is_words =
      header.scalar_type == IGTL_IMAGE_STYPE_TYPE_INT16 || header.scalar_type == IGTL_IMAGE_STYPE_TYPE_UINT16;
  const std::size_t colours = header.num_components;
  if (!(is_bytes && (colours == 1 || colours == 3)) && !(is_words && colours == 1)) return std::nullopt;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const auto data = std::span(message.body).subspan(IGTL_IMAGE_HEADER_SIZE);
  if (data.size() != pixels * colours * (is_bytes ? 1 : 2)) return std::nullopt;
  Image out{width, height, {}};
  if (colours == 3) {
    out.rgb.assign(data.begin(), data.end());
    return out;
  }
  const Bytes grey = is_bytes ? Bytes(data.begin(), data.end())
                              : stretched(data, header.scalar_type == IGTL_IMAGE_STYPE_TYPE_INT16,
                                          header.endian == IGTL_IMAGE_ENDIAN_BIG);
  out.rgb.reserve(3 * pixels);
  for (const std::uint8_t byte : grey) out.rgb.insert(out.rgb.end(), 3, byte);
  return out;
}

bool Reader::keeps(const std::string& type, std::uint64_t size) const {
  if (type == image_type) return keeps_images_ && size <= longest_image;
  return std::ranges::find(kept_types, type) != kept_types.end() && size <= max_buffered_body;
}

void Reader::take(std::span<const std::uint8_t> bytes, std::int64_t time_ns) {
  if (!problem_.empty()) return;
  const std::size_t passed = static_cast<std::size_t>(std::min<std::uint64_t>(bytes_to_skip_, bytes.size()));
  bytes_to_skip_ -= passed;
  waiting_.append(bytes.subspan(passed), time_ns);
}

std::optional<Message> Reader::next() {
  while (problem_.empty() && bytes_to_skip_ == 0 && waiting_.bytes().size() >= IGTL_HEADER_SIZE) {
    const auto bytes = waiting_.bytes();
    auto header = record_at<igtl_header>(bytes);
    ::igtl_header_convert_byte_order(&header);
    Message out{text_of(header.name), text_of(header.device_name), {}, waiting_.time_ns()};
    const std::uint64_t size = header.body_size;
    if (header.version < 1 || header.version > newest_version) {
      problem_ = fmt::format("received an OpenIGTLink header of version {}; supported versions: 1 to {}",
                             header.version, newest_version);
    } else if (!is_type_name(out.type) || size > longest_body) {
      problem_ = "received data is not OpenIGTLink, or is damaged";
    } else if (!keeps(out.type, size)) {
      const std::uint64_t all = IGTL_HEADER_SIZE + size;
      const std::size_t here = static_cast<std::size_t>(std::min<std::uint64_t>(all, bytes.size()));
      waiting_.drop(here);
      bytes_to_skip_ = all - here;
    } else {
      if (bytes.size() < IGTL_HEADER_SIZE + size) return std::nullopt;
      const auto body = bytes.subspan(IGTL_HEADER_SIZE, static_cast<std::size_t>(size));
      const bool right = sum_of(body) == header.crc;
      const auto content = header.version == 1 ? std::optional(body) : content_of(body);
      if (right && content) out.body.assign(content->begin(), content->end());
      waiting_.drop(IGTL_HEADER_SIZE + body.size());
      if (right && content) return out;
      bad_bytes_ += IGTL_HEADER_SIZE + static_cast<std::size_t>(size);
    }
  }
  return std::nullopt;
}

std::size_t Reader::consume_bad_byte_count() {
  return std::exchange(bad_bytes_, 0);
}

}  // namespace prosector::igtl
