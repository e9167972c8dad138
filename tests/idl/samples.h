#pragma once
// One valid message of every topic.

#include <vector>

#include "idl/message.h"

namespace prosector {

std::vector<Message> sample_messages();

}  // namespace prosector
