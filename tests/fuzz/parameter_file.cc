#include "io/parameter_scan.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include "fuzz_input.h"

/// A parameter file as a person types it: scanned, which finds most faults at once; what is left is read as a case,
/// checked, printed and read again. What is accepted must come back the same from its own printout.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  using namespace birdstrike;
  static const fuzz::Folder   folder;
  static const CaseParameters entries;
  static const ParameterTree  known = entries.file.tree();
  const std::string           file  = folder.write("case.prm", fuzz::text_of(data, size));
  try
    {
      ScannedParameters scanned;
      scan_parameter_file(file, known, scanned);
    }
  catch (const InputError &)
    {
      return 0;
    }
  CaseParameters parameters, again;
  try
    {
      parameters.read(file);
    }
  catch (const InputError &)
    {
      return 0;
    }
  again.read(folder.write("case.prm", parameters.file.as_prm()));
  if (!first_difference(parameters, again, {}).empty())
    __builtin_trap();
  return 0;
}
