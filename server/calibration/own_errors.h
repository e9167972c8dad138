#pragma once
// Errors of models and elements on one body. Trials on the body's own meshes (body_trial.h) give them where
// they are affordable; at other cell sizes they are inferred. Trials are cached from run to run, by the mesh
// and its material.
//
// A trial's reference is small, so that many candidates can be tried. The final choice is verified ("proved")
// with a reference that may be four times as large, so that finer meshes get a divided reference, too. The
// verification adds a fifth to the body's weight, to detect a body that is about to fold or collapse.

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/scene/scene.h"
#include "server/accuracy/body_trial.h"

namespace prosector {

/// A body whose errors are found by trials on its own meshes, and the settings of these trials.
struct JudgedBody {
  SoftDesc desc;
  Vec3 gravity;                              // m/s²
  std::function<Anatomy(double cell)> mesh;  // world frame; throws InputError where a cell is too coarse
  std::filesystem::path cache_dir;           // where trials are cached; empty: not cached
  std::function<void(const std::string&)> say;
  bool prove = false;                                 // verify by new trials; false: only by cached ones
  std::size_t most_tets = TrialSettings{}.most_tets;  // limit of tetrahedra of a trial's reference
  std::size_t most_tets_proving = 24000;              // limit of tetrahedra of a verification's reference
  std::function<void()> before_step = {};             // as in TrialSettings
};

class OwnErrors {
 public:
  explicit OwnErrors(JudgedBody body);

  /// Returns the errors of that model and element on the body with cells of `cell` m, one for each test load
  /// that the description counts. Errors are 1.5 times those of trials, to cover loads that were not tried.
  /// Between trials they are interpolated in double logarithms. At finer cells they follow the rate of the
  /// last two trials, or first order after a single one, with a quarter added. Empty if there was no trial of
  /// that model and element.
  std::vector<ActError> at(const std::string& model, const std::string& element, double cell) const;
  /// Measures the errors of the model and element on the body with cells of `cell` m, with which it has
  /// `elements` elements. If that is too expensive, measures them with the finest affordable cells and with
  /// cells 1.5 times as large. Returns whether any new error was measured.
  bool attempt(const std::string& model, const std::string& element, double cell, double elements);
  /// Verifies the errors of the model and element by repeating attempt() with a larger reference mesh, where
  /// that is more accurate. Returns whether anything new was found.
  bool prove(const std::string& model, const std::string& element, double cell, double elements);

 private:
  using Way = std::pair<std::string, std::string>;  // model, element
  struct Found {
    std::vector<ActError> acts;
    bool divided = false;  // the reference was divided: its error is included
    bool proved = false;   // verified, or too fine to be
  };
  using Tried = std::map<double, Found>;  // by cell size, m

  bool proving() const { return settings_.most_tets == body_.most_tets_proving; }
  bool attempt(const Way& way, double cell, double elements);
  bool measure(const Way& way, double cell);
  bool judge(const Way& way, double cell);
  std::map<double, double> errors_of(const Way& way, const std::string& act) const;
  const BodyTrial& trial_on(const Anatomy& mesh, double cell);
  std::optional<std::vector<ActError>> found(const Way& way, const Anatomy& mesh, double cell);
  std::filesystem::path cache_file(const Way& way, const Anatomy& mesh) const;

  JudgedBody body_;
  TrialSettings settings_;
  std::map<Way, Tried> tried_;
  std::map<double, BodyTrial> trials_;                 // by cell size
  std::optional<std::pair<double, BodyTrial>> proof_;  // only the last one is stored: they are large
};

}  // namespace prosector
