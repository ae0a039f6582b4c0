#include "io/parameter_messages.h"
#include "io/typed_numbers.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/option_number.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

namespace birdstrike
{
  namespace
  {
    /// The plain number that a word stands for.
    std::string read(const std::string &option, const std::string &text, const std::string &range,
                     const dealii::Patterns::PatternBase &pattern)
    {
      KnownEntry entry;
      entry.name              = option;
      entry.unit              = "-";
      entry.pattern           = pattern.description();
      const std::string value = read_typed_numbers(text, entry, "The command line");
      if (!entry.allows(value))
        throw InputError(message({option + " cannot be " + quote(text) + ".", "  Allowed: " + range + "."}));
      return value;
    }
  } // namespace

  std::size_t read_option_count(const std::string &option, const std::string &text, const int smallest,
                                const int largest)
  {
    const std::string range = "an integer from " + std::to_string(smallest) + " to " + std::to_string(largest);
    return static_cast<std::size_t>(
      dealii::Utilities::string_to_int(read(option, text, range, dealii::Patterns::Integer(smallest, largest))));
  }

  double read_option_number(const std::string &option, const std::string &text)
  {
    return dealii::Utilities::string_to_double(read(option, text, "a number", dealii::Patterns::Double()));
  }
} // namespace birdstrike
