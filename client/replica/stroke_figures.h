#pragma once
// Measures length and depth of a blade's strokes from the cut surfaces.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/replica/replica.h"

namespace prosector {

/// Length and depth of one stroke of a blade (successive cuts by one participant) in one organ, measured on
/// the rest shape.
struct StrokeFigures {
  BodyId organ = 0;  // the body before any piece came off
  ParticipantId author = 0;
  double length = 0;     // m, of the cut line on the outer surface
  double depth = 0;      // m, maximum distance of the cut faces' vertices from that line; 0 for a sheet
  bool through = false;  // a piece came off
};

/// Returns a text for display on a stroke's size, in the language of `words`: "63 mm long, 12 mm deep".
std::string in_words(const StrokeFigures& stroke, const Catalogue& words = {});
/// Returns a text for display on the cutting depth (m) to which a blade is set, in the language of `words`:
/// "set to 12 mm".
std::string depth_in_words(double depth, const Catalogue& words = {});

/// Tracker of all participants' current strokes (successive cuts of a blade in one organ), by comparing the
/// organs between calls.
class StrokeTracker {
 public:
  /// Updates the strokes by the cuts since the last call. Cuts of one organ by one participant less than
  /// stroke_seconds apart belong to one stroke. `now`: monotonic clock, s.
  void look(const Replica& replica, double now);
  /// Returns the participant's current stroke with a blade, the newest if there are several; null if there is
  /// none.
  const StrokeFigures* of(ParticipantId author) const;
  /// Returns and removes the strokes that ended since the last call, for lack of further cuts.
  std::vector<StrokeFigures> take_ended();

  static constexpr double stroke_seconds = 1;

 private:
  struct Body {
    std::uint32_t revision = 0;
    BodyId organ = 0;
    double rims = 0;           // m, total rest length of the rims on both sides of its cuts
    std::size_t vertices = 0;  // number of vertex slots
  };
  struct Stroke {
    StrokeFigures figures;
    double initial_rims = 0;                          // m, total length of the organ's rims
    std::map<BodyId, std::size_t> vertices_before{};  // number of vertex slots
    double last = 0;                                  // s, time of its latest cut
  };
  bool looked_ = false;  // cuts that exist at the first call belong to no stroke
  std::map<BodyId, Body> bodies_;
  std::vector<Stroke> strokes_;
  std::vector<StrokeFigures> ended_;

  void take(const Replica& replica, BodyId id, const TopologyRevision& newest, double now);
  Stroke& stroke_of(ParticipantId author, BodyId organ);
  double rims_of(BodyId organ) const;
};

}  // namespace prosector
