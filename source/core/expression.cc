#include "core/parsed_formula.h"

#include <birdstrike/core/expression.h>
#include <birdstrike/core/text/number_text.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  struct Expression::Parser
  {
    Parser(const std::string &text, const unsigned int n_components, const std::string &entry)
      : function(n_components), text(text), entry(entry)
    {
    }

    dealii::FunctionParser<3> function;
    std::string               text, entry;
  };

  Expression::Expression(const std::string &text, const unsigned int n_components, const std::string &entry)
    : parser(std::make_unique<Parser>(text, n_components, entry))
  {
    const std::string allowed = ".\nAllowed: " + std::to_string(n_components) +
                                " formula(s) in x, y, z, t separated by ';', e.g. '1e6*exp(-t/1e-4)'.";
    if (std::count(text.begin(), text.end(), ';') + 1 != n_components)
      throw InputError("Blade/" + entry + ": '" + text + "' has the wrong number of formulas" + allowed);
    compile(parser->function, "x,y,z,t", text, true, "Blade/" + entry + ": '" + text + "' is not a formula" + allowed);
  }

  Expression::~Expression()                      = default;
  Expression::Expression(Expression &&) noexcept = default;

  double Expression::value(const double *position, const double time, const unsigned int component) const
  {
    parser->function.set_time(time);
    const double value = parser->function.value(dealii::Point<3>(position[0], position[1], position[2]), component);
    if (!std::isfinite(value))
      throw InputError("Blade/" + parser->entry + ": '" + parser->text + "' is not finite at " + point_text(position) +
                       ", t = " + number_text(time) + " s.");
    return value;
  }

  struct TimeLaw::Parser
  {
    dealii::FunctionParser<1> function;
    std::string               text, entry;
  };

  TimeLaw::TimeLaw(const std::string &text, const std::string &entry)
    : parser(new Parser{dealii::FunctionParser<1>(1), text, entry})
  {
    const std::string complaint = "Blade/" + entry + ": '" + text +
                                  "' is not a formula in t.\nAllowed: a number, or a formula in the time t alone, e.g. "
                                  "'600 - 2e3*t' or 'if(t<1e-3, 600, 590)'.";
    if (text.find("rand") != std::string::npos)
      throw InputError(complaint);
    compile(parser->function, "t", text, false, complaint);
  }

  TimeLaw::~TimeLaw()                   = default;
  TimeLaw::TimeLaw(TimeLaw &&) noexcept = default;

  double TimeLaw::operator()(const double time) const
  {
    const double value = parser->function.value(dealii::Point<1>(time));
    if (!std::isfinite(value))
      throw InputError("Blade/" + parser->entry + ": '" + parser->text + "' is not finite at t = " + number_text(time) +
                       " s.");
    return value;
  }

  struct SpanLaw::Parser
  {
    dealii::FunctionParser<1> function;
    std::string               text, entry;
    double                    smallest, largest;
  };

  SpanLaw::SpanLaw(const std::string &text, const std::string &entry, const double smallest, const double largest)
    : parser(new Parser{dealii::FunctionParser<1>(1), text, entry, smallest, largest})
  {
    compile(parser->function, "s", text, false,
            "Blade/" + entry + ": '" + text +
              "' is not a formula in s.\nAllowed: one formula in the normalised span s (0 root, 1 tip), e.g. "
              "'35+22*s'.");
    constexpr unsigned int n_samples = 200;
    for (unsigned int k = 0; k <= n_samples; ++k)
      (*this)(double(k) / n_samples);
  }

  SpanLaw::~SpanLaw()                   = default;
  SpanLaw::SpanLaw(SpanLaw &&) noexcept = default;

  double SpanLaw::operator()(const double s) const
  {
    const double value = parser->function.value(dealii::Point<1>(s));
    if (!(value >= parser->smallest && value <= parser->largest))
      throw InputError("Blade/" + parser->entry + ": '" + parser->text + "' is " + number_text(value) +
                       " at s = " + number_text(s) + ".\nAllowed: " + number_text(parser->smallest) + " to " +
                       number_text(parser->largest) + " for 0 <= s <= 1.");
    return value;
  }

  bool is_present(const std::string &expression)
  {
    return expression.find_first_not_of(" 0.;,") != std::string::npos;
  }
} // namespace birdstrike
