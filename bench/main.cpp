// sturnus-yardsticks: our engine and others' ways to compute the same flock, timed in turns in one process.
#include <sturnus/files.h>

#include <algorithm>
#include <cstdio>

#include "clock.h"
#include "flocks.h"
#include "sections.h"

namespace bench {
namespace {

struct Section {
  const char* name;
  Json (*measure)(Effort);
};

const std::vector<Section> sections = {
    {"yardsticks", measure_yardsticks}, {"sizes", measure_sizes},
    {"neighbours", measure_neighbours}, {"instruction_sets", measure_instruction_sets},
    {"threads", measure_threads},       {"indexes", measure_indexes},
    {"dense", measure_dense},           {"clumps", measure_clumps},
    {"living", measure_living},         {"sixty", measure_sixty}};

struct Words {
  Effort effort = Effort::usual;
  std::string output;
  std::vector<std::string> only;
};

std::string usage() {
  std::string out = "usage: sturnus-yardsticks [--quick | --large] [-o FILE.json] [SECTION ...]\nsections:";
  for (const Section& section : sections) out += std::string(" ") + section.name;
  return out + "\n";
}

bool is_section(const std::string& word) {
  for (const Section& section : sections) {
    if (word == section.name) return true;
  }
  return false;
}

Words words_of(int count, char** values) {
  Words out;
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    if (word == "--quick") {
      out.effort = Effort::quick;
    } else if (word == "--large") {
      out.effort = Effort::large;
    } else if (word == "-o" && i + 1 < count) {
      out.output = values[++i];
    } else if (is_section(word)) {
      out.only.push_back(word);
    } else {
      throw Failure{"\"" + word + "\" is not known here\n" + usage()};
    }
  }
  return out;
}

const char* name_of(Effort effort) {
  return effort == Effort::quick ? "quick" : effort == Effort::large ? "large" : "usual";
}

void measure(const Words& words) {
  if (!words.output.empty()) {
    if (const auto possible = sturnus::check_file(words.output); !possible) throw Failure{possible.error()};
  }
  Json out = {{"effort", name_of(words.effort)}, {"machine", describe_machine()}};
  const double begun = wall_seconds();
  for (const Section& section : sections) {
    if (!words.only.empty() &&
        std::find(words.only.begin(), words.only.end(), section.name) == words.only.end())
      continue;
    say("== %s", section.name);
    out[section.name] = section.measure(words.effort);
  }
  out["seconds"] = wall_seconds() - begun;
  say("== done in %.0f seconds", wall_seconds() - begun);
  if (words.output.empty()) return;
  if (const auto written = sturnus::write_text(words.output, out.dump(1) + "\n"); !written) {
    throw Failure{written.error()};
  }
}

}  // namespace
}  // namespace bench

int main(int count, char** values) {
  try {
    bench::measure(bench::words_of(count, values));
  } catch (const bench::Failure& failure) {
    std::fprintf(stderr, "sturnus-yardsticks: %s\n", failure.what.c_str());
    return 1;
  }
  return 0;
}
