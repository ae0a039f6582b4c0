#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// That a message says all of it.
inline void expect_parts(const std::string &message, const std::vector<std::string> &parts)
{
  for (const std::string &part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in:\n" << message;
}
