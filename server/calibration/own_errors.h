#pragma once
// How wrong ways of modelling are on one body: found by trials on its own meshes (body_trial.h) where these
// are affordable, inferred at other cells. Found ones are kept from run to run, by the mesh and what it is
// made of.

#include <filesystem>
#include <functional>
#include <map>
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

 private:
  using Way = std::pair<std::string, std::string>;        // model, element
  using Tried = std::map<double, std::vector<ActError>>;  // by cell, m

  bool measure(const Way& way, double cell);
  void add_reference_error(std::vector<ActError>& acts, double cell) const;
  std::vector<ActError> found(const Way& way, const Anatomy& mesh, double cell);
  std::filesystem::path kept_in(const Way& way, const Anatomy& mesh) const;

  JudgedBody body_;
  TrialSettings settings_;
  std::map<Way, Tried> tried_;
  std::map<double, BodyTrial> trials_;  // by cell
};

}  // namespace prosector
