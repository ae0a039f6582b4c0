#include "measure.h"

#include <birdstrike/core/log.h>
#include <birdstrike/core/number.h>

#include <algorithm>
#include <fstream>

namespace
{
  std::string cpu_name()
  {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
      if (line.starts_with("model name"))
        return line.substr(std::min(line.size(), line.find(':') + 2));
    return "unknown";
  }
} // namespace

int main(int argc, char **argv)
{
  using namespace birdstrike::benchmarks;
  birdstrike::set_console_level("error");
  benchmark::AddCustomContext("machine", cpu_name());
  benchmark::AddCustomContext("compiler", BENCHMARK_COMPILER);
  benchmark::AddCustomContext("flags", BENCHMARK_FLAGS);
  benchmark::AddCustomContext("simd_doubles", std::to_string(birdstrike::n_lanes));
  add_machine_benchmarks();
  add_core_benchmarks();
  add_material_benchmarks();
  add_bird_benchmarks();
  add_shell_benchmarks();
  add_solid_benchmarks();
  add_contact_benchmarks();
  add_scene_benchmarks();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 1; // a filter that nothing matches
}
