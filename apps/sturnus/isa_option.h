// The instruction sets by the names that --isa takes.
#pragma once

#include <string>
#include <vector>

namespace program {

/// "best", "scalar" for the plain loop, and one for each instruction set.
const std::vector<std::string>& isa_names();

/// Puts one into use; false where the machine lacks it, and nothing changes then.
bool use_isa_named(const std::string& name);

/// The name of what is in use, never "best".
std::string isa_name_in_use();

/// The names of those that the machine has, for sentences. Leaves the best in use.
std::string isas_here();

}  // namespace program
