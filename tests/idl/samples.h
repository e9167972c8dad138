#pragma once
// One valid message of every topic.

#include <vector>

#include "common/messages.h"

namespace prosector {

std::vector<Message> sample_messages();

}  // namespace prosector
