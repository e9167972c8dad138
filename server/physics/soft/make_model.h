#pragma once
// Makes what a scene's soft body stores energy in: the one place that knows every kind of elastic model.

#include <memory>

#include "server/physics/soft/elements/elastic_model.h"

namespace prosector {

/// Makes the elastic model of the scene's `model` and its constants. Throws InputError for unknown rows and
/// for constants out of range; indices of the anatomy must be in range. `anatomy` need not outlive the
/// result.
std::unique_ptr<ElasticModel> make_elastic_model(const SoftDesc& desc, const Anatomy& anatomy);

}  // namespace prosector
