#pragma once

#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <string>
#include <vector>

/// Why a file with these entries is refused; "accepted" if it is not.
inline std::string refusal(const std::string &file, const std::vector<std::string> &entries)
{
  try
    {
      birdstrike::CaseParameters().read(file, entries);
    }
  catch (const birdstrike::InputError &error)
    {
      return error.what();
    }
  return "accepted";
}
