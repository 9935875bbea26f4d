// The command line of prog06.
#pragma once

#include <string>
#include <vector>

#include "choices.h"

namespace prog06 {

/// What the words ask for.
struct Request {
  bool help = false;  ///< the help and nothing else
  Choices choices;
};

/// prog06 N R ws wa wc out.ppm [options]
extern const char* const usage;
/// All of the help.
std::string help_text();

/// Reads the words after the program's name; everything that is wrong with them otherwise. Numbers may be
/// negative: only what begins with two hyphens is an option.
sturnus::Result<Request> read_arguments(const std::vector<std::string>& words);

}  // namespace prog06
