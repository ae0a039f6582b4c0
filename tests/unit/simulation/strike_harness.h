#pragma once

#include "simulation/bird_strike.h"
#include "simulation/scene.h"
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/report/summary.h>
#include <birdstrike/structure/blade.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

/// Runs a case given as prm text, or a shipped case with overrides, and keeps its summary and its curves.
namespace birdstrike::test
{
  using Curves    = std::map<std::string, std::vector<double>>;
  using Overrides = std::vector<std::string>;

  inline Overrides with(Overrides one, const Overrides &more)
  {
    one.insert(one.end(), more.begin(), more.end());
    return one;
  }

  inline Curves read_curves(const std::filesystem::path &file)
  {
    std::ifstream            in(file);
    std::string              line;
    std::vector<std::string> names;
    Curves                   curves;
    while (std::getline(in, line))
      {
        if (line.empty() || line[0] == '#')
          continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        if (names.empty())
          for (std::string word; words >> word;)
            names.push_back(word);
        else
          for (const std::string &name : names)
            {
              double value = 0.;
              words >> value;
              curves[name].push_back(value);
            }
      }
    return curves;
  }

  /// Mean of a curve over [from, to] by the trapezoidal rule on its samples.
  inline double mean_over(const Curves &curves, const std::string &name, const double from, const double to)
  {
    const auto &t = curves.at("time"), &y = curves.at(name);
    double      sum = 0., length = 0.;
    for (std::size_t k = 1; k < t.size(); ++k)
      if (t[k - 1] >= from && t[k] <= to)
        {
          sum += 0.5 * (y[k] + y[k - 1]) * (t[k] - t[k - 1]);
          length += t[k] - t[k - 1];
        }
    return sum / length;
  }

  inline double value_at(const Curves &curves, const std::string &name, const double time)
  {
    const auto &t = curves.at("time"), &y = curves.at(name);
    for (std::size_t k = 1; k < t.size(); ++k)
      if (t[k] >= time)
        return y[k - 1] + (y[k] - y[k - 1]) * (time - t[k - 1]) / (t[k] - t[k - 1]);
    return y.back();
  }

  struct Strike
  {
    Summary summary;
    Curves  curves;
  };

  inline Strike run_file(const std::string &file, const std::vector<std::string> &overrides)
  {
    std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-XXXXXX").string();
    const std::filesystem::path folder  = mkdtemp(pattern.data());
    Strike                      result;
    {
      CaseParameters parameters;
      parameters.read(file, overrides);
      parameters.output.blade_fields = parameters.output.bird_fields = parameters.output.hdf5 = false;
      parameters.output.console_interval                                                      = 1e9;
      Scene      scene(parameters);
      BirdStrike strike(parameters, scene, folder);
      strike.run();
      result.summary = strike.compute_summary();
    }
    result.curves = read_curves(folder / "history.csv");
    std::filesystem::remove_all(folder);
    return result;
  }

  inline Strike run_text(const std::string &text, const std::vector<std::string> &overrides = {})
  {
    std::string                 pattern = (std::filesystem::temp_directory_path() / "birdstrike-case-XXXXXX").string();
    const std::filesystem::path folder  = mkdtemp(pattern.data());
    const auto                  file    = folder / "case.prm";
    std::ofstream(file) << text;
    const Strike result = run_file(file.string(), overrides);
    std::filesystem::remove_all(folder);
    return result;
  }

  inline Strike run_shipped(const std::string &name, const std::vector<std::string> &overrides = {})
  {
    return run_file(BIRDSTRIKE_SOURCE_DIR "/prm/" + name, overrides);
  }
} // namespace birdstrike::test
