#pragma once
// How long and how deep strokes of a blade are, from the surfaces that they made.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/replica/replica.h"

namespace prosector {

/// One stroke in one organ. Lengths are of the organ at rest.
struct StrokeFigures {
  BodyId organ = 0;  // what it was before any piece came off
  ParticipantId author = 0;
  double length = 0;     // m, of its line on the outside
  double depth = 0;      // m, to which its faces go from that line; 0: of a sheet
  bool through = false;  // a piece came off
};

/// Returns the figures for people: "63 mm long, 12 mm deep".
std::string in_words(const StrokeFigures& stroke, const Catalogue& words = {});
/// Returns how deep a blade is set to go, for people: "set to 12 mm".
std::string depth_in_words(double depth, const Catalogue& words = {});

/// Follows the strokes of everyone from look to look.
class StrokeGauge {
 public:
  /// Looks at what was cut since the last look. Cuts of one organ by one person less than stroke_seconds
  /// apart are one stroke. `now`: s of a clock that never goes back.
  void look(const Replica& replica, double now);
  /// Returns the stroke that the person is making; null: none.
  const StrokeFigures* of(ParticipantId author) const;
  /// Returns the strokes that ended since the last call.
  std::vector<StrokeFigures> take_ended();

  static constexpr double stroke_seconds = 1;

 private:
  struct Body {
    std::uint32_t revision = 0;
    BodyId organ = 0;
    double rims = 0;           // m, at rest, of both sides of its cuts
    std::size_t vertices = 0;  // slots
  };
  struct Stroke {
    StrokeFigures figures;
    double rims_before = 0;                           // m, of the organ
    std::map<BodyId, std::size_t> vertices_before{};  // slots
    double last = 0;                                  // s, when it went on
  };
  bool looked_ = false;  // what was there at the first look is nobody's stroke
  std::map<BodyId, Body> bodies_;
  std::vector<Stroke> strokes_;
  std::vector<StrokeFigures> ended_;

  void take(const Replica& replica, BodyId id, const TopologyRevision& newest, double now);
  Stroke& stroke_of(ParticipantId author, BodyId organ);
  double rims_of(BodyId organ) const;
};

}  // namespace prosector
