#pragma once
// OpenIGTLink's messages on a TCP line: a header with a checksum, then a body. Layouts, byte order and
// checksum are those of Debian's libopenigtlink.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/image.h"
#include "common/math.h"
#include "drivers/stamped_buffer.h"

namespace prosector::igtl {

using Bytes = std::vector<std::uint8_t>;

inline constexpr const char* usual_port = "18944";
inline constexpr const char* transform_type = "TRANSFORM";
inline constexpr const char* tools_type = "TDATA";
inline constexpr const char* start_tools_type = "STT_TDATA";  // asks for TDATA
inline constexpr const char* stop_tools_type = "STP_TDATA";
inline constexpr const char* started_tools_type = "RTS_TDATA";  // answers it
inline constexpr const char* image_type = "IMAGE";
inline constexpr std::size_t longest_name = 20;  // bytes, of a device or a tool

struct Message {
  std::string type, device;
  Bytes body;
  std::int64_t time_ns = 0;  // of one that came: when its first byte was read; else since the epoch, or 0
};

/// Appends a message, of header version 1 unless told otherwise.
void put(Bytes& out, const Message& message, std::uint16_t version = 1);

/// A tool as it was told: m, its server's frame; turn is what came, not always a rotation.
struct Tool {
  std::string name;
  Vec3 place = Vec3::Zero();
  Mat3 turn = Mat3::Identity();
};
/// Makes the body of a TRANSFORM, whose name is in its header.
Bytes transform_body(const Tool& tool);
std::optional<Tool> transform_of(const Message& message);
Bytes tools_body(const std::vector<Tool>& tools);
std::optional<std::vector<Tool>> tools_of(const Message& message);
/// Makes the body of STT_TDATA: at most one TDATA in so many ms, in the server's own frame.
Bytes start_body(std::int32_t interval_ms);
std::optional<std::int32_t> interval_of(const Message& message);
/// Makes the body of RTS_TDATA.
Bytes started_body();

/// Makes the body of an IMAGE: one slice of RGB, rows from the top, 1 mm a pixel.
Bytes image_body(const Image& image);
/// Reads an IMAGE that is one whole slice: bytes of one colour or three, or 16-bit numbers, which are
/// stretched from the least to the greatest. Returns nothing for others.
std::optional<Image> image_of(const Message& message);

/// Takes bytes as they come and finds the messages in them. Bodies that are large or of types that nobody
/// here reads are passed over without being kept; so are images, unless they are asked for.
class Reader {
 public:
  Reader() = default;
  explicit Reader(bool keeps_images) : keeps_images_(keeps_images) {}

  void take(std::span<const std::uint8_t> bytes, std::int64_t time_ns = 0);
  /// Returns the next message that is whole and whose checksum is right.
  std::optional<Message> next();
  /// Says why nothing can be read any more; empty: all is well.
  const std::string& problem() const { return problem_; }
  /// Returns the bytes of messages whose checksum was wrong, since the last call.
  std::size_t take_bad_bytes();

 private:
  bool keeps(const std::string& type, std::uint64_t size) const;

  bool keeps_images_ = false;
  StampedBuffer waiting_;
  std::uint64_t skip_ = 0;  // bytes of a body that is passed over
  std::size_t bad_bytes_ = 0;
  std::string problem_;
};

}  // namespace prosector::igtl
