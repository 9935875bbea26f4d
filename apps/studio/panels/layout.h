// Where panels stand.
#pragma once

#include "desk.h"

namespace studio {

Layout lay_out(const Desk& desk, sturnus::Size points);

}  // namespace studio
