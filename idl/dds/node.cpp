#include "idl/dds/node.h"

#include <fmt/format.h>

#include "common/error.h"
#include "idl/dds/network_log.h"
#include "idl/dds/profile.h"

namespace prosector {
namespace {

/// Creates a domain. A process may have several nodes, so the local domain number is any unused one. The
/// number on the network is the profile's ExternalDomainId.
Entity create_domain(const BusConfig& config) {
  const std::string xml = profile_xml(config);
  condense_network_log();
  const ScopedLogSuppression pause;  // errors are reported below
  dds_entity_t handle = DDS_RETCODE_ERROR;
  for (dds_domainid_t local = 1000; local < 3000; ++local) {
    handle = dds_create_domain(local, xml.c_str());
    if (handle != DDS_RETCODE_PRECONDITION_NOT_MET) break;
  }
  if (handle > 0) return {handle, "domain"};
  if (config.end == BusEnd::server)
    throw InputError(fmt::format(
        "cannot open the network: UDP port {} is in use (another server with index {} runs here; choose "
        "another --index, 0 to {}), or this machine lacks the interface or address of --lan or --profile",
        server_port(config.domain, config.server_index), config.server_index, servers_per_host - 1));
  throw InputError(
      "cannot open the network: this machine lacks the network interface or address given by --lan or "
      "--profile");
}

}  // namespace

std::mutex& entity_mutex() {
  static std::mutex mutex;
  return mutex;
}

Node::Node(const BusConfig& config) : domain(create_domain(config)) {
  dds_domainid_t local = 0;
  dds_get_domainid(domain.get(), &local);
  participant = Entity(dds_create_participant(local, nullptr, nullptr), "participant");
}

}  // namespace prosector
