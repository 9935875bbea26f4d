// The texts of the Shadertoy tabs in shadertoy/, as they are shipped.
#pragma once

namespace sturnus {

extern const char* const common_tab;
extern const char* const buffer_a_tab;
extern const char* const image_tab;

}  // namespace sturnus
