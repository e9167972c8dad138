#pragma once
// How wrong ways of modelling are on one body: found by trials on its own meshes (body_trial.h) where these
// are affordable, inferred at other cells. Found ones are kept from run to run, by the mesh and what it is
// made of.
//
// A trial's reference is small, so that many ways can be tried. What is chosen in the end is proved by one
// that may be four times as large, so that it is divided on finer meshes, too. It is under a fifth more
// weight. So what is about to fold or to collapse is told.

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

/// The body that is judged.
struct JudgedBody {
  SoftDesc desc;
  Vec3 gravity;                              // m/s²
  std::function<Anatomy(double cell)> mesh;  // world frame; throws InputError where a cell is too coarse
  std::filesystem::path cache_dir;           // where trials are kept; empty: not
  std::function<void(const std::string&)> say;
  bool prove = false;                                 // by new trials; false: only by those that are kept
  std::size_t most_tets = TrialSettings{}.most_tets;  // of a trial's reference
  std::size_t most_tets_proving = 24000;              // of a proof's
  std::function<void()> before_step = {};             // as in TrialSettings
};

class OwnErrors {
 public:
  explicit OwnErrors(JudgedBody body);

  /// Returns what model and element get wrong in cells of that size (m), act by act, of those that the
  /// description asks for. It is half as much again as trials told, for acts that none tried. Inferred where
  /// no trial was: between trials in double logarithms; finer by the rate of the last two, with a quarter
  /// added, or at first order after one. Nothing where there was no trial.
  std::vector<ActError> at(const std::string& model, const std::string& element, double cell) const;
  /// Tries model and element in such cells, of which the body has so many elements. Where that is too dear,
  /// in the finest that are affordable and in cells half as large again. Returns whether anything new was
  /// found.
  bool attempt(const std::string& model, const std::string& element, double cell, double elements);
  /// Tries it once more as attempt() does, by a larger reference, where that tells more. Returns whether
  /// anything new was found.
  bool prove(const std::string& model, const std::string& element, double cell, double elements);

 private:
  using Way = std::pair<std::string, std::string>;  // model, element
  struct Found {
    std::vector<ActError> acts;
    bool divided = false;  // so that the reference's own error is in it
    bool proved = false;   // or too fine to be
  };
  using Tried = std::map<double, Found>;  // by cell, m

  bool proving() const { return settings_.most_tets == body_.most_tets_proving; }
  bool attempt(const Way& way, double cell, double elements);
  bool measure(const Way& way, double cell);
  bool judge(const Way& way, double cell);
  std::map<double, double> errors_of(const Way& way, const std::string& act) const;
  const BodyTrial& trial_on(const Anatomy& mesh, double cell);
  std::optional<std::vector<ActError>> found(const Way& way, const Anatomy& mesh, double cell);
  std::filesystem::path kept_in(const Way& way, const Anatomy& mesh) const;

  JudgedBody body_;
  TrialSettings settings_;
  std::map<Way, Tried> tried_;
  std::map<double, BodyTrial> trials_;                 // by cell
  std::optional<std::pair<double, BodyTrial>> proof_;  // the last one: they are large
};

}  // namespace prosector
