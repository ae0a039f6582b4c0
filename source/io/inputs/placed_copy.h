#pragma once

#include <filesystem>
#include <map>
#include <string>

/// Files of the folder `inputs` of a run.
namespace birdstrike
{
  constexpr const char *origin_file = "origin.txt";

  /// By name, where the copies of a folder come from; empty where no run has left any.
  std::map<std::string, std::string> read_origins(const std::filesystem::path &folder);

  /// A line of that file.
  std::string describe_origin(const std::string &fingerprint, const std::string &name, const std::string &origin);

  /// Puts a copy of `source`, whose contents had this fingerprint when they were read, at `file`. Below a folder of
  /// several runs it is a link to one that all of them share. Throws InputError where the contents have changed.
  void place_copy(const std::filesystem::path &source, const std::filesystem::path &file,
                  const std::string &fingerprint);
} // namespace birdstrike
