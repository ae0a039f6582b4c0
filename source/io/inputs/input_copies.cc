#include "io/inputs/file_entries.h"
#include "io/inputs/placed_copy.h"
#include "io/parameter_scan.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/log.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/io/input_copies.h>
#include <birdstrike/io/whole_file.h>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include <algorithm>
#include <cctype>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    const std::string folder_name = "inputs";
    const fs::path    above       = "..";

    std::string without_case(std::string text) // on some disks 'A.msh' and 'a.msh' are one file
    {
      std::ranges::transform(text, text.begin(), [](const unsigned char c) { return std::tolower(c); });
      return text;
    }

    fs::path whole_path(const fs::path &file)
    {
      std::error_code error;
      const fs::path  whole = fs::weakly_canonical(file, error);
      return error ? fs::absolute(file, error) : whole;
    }

    std::string key_of(const KnownEntry &entry)
    {
      return to_string(entry.section) + "/" + entry.name;
    }

    /// Calls `visit` with each entry that names a file that is there.
    void for_each_file(const CaseParameters &parameters, const auto &visit)
    {
      std::error_code error;
      for (const KnownEntry &entry : parameters.file.tree().entries())
        if (names_file(entry) && !entry.value.empty() && fs::is_regular_file(entry.value, error))
          visit(entry);
    }
  } // namespace

  InputCopies::InputCopies(const CaseParameters &parameters)
    : of_case(parameters), names{{origin_file, ""}}, all_inputs(list_input_files(parameters))
  {
    if (!parameters.output.copies_inputs)
      return;
    const std::vector<ScannedFile> &files = parameters.file.scanned_files();
    for (std::size_t k = 1; k < files.size(); ++k)
      add(files[k].path, "", k);
    for_each_file(parameters, [&](const KnownEntry &entry) { add(entry.value, fingerprint_of(entry.value), 0); });
    for (const ScannedFile &file : files)
      for (const FileReference &reference : file.references)
        if (const std::string fingerprint = fingerprint_of(reference.path); !fingerprint.empty())
          add(reference.path, fingerprint, 0);
    for (InputFile &input : all_inputs)
      if (const Copy *const copy = find(input.name))
        input.copy = folder_name + "/" + copy->name;
  }

  void InputCopies::add(const fs::path &source, const std::string &fingerprint, const std::size_t of_scan)
  {
    if (find(source) != nullptr)
      return;
    const std::string stem = source.stem().string(), ending = source.extension().string();
    std::string       name = source.filename().string();
    for (unsigned int k = 2; names.contains(without_case(name)); ++k)
      name = stem + "-" + std::to_string(k) + ending;
    names[without_case(name)] = name;
    copies.push_back({whole_path(source), name, fingerprint, of_scan});
  }

  const InputCopies::Copy *InputCopies::find(const fs::path &source) const
  {
    const fs::path whole = whole_path(source);
    const auto     found = std::ranges::find_if(copies, [&](const Copy &copy) { return copy.source == whole; });
    return found == copies.end() ? nullptr : &*found;
  }

  std::string InputCopies::path_of(const fs::path &source, const std::string &prefix) const
  {
    if (const Copy *const copy = find(source))
      return prefix + copy->name;
    std::error_code error;
    return fs::is_regular_file(source, error) ? whole_path(source).string() : "";
  }

  std::string InputCopies::rewritten(const std::size_t of_scan, const std::string &prefix) const
  {
    const ScannedFile &file = of_case.file.scanned_files()[of_scan];
    std::string        text;
    std::size_t        at = 0;
    for (const FileReference &reference : file.references)
      {
        const std::string path = path_of(reference.path, prefix);
        if (path.empty() || path == reference.typed)
          continue;
        const std::size_t first = file.text.find_first_not_of(" \t", reference.begin);
        const std::string line  = file.text.substr(first, reference.end - first);
        const std::size_t mark  = line.find('#'); // somebody's own comment stays
        text += file.text.substr(at, first - at) + reference.statement + path + "  " +
                (mark == std::string::npos || line.find_first_of("\r\n") != std::string::npos
                   ? "# typed: " + reference.typed
                   : line.substr(mark) + " (typed: " + reference.typed + ")");
        at = reference.end;
      }
    return text + file.text.substr(at);
  }

  std::string InputCopies::original() const
  {
    return rewritten(0, folder_name + "/");
  }

  std::string InputCopies::parameters() const
  {
    std::map<std::string, std::string> values;
    for_each_file(of_case,
                  [&](const KnownEntry &entry) { values[key_of(entry)] = path_of(entry.value, folder_name + "/"); });
    return of_case.file.as_prm(false, values);
  }

  void InputCopies::require_room(const fs::path &run_folder) const
  {
    constexpr double mebibyte = 1024. * 1024., much = 256. * mebibyte;
    double           n_bytes = 0.;
    std::error_code  error;
    for (const Copy &copy : copies)
      if (const auto n = fs::file_size(copy.source, error); !error && !copy.fingerprint.empty())
        n_bytes += static_cast<double>(n);
    if (n_bytes > much)
      log().info("The input files of the run are kept in its folder '{}': {:.0f} MiB (Output/Copy inputs).",
                 folder_name, n_bytes / mebibyte);
    if (const fs::space_info space = fs::space(run_folder, error);
        !error && space.available > 0 && n_bytes > static_cast<double>(space.available))
      throw InputError(fmt::format("The copies of the input files take {:.0f} MiB; {:.0f} MiB are free on the disk of "
                                   "'{}'.\nAction: set Output/Copy inputs = false, or choose another folder with "
                                   "--output DIR.",
                                   n_bytes / mebibyte, static_cast<double>(space.available) / mebibyte,
                                   run_folder.string()));
  }

  void InputCopies::write(const fs::path &run_folder) const
  {
    const fs::path folder = run_folder / folder_name;
    auto           before = read_origins(folder);
    if (copies.empty() && before.empty())
      return;
    require_room(run_folder);
    fs::create_directories(folder);
    std::string origins;
    for (const Copy &copy : copies)
      {
        const fs::path    file = folder / copy.name;
        const std::string origin =
          before.contains(copy.name) && whole_path(file) == copy.source ? before[copy.name] : copy.source.string();
        if (copy.fingerprint.empty())
          write_whole_file(file, {rewritten(copy.of_scan, "")});
        else
          place_copy(copy.source, file, copy.fingerprint);
        before.erase(copy.name);
        origins += describe_origin(fingerprint_of(file), copy.name, origin);
      }
    std::error_code error;
    for (const auto &[name, origin] : before)
      fs::remove(folder / name, error);
    write_whole_file(folder / origin_file, {origins});
  }

  std::string parameters_seen_from(const fs::path &run_folder, const CaseParameters &parameters)
  {
    std::map<std::string, std::string> values;
    for_each_file(parameters, [&](const KnownEntry &entry) {
      const fs::path relative = whole_path(entry.value).lexically_relative(whole_path(run_folder));
      values[key_of(entry)] =
        relative.empty() || *relative.begin() == above ? whole_path(entry.value).string() : relative.string();
    });
    return parameters.file.as_prm(false, values);
  }

  void find_copies(std::vector<InputFile> &inputs, const fs::path &run_folder, const CaseParameters &parameters)
  {
    for (InputFile &input : inputs)
      for_each_file(parameters, [&](const KnownEntry &entry) {
        const fs::path relative = whole_path(entry.value).lexically_relative(whole_path(run_folder));
        if (!relative.empty() && *relative.begin() != above && fingerprint_of(entry.value) == input.fingerprint)
          input.copy = relative.string();
      });
  }
} // namespace birdstrike
