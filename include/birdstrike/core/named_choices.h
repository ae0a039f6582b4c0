#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace birdstrike
{
  /// A table name -> value for the choices of one parameter: the one place that knows the spelling.
  template <class Value>
  class NamedChoices
  {
  public:
    NamedChoices(std::initializer_list<std::pair<std::string, Value>> entries) : entries(entries)
    {
    }

    /// "a|b|c", for dealii::Patterns::Selection.
    std::string selection() const
    {
      std::string text;
      for (const auto &[name, value] : entries)
        text += (text.empty() ? "" : "|") + name;
      return text;
    }

    bool has(const std::string &name) const
    {
      for (const auto &entry : entries)
        if (entry.first == name)
          return true;
      return false;
    }

    /// Throws std::out_of_range for a value that has no name.
    const std::string &name(const Value &value) const
    {
      for (const auto &entry : entries)
        if (entry.second == value)
          return entry.first;
      throw std::out_of_range("A value that is none of " + selection());
    }

    /// Throws std::out_of_range with the allowed names.
    const Value &at(const std::string &name) const
    {
      for (const auto &[key, value] : entries)
        if (key == name)
          return value;
      throw std::out_of_range("'" + name + "' is none of " + selection());
    }

  private:
    std::vector<std::pair<std::string, Value>> entries;
  };
} // namespace birdstrike
