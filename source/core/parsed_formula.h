#pragma once

#include <birdstrike/core/quiet_errors.h>

#include <birdstrike/core/errors.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <string>

namespace birdstrike
{
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
