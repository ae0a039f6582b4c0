#pragma once

#include <birdstrike/core/named_choices.h>

#include <deal.II/base/parameter_handler.h>

namespace birdstrike
{
  /// Declares an entry of the present section whose text is one of the names; `member` gets the value, and gives the
  /// default.
  template <class Value>
  void declare_choice(dealii::ParameterHandler &prm, const std::string &entry, Value &member,
                      const NamedChoices<Value> &choices, const std::string &text)
  {
    prm.declare_entry(entry, choices.name(member), dealii::Patterns::Selection(choices.selection()), text);
    prm.add_action(entry, [&member, &choices](const std::string &given) { member = choices.at(given); });
  }
} // namespace birdstrike
