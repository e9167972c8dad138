#pragma once
// Choice of a rung from the measured table: the cheapest that is accurate enough, or the most accurate within
// a budget.

#include <functional>
#include <string>
#include <vector>

#include "server/accuracy/body_trial.h"
#include "server/calibration/rung_table.h"

namespace prosector {

/// A rung (model configuration) chosen for a body, with its cell size, expected error and cost. It is an
/// input of the session and is stored in its journal.
struct Choice {
  std::string body;
  Rung rung;
  double cell = 0;                // m
  Grading grade = Grading::none;  // as in SoftGeometry
  Prospect expected;
  bool good_enough = true;     // false: no rung is; this is the best available
  std::vector<ActError> acts;  // expected error of each act; empty: not tried on the body itself
};

inline bool chosen_by_need(const SoftDesc& desc) {
  return static_cast<bool>(desc.choice.accuracy) || static_cast<bool>(desc.choice.budget);
}

/// Returns the rungs (model configurations) that agree with the model, element and solver that the scene
/// fixed. Throws InputError if there is none.
std::vector<Rung> candidates(const SoftDesc& desc);

/// Returns the measurements that the table of measured errors and costs must contain to choose among the
/// model configurations that are candidates for this body.
std::vector<RungTrial> trials_for(const SoftDesc& desc);

/// Function that returns the errors of a model and element on the body itself with cells of size `cell` (m),
/// one for each test load. An empty result means that they are not known; then the errors of the measured
/// table's beam are used.
using OnTheBody =
    std::function<std::vector<ActError>(const std::string& model, const std::string& element, double cell)>;

/// Errors of a body that are known from trials on the body itself, and the assumed error of what was not
/// tried.
struct KnownErrors {
  OnTheBody on_the_body = {};  // empty: no trials
  double untried_error_ratio =
      1;  // assumed error of an untried model and element, over that of the table's beam
};

/// Chooses the configuration and cell size that best meet the accuracy or budget of the body's description.
/// `mesh` is the body's mesh with cells of `mesh_cell` m; the number of elements is proportional to 1/cell³.
/// No cell is larger than `largest_cell` m. Meshes are at most as fine as the table's finest, or twice as
/// fine where errors on the body itself are known. Such errors replace the table's, except for the share that
/// is due to the limited effort. Throws std::logic_error if the table lacks a measurement that trials_for()
/// lists.
Choice choose_rung(const SoftDesc& desc, const RungTable& table, const BodyGeometry& mesh, double mesh_cell,
                   double largest_cell = 1, const KnownErrors& known = {});

/// Returns whether the choice `one` meets the accuracy or the budget that the description requests better
/// than the choice `other`.
bool serves_better(const SoftDesc& desc, const Choice& one, const Choice& other);

/// Writes the chosen configuration, cell size and mesh grading into the body's description.
void adopt(const Choice& choice, SoftDesc& desc);

/// Returns the errors under test loads as text, such as "<name of the load> 5 %", separated by commas.
std::string in_words(const std::vector<ActError>& acts);

/// Returns one line of text that explains a choice: the request, the chosen configuration, its expected error
/// and cost, and by how much it misses the request.
std::string explain(const Choice& choice, const SoftDesc& desc);

}  // namespace prosector
