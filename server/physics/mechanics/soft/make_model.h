#pragma once
// Factory of elastic models. Only this file depends on all kinds of models.

#include <memory>

#include "server/physics/mechanics/soft/elements/elastic_model.h"

namespace prosector::soft {

/// Creates the elastic model (elements or springs) of a soft body, as the scene's `model` field names it,
/// with the scene's constants. Throws InputError for unknown names and for constants out of range. Node
/// indices in `anatomy` must be in range. `anatomy` need not outlive the result.
std::unique_ptr<ElasticModel> make_elastic_model(const SoftDesc& desc, const Anatomy& anatomy);

}  // namespace prosector::soft
