// From names to instruction sets and back.
#include "isa_option.h"

#include <sturnus/isa.h>

#include <algorithm>
#include <iterator>

namespace program {
namespace {

using sturnus::Isa;

constexpr Isa isas[] = {Isa::best, Isa::plain, Isa::sse4, Isa::avx2, Isa::avx512, Isa::neon};

}  // namespace

const std::vector<std::string>& isa_names() {
  static const std::vector<std::string> names = {"best", "scalar", "sse4", "avx2", "avx512", "neon"};
  return names;
}

bool use_isa_named(const std::string& name) {
  const auto place = std::find(isa_names().begin(), isa_names().end(), name);
  return place != isa_names().end() && sturnus::use_isa(isas[place - isa_names().begin()]);
}

std::string isa_name_in_use() {
  const std::string name = sturnus::isa_in_use();
  return name == "plain" ? "scalar" : name;
}

std::string isas_here() {
  std::string those;
  for (auto one = std::next(isa_names().begin()); one != isa_names().end(); ++one) {
    if (use_isa_named(*one)) those += (those.empty() ? "" : ", ") + *one;
  }
  sturnus::use_isa(Isa::best);
  return those;
}

}  // namespace program
