// Events compared: what of a recording was done by hand.
#pragma once

#include <sturnus/events.h>

#include <vector>

namespace studio {

bool is_same(const sturnus::Event& one, const sturnus::Event& other);

/// Of a recording's events those that its scenario did not have, in their order.
std::vector<sturnus::Event> done_by_hand(const std::vector<sturnus::Event>& recorded,
                                         const std::vector<sturnus::Event>& own);

}  // namespace studio
