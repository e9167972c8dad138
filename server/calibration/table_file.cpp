#include "server/calibration/table_file.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <thread>

#include "common/hash.h"
#include "server/calibration/rung_json.h"

namespace prosector {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* format_name = "prosector rungs 2";

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown CPU";
}

std::string executable_hash() {
  std::ifstream in("/proc/self/exe", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  return to_hex(content_hash(std::as_bytes(std::span(bytes))));
}

Json to_json(const RungTable::Row& row) {
  const auto& [t, f] = row;
  Json out = rung_to_json(t.rung);
  out.update(Json{{"poisson_ratio", t.poisson_ratio},
                  {"cells", t.cells},
                  {"elements", f.elements},
                  {"settled_sag_m", f.settled_sag},
                  {"drift", f.drift},
                  {"iterations", f.iterations},
                  {"ms_per_frame", f.ms}});
  return out;
}

/// Returns a hash over everything else in the file.
std::string seal_of(Json json) {
  json.erase("seal");
  const std::string text = json.dump();
  return to_hex(content_hash(std::as_bytes(std::span(text))));
}

double positive(const Json& row, const char* key) {
  const double x = row.at(key).get<double>();
  if (!(x > 0) || !std::isfinite(x)) throw std::runtime_error(fmt::format("{} is not positive", key));
  return x;
}

double not_negative(const Json& row, const char* key) {
  const double x = row.at(key).get<double>();
  if (!(x >= 0) || !std::isfinite(x)) throw std::runtime_error(fmt::format("{} is negative", key));
  return x;
}

void add_row(const Json& row, RungTable& table) {
  RungTrial trial;
  trial.rung = rung_from_json(row);
  positive(row, "solver_tolerance");
  trial.poisson_ratio = positive(row, "poisson_ratio");
  row.at("cells").get_to(trial.cells);
  RungFigures figures;
  figures.elements = positive(row, "elements");
  figures.settled_sag = not_negative(row, "settled_sag_m");
  figures.drift = not_negative(row, "drift");
  figures.iterations = not_negative(row, "iterations");
  figures.ms = positive(row, "ms_per_frame");
  table.add(trial, figures);
}

}  // namespace

std::string machine_and_build() {
  return fmt::format("{}, {} cores, g++ {}, build {}", cpu_name(), std::thread::hardware_concurrency(),
                     __VERSION__, executable_hash());
}

FoundTable read_table(const std::filesystem::path& file, const std::string& machine) {
  std::ifstream in(file);
  if (!in) return {};
  try {
    const Json json = Json::parse(in);
    if (json.at("format") != format_name) return {{}, "is of another version"};
    if (json.at("machine") != machine)
      return {{}, "contains figures measured on another machine or by another build"};
    if (json.at("seal") != seal_of(json)) return {{}, "is damaged"};
    FoundTable out;
    for (const Json& row : json.at("rows")) add_row(row, out.table);
    return out;
  } catch (const std::exception&) {
    return {{}, "is damaged"};
  }
}

bool write_table(const std::filesystem::path& file, const std::string& machine, const RungTable& table) {
  Json json = {{"format", format_name}, {"machine", machine}, {"rows", Json::array()}};
  for (const RungTable::Row& row : table.rows())
    if (row.figures.share >= least_share) json["rows"].push_back(to_json(row));
  json["seal"] = seal_of(json);
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  // Written under another name and renamed, so that a reader never sees half a file.
  const auto part = std::filesystem::path(file.string() + ".part");
  std::ofstream out(part);
  out << json.dump(1) << "\n";
  out.close();
  if (out) std::filesystem::rename(part, file, error);
  if (!out || error) std::filesystem::remove(part, error);
  return out && !error;
}

}  // namespace prosector
