#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

/// Keeps a figure that the running test has found, under a name of that test's own: tests/verification reads it from
/// the test's report and sets it beside its reference. The test itself asserts what it always did.
inline void record(const std::string &name, const double value)
{
  std::ostringstream text;
  text.precision(9);
  text << value;
  testing::Test::RecordProperty(name, text.str());
}
