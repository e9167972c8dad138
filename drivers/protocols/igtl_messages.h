#pragma once
// OpenIGTLink messages on a TCP stream: a header with a checksum, then a body. Layouts, byte order and
// checksum are those of Debian's libopenigtlink.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/image.h"
#include "common/math.h"
#include "drivers/ports/timestamped_buffer.h"

namespace prosector::igtl {

using Bytes = std::vector<std::uint8_t>;

inline constexpr const char* default_port = "18944";
inline constexpr const char* transform_type = "TRANSFORM";
inline constexpr const char* tools_type = "TDATA";
inline constexpr const char* start_tools_type = "STT_TDATA";  // request for TDATA
inline constexpr const char* stop_tools_type = "STP_TDATA";
inline constexpr const char* started_tools_type = "RTS_TDATA";  // response to it
inline constexpr const char* image_type = "IMAGE";
inline constexpr std::size_t longest_name = 20;  // bytes, of a device or tool name

struct Message {
  std::string type, device;
  Bytes body;
  std::int64_t time_ns = 0;  // received: when its first byte was read; sent: time since the epoch, or 0
};

/// Appends the encoded OpenIGTLink message, header and body, to `out`. `version` is the protocol version in
/// the header.
void put(Bytes& out, const Message& message, std::uint16_t version = 1);

/// Name and pose of a tracked tool as an OpenIGTLink server reports it: m, the server's frame. The matrix
/// `turn` is not checked to be a rotation.
struct Tool {
  std::string name;
  Vec3 place = Vec3::Zero();
  Mat3 turn = Mat3::Identity();
};
/// Encodes the body of the OpenIGTLink message TRANSFORM, a tool's pose. The tool's name belongs to the
/// message header instead.
Bytes transform_body(const Tool& tool);
std::optional<Tool> transform_of(const Message& message);
Bytes tools_body(const std::vector<Tool>& tools);
std::optional<std::vector<Tool>> tools_of(const Message& message);
/// Encodes the body of the OpenIGTLink message STT_TDATA, which requests tool poses (TDATA): at most one
/// message per `interval_ms` ms, in the server's frame.
Bytes start_body(std::int32_t interval_ms);
std::optional<std::int32_t> interval_of(const Message& message);
/// Encodes the body of the OpenIGTLink message RTS_TDATA, with which a server confirms that it starts sending
/// tool poses.
Bytes started_body();

/// Encodes the body of the OpenIGTLink message IMAGE from a camera image: one RGB slice, rows from the top, 1
/// mm per pixel.
Bytes image_body(const Image& image);
/// Decodes an OpenIGTLink message IMAGE that is one whole slice. Its pixels are bytes with one or three
/// components, or 16-bit numbers whose range is stretched to 0 … 255. Returns nothing for other images.
std::optional<Image> image_of(const Message& message);

/// Parser of a byte stream into OpenIGTLink messages. Large bodies and unused message types are skipped
/// without buffering. Images are skipped, too, unless `keeps_images` is set.
class Reader {
 public:
  Reader() = default;
  explicit Reader(bool keeps_images) : keeps_images_(keeps_images) {}

  void take(std::span<const std::uint8_t> bytes, std::int64_t time_ns = 0);
  /// Returns the next complete OpenIGTLink message of the received bytes. Messages with a wrong checksum are
  /// skipped. Returns nothing if more bytes are needed.
  std::optional<Message> next();
  /// Returns the reason why the stream is not readable as OpenIGTLink; empty if there is no error.
  const std::string& problem() const { return problem_; }
  /// Returns the total size in bytes of messages with a wrong checksum since the last call, and resets this
  /// count.
  std::size_t consume_bad_byte_count();

 private:
  bool keeps(const std::string& type, std::uint64_t size) const;

  bool keeps_images_ = false;
  TimestampedBuffer waiting_;
  std::uint64_t bytes_to_skip_ = 0;  // bytes left of a skipped body
  std::size_t bad_bytes_ = 0;
  std::string problem_;
};

}  // namespace prosector::igtl
