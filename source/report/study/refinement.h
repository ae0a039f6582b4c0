#pragma once

#include "report/study/error_fit.h"
#include "report/study/study_points.h"
#include <birdstrike/core/named_choices.h>
#include <birdstrike/report/converge.h>

#include <optional>
#include <string>
#include <vector>

namespace birdstrike
{
  struct CaseParameters;

  const NamedChoices<Refinement> &refinements(); ///< how they are spelt

  /// A case, finer or coarser.
  struct LadderLevel
  {
    double                   size; ///< h: m, or relative to the case
    std::vector<std::string> overrides;
    double                   mesh_size = 0.; ///< m, where the mesh is refined

    std::string name() const; ///< "Elements along span=31, Elements along chord=9"
  };

  /// An order that a user knows, "1", or bounds of it, "1:2"; none of an empty text. Throws InputError, naming the
  /// option, where it is neither, not above 0 or above 4.
  std::optional<OrderRange> read_orders(const std::string &text, const std::string &option);

  /// What h is, with its unit.
  std::string size_name(Refinement refinement);
  std::string size_unit(Refinement refinement);

  /// The case with sizes larger by `factor` (smaller: below one). Numbers of elements are rounded, and h is that of the
  /// rounded numbers: the root of the mean area; points through the thickness are the nearest odd number, h is one over
  /// it. Throws InputError for a case that has not what is to be refined.
  LadderLevel make_level(const CaseParameters &parameters, Refinement refinement, double factor);

  /// All levels, the coarsest first. Throws InputError for fewer than three levels or more than eight, a ratio of at
  /// most 1.05, two levels of the same size, time steps longer than the case's.
  std::vector<LadderLevel> make_ladder(const CaseParameters &parameters, const ConvergeRequest &request);

  /// How far meshes are apart whose elements are rounded, where that is not as far as their h, which is the particles';
  /// empty where it is.
  std::string describe_rounded_meshes(const std::vector<LadderLevel> &levels);

  /// Overrides by place of the lattice (report/study/lattice_places.h); one that is empty is the case as it stands.
  using LadderPlaces = std::vector<std::vector<std::string>>;

  /// The ladder as a study of the size, of several places of the place too, which runs faster.
  StudyPlan make_ladder_plan(Refinement refinement, const std::vector<LadderLevel> &levels, std::size_t n_places);
  std::vector<StudyPoint> make_ladder_points(const std::vector<LadderLevel> &levels, const LadderPlaces &places);
} // namespace birdstrike
