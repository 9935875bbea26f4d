// The machine that measured, and what the programs were compiled with.
#include <sturnus/isa.h>
#include <sturnus/version.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <thread>

#include "sections.h"

namespace bench {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace

Json describe_machine() {
  const auto kilobytes = [](int name) { return sysconf(name) / 1024; };
  return {{"date", date()},
          {"processor", processor()},
          {"cores", std::thread::hardware_concurrency()},
          {"cache_kilobytes",
           {{"L1d", kilobytes(_SC_LEVEL1_DCACHE_SIZE)},
            {"L2", kilobytes(_SC_LEVEL2_CACHE_SIZE)},
            {"L3", kilobytes(_SC_LEVEL3_CACHE_SIZE)}}},
          {"instruction_set", sturnus::isa_in_use()},
          {"compiler", BENCH_COMPILER},
          {"flags", BENCH_FLAGS},
          {"flags_of_all_pairs", BENCH_NAIVE_FLAGS},
          {"nanoflann", BENCH_NANOFLANN},
          {"version", sturnus::version}};
}

}  // namespace bench
