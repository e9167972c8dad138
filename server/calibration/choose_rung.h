#pragma once
// Choice of a rung from the measured table: the cheapest that is accurate enough, or the most accurate within
// a budget.

#include <functional>
#include <string>
#include <vector>

#include "server/accuracy/body_trial.h"
#include "server/calibration/rung_table.h"

namespace prosector {

/// A rung chosen for a body, with its expected error and cost. It is an input of the run and stored in the
/// journal.
struct Choice {
  std::string body;
  Rung rung;
  double cell = 0;             // m
  std::string grade = "none";  // as SoftDesc::grade
  Prospect expected;
  bool good_enough = true;     // false: no rung is; this is the best available
  std::vector<ActError> acts;  // expected error of each act; empty: not tried on the body itself
};

inline bool chosen_by_need(const SoftDesc& desc) {
  return static_cast<bool>(desc.accuracy) || static_cast<bool>(desc.budget);
}

/// Returns the rungs that agree with what the scene fixed. Throws InputError when there is none.
std::vector<Rung> candidates(const SoftDesc& desc);

/// Returns the trials that the table must hold to choose among the candidates.
std::vector<RungTrial> trials_for(const SoftDesc& desc);

/// Function that returns the errors of a model and element on the body itself with cells of that size (m),
/// act by act. Empty where they are not known: then the table's beam is used.
using OnTheBody =
    std::function<std::vector<ActError>(const std::string& model, const std::string& element, double cell)>;

/// Errors of a body that are known from trials on the body itself.
struct KnownErrors {
  OnTheBody on_the_body = {};  // empty: no trials
  double untried_error_ratio =
      1;  // assumed error of an untried model and element, over that of the table's beam
};

/// Chooses a rung for the body. `mesh` is the body's mesh with cells of `mesh_cell` m; the number of elements
/// is proportional to 1/cell³. No cell is larger than `largest_cell` m. Meshes are at most as fine as the
/// table's finest, or twice as fine where errors on the body itself are known. Such errors replace the
/// table's, except for the share that is due to the effort. Throws std::logic_error when the table lacks a
/// trial of trials_for().
Choice choose_rung(const SoftDesc& desc, const RungTable& table, const BodyGeometry& mesh, double mesh_cell,
                   double largest_cell = 1, const KnownErrors& known = {});

/// Returns whether choice `one` meets the accuracy or budget of the description better than choice `other`.
bool serves_better(const SoftDesc& desc, const Choice& one, const Choice& other);

/// Writes the choice into the description.
void adopt(const Choice& choice, SoftDesc& desc);

/// Lists the errors of acts as text.
std::string in_words(const std::vector<ActError>& acts);

/// Returns one line of text: the request, the choice, its expected error and cost, and by how much it misses
/// the request.
std::string explain(const Choice& choice, const SoftDesc& desc);

}  // namespace prosector
