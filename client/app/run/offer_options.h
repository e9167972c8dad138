#pragma once
// Options of poses and camera images that are published to other software.

#include <string>
#include <vector>

#include "client/offer/offer_protocol.h"

namespace prosector {

struct OfferOptions {
  std::vector<Offer> poses;  // servers of poses
  std::string camera;        // address of the camera whose images are also published; empty: none
};

}  // namespace prosector
