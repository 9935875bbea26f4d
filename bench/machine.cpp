// The machine that measured, and what the programs were compiled with.
#include <sturnus/isa.h>
#include <sturnus/version.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "sections.h"

namespace bench {
namespace {

// The value of a key of the first processor, as the kernel tells it.
std::string told(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) continue;
    if (line.substr(0, line.find_last_not_of(" \t", colon - 1) + 1) == key) return line.substr(colon + 2);
  }
  return "unknown";
}

// Clouds name a whole line of processors alike; family and model tell them apart.
std::string processor() {
  return told("model name") + " (family " + told("cpu family") + ", model " + told("model") + ")";
}

std::string first_word(const std::string& path) {
  std::ifstream file(path);
  std::string word;
  file >> word;
  return word;
}

// Sizes of the caches that hold data, as the kernel knows them: {"L1": "48K", ...}.
Json caches() {
  Json out = Json::object();
  for (int index = 0;; ++index) {
    const std::string folder = "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) + "/";
    const std::string level = first_word(folder + "level");
    if (level.empty()) return out;
    if (first_word(folder + "type") != "Instruction") out["L" + level] = first_word(folder + "size");
  }
}

// How many programs wanted a core in the last minute; figures from a busy machine are to be known as such.
double load() {
  double out = 0;
  return getloadavg(&out, 1) == 1 ? out : 0;
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace

Json describe_machine() {
  return {{"date", date()},
          {"processor", processor()},
          {"cores", std::thread::hardware_concurrency()},
          {"caches", caches()},
          {"load_before", load()},
          {"instruction_set", sturnus::isa_in_use()},
          {"compiler", BENCH_COMPILER},
          {"flags", BENCH_FLAGS},
          {"flags_of_all_pairs", BENCH_NAIVE_FLAGS},
          {"nanoflann", BENCH_NANOFLANN},
          {"version", sturnus::version}};
}

}  // namespace bench
