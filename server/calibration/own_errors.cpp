#include "server/calibration/own_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "common/error.h"
#include "common/hash.h"
#include "common/sealed_file.h"
#include "server/calibration/rung_table.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {
namespace {

constexpr std::size_t most_tets_given = 12000;  // limit of tetrahedra for a mesh whose cell size is fixed
constexpr double weight_proving = 1.2;  // times its own: detects a body that is about to fold or collapse
constexpr double rounding = 1e-6;       // relative, of a cell size
constexpr double as_tried = 0.03;       // cell sizes that differ by a smaller fraction count as one
constexpr double next_cell = 1.5;       // of the finest affordable cell: the second one tried
constexpr double least_inferred = 1e-6;
constexpr double first_order = -1, third_order = -3;  // exponents of the error in 1/cell
constexpr double acts_not_tried = 1.5;  // factor on the errors of tried acts: for other places and tilts
constexpr double caution = 1.25;        // factor on errors inferred at finer cells than any tried

const char* kind_of(const ActError& act) {
  return act.act.starts_with("pressed") ? "touch" : "shape";
}

bool counts(const SoftDesc& desc, const char* kind) {
  return std::find(desc.choice.accuracy_of.begin(), desc.choice.accuracy_of.end(), kind) !=
         desc.choice.accuracy_of.end();
}

/// Hash of all data that a trial's outcome depends on.
class TrialKey {
 public:
  void add(double x) { hasher_.add(x); }
  void add(const Vec3& x) { hasher_.add(x.data(), 3); }
  void add(const std::string& text) {
    hasher_.add(text.size());
    hasher_.add(std::as_bytes(std::span(text)));
  }
  std::string hex() { return to_hex(hasher_.digest()); }

 private:
  StateHasher hasher_;
};

void add_material(TrialKey& key, const SoftDesc& desc) {
  for (const double x : {desc.material.youngs_modulus, desc.material.poisson_ratio,
                         desc.material.fiber_stiffness, desc.material.density, desc.material.spring_stiffness,
                         double(desc.material.hold_volume), double(desc.gravity)})
    key.add(x);
  key.add(desc.material.fiber_direction);
  for (const RegionDesc& region : desc.material.regions) {
    for (const Vec3& x : {region.center, region.size, region.fiber_direction}) key.add(x);
    for (const double x :
         {region.radius, region.youngs_modulus, region.poisson_ratio, region.fiber_stiffness})
      key.add(x);
  }
  for (const RelaxationDesc& term : desc.material.relaxation)
    for (const double x : {term.share, term.time}) key.add(x);
  for (const AttachDesc& tie : desc.attach) {
    key.add(tie.center);
    for (const double x : {tie.radius, tie.stiffness}) key.add(x);
  }
}

std::string as_text(const std::vector<ActError>& acts) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const ActError& act : acts) out.push_back({act.act, act.error});
  return out.dump();
}

std::vector<ActError> from_text(const std::string& text) {
  std::vector<ActError> out;
  for (const auto& row : nlohmann::ordered_json::parse(text))
    out.push_back({row.at(0).get<std::string>(), row.at(1).get<double>()});
  return out;
}

/// Returns an act's error with cells of that size, inferred from the errors by tried cell size.
double inferred(const std::map<double, double>& tried, double cell) {
  std::vector<double> fineness, errors;  // 1/cell, rising
  for (auto it = tried.rbegin(); it != tried.rend(); ++it) {
    fineness.push_back(1 / it->first);
    errors.push_back(std::max(least_inferred, it->second));
  }
  const double error = fineness.size() == 1 ? errors[0] * std::pow(1 / (cell * fineness[0]), first_order)
                                            : log_interpolate(fineness, errors, 1 / cell, third_order, 0);
  const bool finer = cell < tried.begin()->first * (1 - rounding);
  return (finer ? caution : 1) * error;
}

}  // namespace

OwnErrors::OwnErrors(JudgedBody body) : body_(std::move(body)) {
  if (body_.desc.choice.fixed.model && soft::is_law(body_.desc.configuration.model))
    settings_.law = body_.desc.configuration.model;
  if (body_.desc.choice.fixed.cell) body_.most_tets = std::max(body_.most_tets, most_tets_given);
  settings_.most_tets = body_.most_tets;
  if (!counts(body_.desc, "touch")) settings_.presses = 0;
  settings_.before_step = body_.before_step;
}

std::vector<ActError> OwnErrors::at(const std::string& model, const std::string& element, double cell) const {
  const auto it = tried_.find({model, element});
  if (it == tried_.end() || it->second.empty()) return {};
  std::vector<ActError> out;
  for (const ActError& act : it->second.begin()->second.acts)
    if (counts(body_.desc, kind_of(act)))
      out.push_back({act.act, acts_not_tried * inferred(errors_of(it->first, act.act), cell)});
  return out;
}

/// Returns the errors of a model and element in an act, by tried cell size. Where the reference was not
/// divided, its own error is added: as inferred, else as large as the error found.
std::map<double, double> OwnErrors::errors_of(const Way& way, const std::string& act) const {
  const auto tried = tried_.find(way);
  std::map<double, double> out;
  if (tried == tried_.end()) return out;
  std::map<double, double> of_reference;
  const Way reference = {settings_.law, "tet10"};
  if (way != reference) of_reference = errors_of(reference, act);
  for (const auto& [cell, found] : tried->second) {
    const auto same = [&](const ActError& a) { return a.act == act; };
    const auto match = std::find_if(found.acts.begin(), found.acts.end(), same);
    if (match == found.acts.end()) continue;  // a pressed place that only other meshes have
    const double more = found.divided          ? 0
                        : of_reference.empty() ? match->error
                                               : inferred(of_reference, cell);
    out[cell] = match->error + more;
  }
  return out;
}

bool OwnErrors::attempt(const std::string& model, const std::string& element, double cell, double elements) {
  return attempt({model, element}, cell, elements);
}

bool OwnErrors::prove(const std::string& model, const std::string& element, double cell, double elements) {
  settings_.most_tets = body_.most_tets_proving;
  settings_.weight = weight_proving;
  const bool more = attempt({model, element}, cell, elements);
  settings_.most_tets = body_.most_tets;
  settings_.weight = 1;
  return more;
}

bool OwnErrors::attempt(const Way& way, double cell, double elements) {
  const bool quadratic = way.second == "tet10";
  const auto most = static_cast<double>(settings_.most_tets);
  const double affordable = most / (quadratic ? 8 : 1);
  if (elements <= affordable) {
    const bool divided = 8 * elements <= most;
    const bool more = !quadratic && !divided && attempt({settings_.law, "tet10"}, cell, elements);
    return measure(way, cell) || more;
  }
  if (body_.desc.choice.fixed.cell) return false;
  const double finest = cell * std::cbrt(elements / affordable);
  const bool one = measure(way, finest), other = !proving() && measure(way, next_cell * finest);
  return one || other;
}

/// Tries model and element with such cells. Does nothing if there is no such mesh, or if it was tried before
/// and can't be verified.
bool OwnErrors::measure(const Way& way, double cell) {
  const Tried& tried = tried_[way];
  const auto same = std::find_if(tried.begin(), tried.end(),
                                 [&](const auto& row) { return std::abs(row.first / cell - 1) < as_tried; });
  if (same != tried.end()) {
    if (same->second.proved || !proving()) return false;
    cell = same->first;
  }
  try {
    return judge(way, cell);
  } catch (const InputError&) {  // too coarse for a mesh
    return false;
  }
}

bool OwnErrors::judge(const Way& way, double cell) {
  const Anatomy mesh = body_.mesh(cell);
  const auto tets = static_cast<double>(mesh.tets.tets.size()),
             most = static_cast<double>(settings_.most_tets);
  const bool divided = 8 * tets <= most;
  if (way.second == "tet10" && !divided)  // more elements than expected from the cell size
    return measure(way, cell * std::cbrt(8 * tets / most) * (1 + as_tried));
  Tried& tried = tried_[way];
  if (const auto known = tried.find(cell); known != tried.end() && !divided) {
    known->second.proved = true;
    return false;
  }
  std::optional<std::vector<ActError>> acts = found(way, mesh, cell);
  if (!acts) return false;
  tried[cell] = {std::move(*acts), divided, proving()};
  return true;
}

std::filesystem::path OwnErrors::cache_file(const Way& way, const Anatomy& mesh) const {
  TrialKey key;
  key.add("trial 5");
  for (const std::string& text : {settings_.law, way.first, way.second}) key.add(text);
  key.add(static_cast<double>(settings_.most_tets));
  key.add(static_cast<double>(settings_.presses));
  key.add(settings_.weight * body_.gravity);
  add_material(key, body_.desc);
  for (const Vec3& x : mesh.tets.positions) key.add(x);
  for (const auto& tet : mesh.tets.tets)
    for (const std::uint32_t node : tet) key.add(double(node));
  return body_.cache_dir / (key.hex() + ".trial");
}

const BodyTrial& OwnErrors::trial_on(const Anatomy& mesh, double cell) {
  const auto made = [&] { return BodyTrial(body_.desc, body_.gravity, mesh, settings_); };
  if (proving()) {
    if (!proof_ || proof_->first != cell) {
      proof_.reset();
      proof_.emplace(cell, made());
    }
    return proof_->second;
  }
  auto trial = trials_.find(cell);
  if (trial == trials_.end()) trial = trials_.emplace(cell, made()).first;
  return trial->second;
}

/// Returns the errors of model and element on the mesh, from the cache or by a trial. Nothing if a
/// verification is not cached and not to be run.
std::optional<std::vector<ActError>> OwnErrors::found(const Way& way, const Anatomy& mesh, double cell) {
  const std::filesystem::path file = cache_file(way, mesh);
  const std::string seal = file.filename().string();
  if (!body_.cache_dir.empty()) {
    const SealedFileResult kept = read_sealed_file(file, seal);
    if (kept.bytes) return from_text({kept.bytes->begin(), kept.bytes->end()});
  }
  if (proving() && !body_.prove) return std::nullopt;
  if (body_.say)
    body_.say(fmt::format("{}: {} {}, {}, cells of {:.1f} mm, {} tetrahedra", body_.desc.name,
                          proving() ? "proving" : "trying", way.first, way.second, 1e3 * cell,
                          mesh.tets.tets.size()));
  std::vector<ActError> acts = trial_on(mesh, cell).measure(way.first, way.second);
  if (!body_.cache_dir.empty()) {
    const std::string text = as_text(acts);
    write_sealed_file(file, seal, std::vector<std::uint8_t>(text.begin(), text.end()));
  }
  return acts;
}

}  // namespace prosector
