#pragma once

#include <memory>
#include <string>

namespace spdlog
{
  class logger;
}

namespace birdstrike
{
  /// The project's log: console (stdout), and once a run folder exists also its log.txt.
  spdlog::logger &log();

  /// Also write to this file from now on, created anew unless it `is_continued`. Throws InputError if it cannot be
  /// opened.
  void log_to_file(const std::string &path, bool is_continued = false);

  /// A log as at the start of the program: the console, as it is now, and no file.
  void reset_log();

  /// Told in two lengths: the console shows the brief text (the whole one where its level is "debug"), the file keeps
  /// the whole.
  void tell(const std::string &brief, const std::string &whole);

  /// Lowest severity shown on the console: "trace", "info", "warning", "error", "off".
  void set_console_level(const std::string &level);
} // namespace birdstrike
