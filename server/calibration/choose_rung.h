#pragma once
// The cheapest rung that is good enough, or the best within a budget, by the measured table.

#include <functional>
#include <string>
#include <vector>

#include "server/accuracy/body_trial.h"
#include "server/calibration/rung_table.h"

namespace prosector {

/// What was chosen for a body and what is expected of it; an input of the run, kept in its journal.
struct Choice {
  std::string body;
  Rung rung;
  double cell = 0;             // m
  std::string grade = "none";  // as SoftDesc::grade
  Prospect expected;
  bool good_enough = true;     // false: nothing was, this is the best there is
  std::vector<ActError> acts;  // what is expected of each; empty: not judged on the body itself
};

inline bool chosen_by_need(const SoftDesc& desc) {
  return static_cast<bool>(desc.accuracy) || static_cast<bool>(desc.budget);
}

/// Returns the rungs that come into question beside what the scene fixed. Throws InputError when it fixed
/// what no rung goes with.
std::vector<Rung> candidates(const SoftDesc& desc);

/// Returns what the table must hold to choose among the candidates.
std::vector<RungTrial> trials_for(const SoftDesc& desc);

/// Tells what model and element get wrong on the body itself in cells of that size (m), act by act. Nothing
/// where that isn't known: the table's beam stands for it.
using OnTheBody =
    std::function<std::vector<ActError>(const std::string& model, const std::string& element, double cell)>;

/// What is known of a body beyond the table.
struct KnownErrors {
  OnTheBody on_the_body = {};  // empty: nothing
  double hope = 1;             // what a way that is not known gets wrong, over what the table's beam does
};

/// Chooses a rung for the body. `mesh` is the body's with cells of `mesh_cell` m; the number of elements goes
/// with 1/cell³. Meshes are at most as fine as the table's finest, where nothing is gained that it knows of,
/// and no cell is larger than `largest_cell` m. What is known of
/// the body itself takes the place of the table's errors, but for the effort's part. Throws std::logic_error
/// when the table lacks what trials_for() says.
Choice choose_rung(const SoftDesc& desc, const RungTable& table, const BodyGeometry& mesh, double mesh_cell,
                   double largest_cell = 1, const KnownErrors& known = {});

/// Tells whether one choice serves what the description asks for better than the other.
bool serves_better(const SoftDesc& desc, const Choice& one, const Choice& other);

/// Puts the choice into the description.
void adopt(const Choice& choice, SoftDesc& desc);

/// Lists what acts get wrong, for people.
std::string in_words(const std::vector<ActError>& acts);

/// Returns one line for people: what was asked, what was chosen, what is expected, and by how much it misses.
std::string explain(const Choice& choice, const SoftDesc& desc);

}  // namespace prosector
