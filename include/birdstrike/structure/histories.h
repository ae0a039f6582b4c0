#pragma once

#include <birdstrike/core/archive.h>
#include <birdstrike/core/column.h>
#include <birdstrike/core/warning.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace birdstrike
{
  /// Which histories of the blade are wanted besides those of every run: section Output/Histories, as lists of places.
  /// Their syntax is checked where they are used, before the first step.
  struct HistoryRequests
  {
    std::string axes = "global"; ///< global, blade, or six numbers
    std::string nodes;           ///< "name: x y z" or "name: node 17", separated by semicolons
    std::string elements;        ///< "name: x y z | layer" or "name: element 17 | layer"
    std::string gauges;          ///< "name: x y z | direction | face"
    std::string stations;        ///< shares of the span
    std::string patches;         ///< "name: x y z radius" or "name: xmin ymin zmin xmax ymax zmax"

    void declare(dealii::ParameterHandler &prm); ///< in the present section
    bool is_any() const
    {
      return !(nodes + elements + gauges + stations + patches).empty();
    }
  };

  /// A table of histories: what its columns are, and their present values.
  class HistoryTable
  {
  public:
    virtual ~HistoryTable() = default;

    virtual void fill(std::span<double> row) const = 0;

    virtual void follow() ///< after each macro step: what no later state tells
    {
    }
    virtual void archive(Archive &)
    {
    }

    std::string         name;    ///< of the file (<name>.csv) and of the group in results.h5
    std::vector<Column> columns; ///< "<place>.<quantity>"
  };

  /// The tables that were asked for, and what is to be said of places that the mesh does not have.
  struct BladeHistories
  {
    std::vector<std::unique_ptr<HistoryTable>> tables;
    Warnings                                   warnings;
  };
} // namespace birdstrike
