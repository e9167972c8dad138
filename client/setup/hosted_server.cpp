#include "client/setup/hosted_server.h"

namespace prosector {
namespace {

std::vector<std::string> server_words(const std::filesystem::path& scene, const BusConfig& where) {
  std::vector<std::string> out = {program_folder() / "prosector-server", scene, "--session", where.session};
  for (std::string& word : network_words(where)) out.push_back(std::move(word));
  return out;
}

}  // namespace

std::vector<std::string> network_words(const BusConfig& where) {
  std::vector<std::string> out;
  if (where.domain != 0) out.insert(out.end(), {"--domain", std::to_string(where.domain)});
  if (where.profile == "lan") out.push_back("--lan");
  if (where.profile == "lan" && !where.interface.empty()) out.push_back(where.interface);
  for (const std::string& peer : where.peers) out.insert(out.end(), {"--peer", peer});
  return out;
}

Hosting::Hosting(const std::filesystem::path& scene, const BusConfig& where)
    : scene_(scene), session_(where.session), server_(server_words(scene, where)) {}

}  // namespace prosector
