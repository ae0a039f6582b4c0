#pragma once

#include <functional>

namespace CLI
{
  class App;
}

namespace birdstrike
{
  struct Requests;

  /// Declares the commands about parameter files: what they may say (parameters, materials, liquids), and a new one.
  /// As declare_commands does.
  void declare_file_commands(CLI::App &app, Requests &requests, std::function<void()> &action);
} // namespace birdstrike
