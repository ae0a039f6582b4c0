#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// A formula of the user, e.g. "1e6*exp(-t/1e-4)" or "0; 0; if(x<0.1, 10, 0)", in the variables x, y, z, t; evaluated
  /// by muparser through deal.II's FunctionParser. The constant pi is known. Not thread-safe: loads are evaluated
  /// serially.
  class Expression
  {
  public:
    /// `n_components` formulas separated by semicolons. Throws InputError, naming the entry, if the text is no formula.
    Expression(const std::string &text, unsigned int n_components, const std::string &entry);
    ~Expression();
    Expression(Expression &&) noexcept;

    /// Value of one component at a position (m) and a time (s). Throws InputError if it is not finite.
    double value(const double *position, double time, unsigned int component = 0) const;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser;
  };

  /// A formula of the user in the time t (s) alone, e.g. "600 - 2e3*t". The constant pi is known. Not thread-safe.
  class TimeLaw
  {
  public:
    /// Throws InputError, naming the entry, if the text is no such formula, or one of chance (rand).
    TimeLaw(const std::string &text, const std::string &entry);
    ~TimeLaw();
    TimeLaw(TimeLaw &&) noexcept;

    /// Throws InputError if the value is not finite.
    double operator()(double time) const;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser;
  };

  /// A formula of the user in the normalised span s, 0 at the root and 1 at the tip, e.g. "35+22*s-4*s^2" or
  /// "if(s<0.5, 1, 1.5-s)". The constant pi is known. Not thread-safe.
  class SpanLaw
  {
  public:
    /// Throws InputError, naming the entry, if the text is no formula or leaves [smallest, largest] on a sample of
    /// 0 <= s <= 1.
    SpanLaw(const std::string &text, const std::string &entry, double smallest, double largest);
    ~SpanLaw();
    SpanLaw(SpanLaw &&) noexcept;

    /// Throws InputError if the value is not finite or outside the range.
    double operator()(double s) const;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser;
  };

  /// False for an empty text and for plain zeros: nothing needs evaluating.
  bool is_present(const std::string &expression);

  /// The value of a formula without variables, "2*pi*50" or "sqrt(3)/2", by the parser of all other formulas (muparser
  /// through deal.II's FunctionParser; the constant pi is known). Nothing for a text that is no such formula, and for a
  /// value that is not finite.
  std::optional<double> evaluate_arithmetic(const std::string &text);
} // namespace birdstrike
