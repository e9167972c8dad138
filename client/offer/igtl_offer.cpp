// OpenIGTLink server: each object is a TRANSFORM; after a request for TDATA all objects are sent as its
// tools. A camera image is an IMAGE.
#include <algorithm>

#include "client/offer/offer_protocol.h"
#include "drivers/protocols/igtl_messages.h"

namespace prosector {
namespace {

constexpr std::size_t most_tools = 500;
constexpr const char* own_device = "Prosector";
constexpr const char* own_picture = "Camera";

class IgtlTalk final : public OfferConnection {
 public:
  bool hear(std::span<const std::uint8_t> bytes) override {
    reader_.take(bytes);
    while (const auto message = reader_.next()) {
      if (message->type == igtl::start_tools_type) {
        const auto interval_ms = igtl::interval_of(*message);
        if (!interval_ms) return false;
        interval_ns_ = std::int64_t{1'000'000} * std::max(*interval_ms, 0);
        asked_ = tools_ = true;
      } else if (message->type == igtl::stop_tools_type) {
        tools_ = false;
      }
    }
    return reader_.problem().empty();
  }

  Bytes say(const std::vector<Offered>& things, std::int64_t now_ns) override {
    Bytes out;
    if (asked_) igtl::put(out, {igtl::started_tools_type, own_device, igtl::started_body(), now_ns});
    asked_ = false;
    std::vector<igtl::Tool> tools;
    for (const Offered& thing : things)
      if (tools.size() < most_tools)
        tools.push_back({thing.name, thing.pose.p, thing.pose.q.normalized().toRotationMatrix()});
    if (tools_) {
      if (now_ns - sent_ns_ < interval_ns_) return out;
      sent_ns_ = now_ns;
      if (!tools.empty()) igtl::put(out, {igtl::tools_type, own_device, igtl::tools_body(tools), now_ns});
    } else {
      for (const igtl::Tool& tool : tools)
        igtl::put(out, {igtl::transform_type, tool.name, igtl::transform_body(tool), now_ns});
    }
    return out;
  }

  Bytes show(const Image& image, std::int64_t now_ns) override {
    Bytes out;
    igtl::put(out, {igtl::image_type, own_picture, igtl::image_body(image), now_ns});
    return out;
  }

 private:
  igtl::Reader reader_;
  bool asked_ = false, tools_ = false;
  std::int64_t interval_ns_ = 0, sent_ns_ = 0;
};

}  // namespace

std::unique_ptr<OfferConnection> make_igtl_connection() {
  return std::make_unique<IgtlTalk>();
}

}  // namespace prosector
