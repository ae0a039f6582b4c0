#pragma once

#include "report/study/error_fit.h"
#include "report/study/grid_convergence.h"

#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  /// "tip peak = 2 %".
  struct ErrorTarget
  {
    std::string quantity; ///< as it was typed
    double      share;    ///< of the value
  };

  /// Throws InputError for what is no quantity with a percentage above 0, at most 50.
  ErrorTarget read_error_target(const std::string &text);

  /// One direction of refinement: values on its levels, the coarsest first, while all else is at its coarsest.
  struct ClimbAxis
  {
    std::string         name; ///< "bird"
    std::vector<double> sizes, values;

    /// Then the finest level is corrected to h = 0 by them (fit_order_range).
    std::optional<OrderRange> known_orders = {};

    /// Half the 95 % interval of the finest level's value, where several runs tell it; else 0.
    double noise = 0.;

    /// False where the case has no bird, or no mesh: then there is no error of one.
    bool is_there = true;

    /// False for a direction that cannot be refined: it has one level, and its error is in no bar.
    bool is_refined() const;

    /// Whether there is an error that nobody knows: of a mesh from a file.
    bool is_unknown() const;

    /// Of all levels.
    GridConvergence estimate() const;

    /// h = 0 by the order that is known; none where it is not, or there are fewer than four levels.
    std::optional<KnownOrderFit> limit() const;

    /// What takes the finest level's value there; 0 of other levels, and without a limit.
    double correction(std::size_t level) const;

    /// What comes from the way of the values to a level comes from that to the finest too, and to the limit, if it is
    /// corrected: so many times as much; infinity where nothing has come of it yet.
    double share_beyond(std::size_t level) const;

    /// Half the error bar of the finest level: that of the estimate; where changes grow, and it has none, and of three
    /// levels whose estimate is not trusted, three times the largest change of the three finest. With a limit half of
    /// its interval. Fits to four levels and more know scatter, and are at least the noise; to a bar of three, which
    /// does not, it is added.
    double bar() const;

    bool is_bar_noise() const; ///< and nothing else

    /// The same for each level: what it and every finer one is away from the finest, at most, and the finest's own bar.
    /// With a limit, what it is away from that, the finest corrected, and half of the interval.
    std::vector<double> errors() const;

    /// Whether errors may be claimed: the ladder's estimate is trusted, and of three levels has no higher order than
    /// fits may have, 2.1, or its bar, by the larger factor of safety, is below half of what is allowed: of three
    /// levels, then all changes are below a sixth of that. With an order that is known: whether there is a limit, of
    /// the finest value's sign, and five levels and more do not reject the order nor part, or have settled.
    bool is_trusted(double allowed) const;

    /// What one more level would take off the error of the finest, by the order that is seen, else by one.
    double expected_gain() const;
  };

  /// A line of a claim that fails: what both refined add to the sum of the ladders; none: no run has been.
  std::string describe_interaction(std::optional<double> interaction, const std::string &unit);

  /// What a user changes to have finer levels: "a smaller Bird/Particle spacing and more ...".
  std::string name_refinements(const ClimbAxis &bird, const ClimbAxis &mesh);

  /// Levels of both directions.
  struct ClimbChoice
  {
    std::size_t bird, mesh;
  };

  /// What a run with both refined differs from the sum of the ladders.
  struct SeenInteraction
  {
    ClimbChoice levels;
    double      size; ///< not negative
  };

  /// As far as both ladders go: it grows as the product of their ways, seen from the levels from which the least is to
  /// go, and is at least what has been seen anywhere. None of none.
  std::optional<double> extrapolate_interaction(const ClimbAxis &bird, const ClimbAxis &mesh,
                                                const std::vector<SeenInteraction> &seen);

  /// For each level of the bird the coarsest mesh with which the errors' sum is at most `allowed`. Not the coarsest
  /// levels of directions that are refined: only a run aside from both ladders shows whether errors add up.
  std::vector<ClimbChoice> find_choices(const ClimbAxis &bird, const ClimbAxis &mesh, double allowed);
} // namespace birdstrike
