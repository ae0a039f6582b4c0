#pragma once

#include <birdstrike/structure/histories.h>

namespace birdstrike
{
  class Blade;

  /// The blades of a row, each for itself (blades.csv): energies, and of elastic ones tip and root as somebody on the
  /// hub sees them. Forces and impulses on each are in PatchForces.
  class RowHistory final : public HistoryTable
  {
  public:
    explicit RowHistory(const Blade &blade); ///< of a row; it outlives the table

    void fill(std::span<double> row) const override;

  private:
    const Blade &blade;
  };
} // namespace birdstrike
