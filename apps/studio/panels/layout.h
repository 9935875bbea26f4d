// Where panels stand.
#pragma once

#include "desk.h"

namespace studio {

Layout lay_out(const Desk& desk, sturnus::Size points);
/// What the panels at the edges leave free.
Box free_area(const Desk& desk);

}  // namespace studio
