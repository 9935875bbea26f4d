// The version of the library; part of what "same bits" is promised for.
#pragma once

namespace sturnus {

/// Semantic version, e.g. "0.1.0". Same scenario, same events and same version give the same bits.
inline constexpr const char* version = "0.1.0";

}  // namespace sturnus
