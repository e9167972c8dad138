#pragma once
// A tracker's receivers within its accurate range, the selected hemisphere of the transmitter, and the
// straight-ahead direction.

#include <memory>
#include <optional>
#include <string>

#include "client/setup/device_watch.h"
#include "client/setup/live_panel.h"
#include "drivers/device/field_map.h"

namespace prosector {

struct OrthographicView;

/// Class of a tracker's accuracy at a distance from its transmitter: as specified, less accurate, or out of
/// range.
enum class Trust : std::uint8_t { good, less, none };
/// Returns the accuracy class at a `distance` (m) from the transmitter of a FASTRAK tracker: good up to 0.76
/// m, less up to 3 m. Returns none beyond, or if `error`, the device's error character, is not a blank.
Trust trust_at(double distance, char error);

class TrackerRangePanel final : public LivePanel {
 public:
  const char* name() const override { return msg("Range and side"); }
  const char* about() const override {
    return "Where receivers are about the transmitter: green is as exact as promised, amber less so, red is "
           "out of range.";
  }
  void draw(Interface& ui, ConfigDraft& draft, Said& said, std::int64_t now_ns) override;
  void close() override { watch_.reset(); }
  bool open() const override { return watch_ != nullptr; }

 private:
  std::unique_ptr<DeviceWatch> watch_;
  std::optional<FieldMap> map_;
  bool knows_range_ = false;  // a FASTRAK, or a recording

  void begin(const ClientConfig& config);
  void change(ConfigDraft& draft, Said& said, const ConfigChange& what, const std::string& done);
  void draw_pictures(Interface& ui, const ClientConfig& config) const;
  void draw_range(const OrthographicView& space, const Vec3& hemisphere, float scale) const;
  void draw_dots(const OrthographicView& space, float scale) const;
  std::uint32_t shade_of(const DeviceSample& sample) const;
  void draw_receivers(Interface& ui, const ClientConfig& config) const;
  void draw_side(Interface& ui, ConfigDraft& draft, Said& said);
  void draw_ahead(Interface& ui, ConfigDraft& draft, Said& said);
};

}  // namespace prosector
