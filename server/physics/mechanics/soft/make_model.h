#pragma once
// Factory of elastic models. Only this file depends on all kinds of models.

#include <memory>

#include "server/physics/mechanics/soft/elements/elastic_model.h"

namespace prosector {

/// Creates the elastic model named by the scene's `model`, with its constants. Throws InputError for unknown
/// table rows and for constants out of range. Indices in the anatomy must be in range. `anatomy` need not
/// outlive the result.
std::unique_ptr<ElasticModel> make_elastic_model(const SoftDesc& desc, const Anatomy& anatomy);

}  // namespace prosector
