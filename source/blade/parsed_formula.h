#pragma once

#include <birdstrike/core/errors.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <iostream>
#include <string>

namespace birdstrike
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

  /// Compiles formulas separated by ';' in these variables (the last one is time if there are dim + 1). `complaint` is
  /// the text of the InputError if one of them is no formula.
  template <int dim>
  void compile(dealii::FunctionParser<dim> &function, const std::string &variables, const std::string &text,
               const bool has_time, const std::string &complaint)
  {
    try
      {
        const QuietErrors quiet;
        function.initialize(variables, text, {{"pi", dealii::numbers::PI}}, has_time);
        // muparser compiles at the first evaluation, and only then finds what is wrong.
        dealii::Point<dim> somewhere;
        for (int d = 0; d < dim; ++d)
          somewhere[d] = 0.1;
        for (unsigned int c = 0; c < function.n_components; ++c)
          function.value(somewhere, c);
      }
    catch (const std::exception &)
      {
        throw InputError(complaint);
      }
  }
} // namespace birdstrike
