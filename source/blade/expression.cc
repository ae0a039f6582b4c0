#include <birdstrike/blade/expression.h>
#include <birdstrike/core/errors.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <iostream>

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

  namespace
  {
    /// deal.II prints muparser's complaint to std::cerr before it throws; the user gets our sentence instead.
    class QuietErrors
    {
    public:
      QuietErrors() : kept(std::cerr.rdbuf(nullptr))
      {
      }
      ~QuietErrors()
      {
        std::cerr.rdbuf(kept);
        std::cerr.clear();
      }
      QuietErrors(const QuietErrors &)            = delete;
      QuietErrors &operator=(const QuietErrors &) = delete;

    private:
      std::streambuf *kept;
    };
  } // namespace

  Expression::Expression(const std::string &text, const unsigned int n_components, const std::string &entry)
    : parser(std::make_unique<Parser>(text, n_components, entry))
  {
    const std::string allowed = ".\nAllowed: " + std::to_string(n_components) +
                                " formula(s) in x, y, z, t separated by ';', e.g. '1e6*exp(-t/1e-4)'.";
    if (std::count(text.begin(), text.end(), ';') + 1 != n_components)
      throw InputError("Blade/" + entry + ": '" + text + "' has the wrong number of formulas" + allowed);
    try
      {
        const QuietErrors quiet;
        parser->function.initialize("x,y,z,t", text, {{"pi", dealii::numbers::PI}}, true);
        // muparser compiles at the first evaluation, and only then finds what is wrong.
        for (unsigned int c = 0; c < n_components; ++c)
          parser->function.value(dealii::Point<3>(0.1, 0.1, 0.1), c);
      }
    catch (const std::exception &)
      {
        throw InputError("Blade/" + entry + ": '" + text + "' is not a formula" + allowed);
      }
  }

  Expression::~Expression()                      = default;
  Expression::Expression(Expression &&) noexcept = default;

  double Expression::value(const double *position, const double time, const unsigned int component) const
  {
    parser->function.set_time(time);
    const double value = parser->function.value(dealii::Point<3>(position[0], position[1], position[2]), component);
    if (!std::isfinite(value))
      throw InputError("Blade/" + parser->entry + ": '" + parser->text + "' is not finite at (" +
                       std::to_string(position[0]) + ", " + std::to_string(position[1]) + ", " +
                       std::to_string(position[2]) + "), t = " + std::to_string(time) + " s.");
    return value;
  }

  bool is_present(const std::string &expression)
  {
    return expression.find_first_not_of(" 0.;,") != std::string::npos;
  }
} // namespace birdstrike
