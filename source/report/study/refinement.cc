#include "report/study/refinement.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

namespace birdstrike
{
  namespace
  {
    constexpr std::size_t fewest_levels = 3, most_levels = 12;
    constexpr double      highest_order  = 4.;
    constexpr double      smallest_ratio = 1.05; ///< below, changes drown in what has no order; Celik et al.: 1.3

    bool refines_mesh(const Refinement refinement)
    {
      return refinement == Refinement::mesh || refinement == Refinement::both;
    }

    bool refines_bird(const Refinement refinement)
    {
      return refinement == Refinement::particles || refinement == Refinement::both;
    }

    void require_what_is_refined(const CaseParameters &parameters, const Refinement refinement)
    {
      const BladeParameters &blade = parameters.blade;
      if (refines_bird(refinement) && !parameters.bird.enabled)
        throw InputError("There is no bird whose particles could be refined.\n  Action: --vary mesh, step or points.");
      const bool is_one_facet = blade.kind == BladeKind::rigid && blade.rigid.surface == RigidSurface::rectangle;
      if (refines_mesh(refinement) &&
          (blade.kind == BladeKind::none || is_one_facet || blade.mesh.generator == MeshGenerator::file))
        throw InputError(std::string("There is no built-in blade whose mesh could be refined: ") +
                         (blade.kind == BladeKind::none ? "Blade/Kind is none"
                          : is_one_facet                ? "a rigid plate is one facet"
                                                        : "it comes from a file") +
                         ".\n  Action: --vary particles, or a study over Blade/Mesh/File with a finer file each.");
    }

    std::string set_number(const std::string &entry, const double value)
    {
      return entry + "=" + fmt::format("{:.6g}", value);
    }

    /// The odd number nearest to the case's over `factor`.
    LadderLevel make_points_level(const unsigned int of_case, const double factor)
    {
      const double number = 2. * std::round((of_case / factor - 1.) / 2.) + 1.;
      if (number < 3. || number > 15.)
        throw InputError(fmt::format("{:g} points through the thickness ({:g} times fewer than the case's {}).\n"
                                     "  Allowed: 3 to 15.\n  Action: fewer levels, another --ratio or --finer.",
                                     number, factor, of_case));
      return {1. / number, {set_number("Blade/Element/Points through thickness", number)}};
    }
  } // namespace

  const NamedChoices<Refinement> &refinements()
  {
    static const NamedChoices<Refinement> names{{"mesh", Refinement::mesh},
                                                {"particles", Refinement::particles},
                                                {"both", Refinement::both},
                                                {"step", Refinement::step},
                                                {"points", Refinement::points}};
    return names;
  }

  std::optional<OrderRange> read_orders(const std::string &text, const std::string &option)
  {
    if (text.empty())
      return std::nullopt;
    const std::size_t        colon = text.find(':');
    std::vector<std::string> parts{text.substr(0, colon)};
    std::vector<double>      orders;
    if (colon != std::string::npos)
      parts.push_back(text.substr(colon + 1));
    for (const std::string &part : parts)
      {
        double            value = 0.;
        const char *const last  = part.data() + part.size();
        const auto [end, error] = std::from_chars(part.data(), last, value);
        if (error == std::errc() && end == last && value > 0. && value <= highest_order)
          orders.push_back(value);
      }
    if (orders.size() != parts.size() || orders.front() > orders.back())
      throw InputError(
        fmt::format("{} {}.\n  Allowed: above 0, at most {:g}, or bounds as 1:2. Take the order of a longer ladder.",
                    option, text, highest_order));
    return OrderRange{orders.front(), orders.back()};
  }

  std::string LadderLevel::name() const
  {
    std::string text;
    for (const std::string &each : overrides)
      text += (text.empty() ? "" : ", ") + each.substr(each.rfind('/', each.find('=')) + 1);
    return text;
  }

  std::string size_name(const Refinement refinement)
  {
    static const std::map<Refinement, std::string> names{{Refinement::mesh, "size of an element"},
                                                         {Refinement::particles, "particle spacing"},
                                                         {Refinement::both, "particle spacing, mesh with it"},
                                                         {Refinement::step, "time step over the case's"},
                                                         {Refinement::points, "one over points through the thickness"}};
    return names.at(refinement);
  }

  std::string size_unit(const Refinement refinement)
  {
    return refines_mesh(refinement) || refines_bird(refinement) ? "m" : "-";
  }

  LadderLevel make_level(const CaseParameters &parameters, const Refinement refinement, const double factor)
  {
    require_what_is_refined(parameters, refinement);
    if (refinement == Refinement::points)
      return make_points_level(parameters.blade.element.n_points, factor);
    LadderLevel level{factor, {}, 0.};
    if (refines_mesh(refinement))
      {
        const MeshParameters &mesh   = parameters.blade.mesh;
        const double          pair   = parameters.has_symmetry_plane ? 2. : 1.; // halves are cut between elements
        const double          n_span = std::max(1., std::round(mesh.n_span / factor)),
                     n_chord         = pair * std::max(1., std::round(mesh.n_chord / (pair * factor)));
        level.overrides              = {set_number("Blade/Mesh/Elements along span", n_span),
                                        set_number("Blade/Mesh/Elements along chord", n_chord)};
        level.size = level.mesh_size = std::sqrt(mesh.length * mesh.chord / (n_span * n_chord));
      }
    if (refines_bird(refinement))
      {
        const auto refined = [&](const BirdParameters &bird) { // as it is set
          return std::stod(fmt::format("{:.6g}", bird.spacing * factor));
        };
        level.size = refined(parameters.bird);
        for (const BirdCase &each : parameters.birds())
          level.overrides.push_back(set_number(each.bird.section + "/Particle spacing", refined(each.bird)));
      }
    if (refinement == Refinement::step)
      level.overrides = {set_number("Time/Step scale", parameters.time.step_scale * factor),
                         set_number("Time/Bird step scale", parameters.time.bird_step_scale * factor)};
    return level;
  }

  std::vector<LadderLevel> make_ladder(const CaseParameters &parameters, const ConvergeRequest &request)
  {
    const Refinement  refinement = refinements().at(request.refinement);
    const std::size_t n          = request.n_levels;
    if (n < fewest_levels || n > most_levels)
      throw InputError(
        fmt::format("{} levels.\n  Allowed: {} to {}; an order is that of three.", n, fewest_levels, most_levels));
    if (!(request.ratio > smallest_ratio) || !(request.ratio <= 10.))
      throw InputError(
        fmt::format("A ratio of {:g} from level to level.\n  Allowed: above {:g}, at most 10; at least 1.3 "
                    "is wise.",
                    request.ratio, smallest_ratio));
    std::vector<LadderLevel> levels;
    const double             coarsest = refinement == Refinement::step ? 0. : static_cast<double>(n - 1);
    for (std::size_t k = 0; k < n; ++k)
      levels.push_back(make_level(parameters, refinement,
                                  std::pow(request.ratio, coarsest - static_cast<double>(k + request.n_finer))));
    for (std::size_t k = 1; k < n; ++k)
      if (!(levels[k].size < levels[k - 1].size) ||
          (refines_mesh(refinement) && !(levels[k].mesh_size < levels[k - 1].mesh_size)))
        throw InputError("Two levels are the same: " + levels[k].name() +
                         ".\n  Action: a larger --ratio, or a finer mesh in the case.");
    return levels;
  }

  std::string describe_rounded_meshes(const std::vector<LadderLevel> &levels)
  {
    constexpr double as_far = 0.05; // of a ratio
    std::string      ratios;
    bool             is_rounded = false;
    for (std::size_t k = 1; k < levels.size() && levels[k].mesh_size > 0.; ++k)
      {
        const double of_mesh = levels[k - 1].mesh_size / levels[k].mesh_size,
                     of_h    = levels[k - 1].size / levels[k].size;
        is_rounded           = is_rounded || std::abs(of_mesh / of_h - 1.) > as_far;
        ratios += fmt::format("{}{:.2f}", ratios.empty() ? "" : ", ", of_mesh);
      }
    return is_rounded ? "Elements are whole: sizes of the meshes are " + ratios + " apart, h is the particles'.\n" : "";
  }

  StudyPlan make_ladder_plan(const Refinement refinement, const std::vector<LadderLevel> &levels,
                             const std::size_t n_places)
  {
    VariedEntry size{size_name(refinement), size_unit(refinement), {}, {}};
    for (const LadderLevel &level : levels)
      {
        size.numbers.push_back(level.size);
        size.values.push_back(fmt::format("{}", level.size));
      }
    if (n_places == 1)
      return {{size}, false};
    VariedEntry place{"place of the lattice", "-", {}, {}};
    for (std::size_t k = 1; k <= n_places; ++k)
      {
        place.numbers.push_back(static_cast<double>(k));
        place.values.push_back(fmt::format("{}", k));
      }
    return {{size, place}, false};
  }

  std::vector<StudyPoint> make_ladder_points(const std::vector<LadderLevel> &levels, const LadderPlaces &places)
  {
    std::vector<StudyPoint> points;
    for (std::size_t l = 0; l < levels.size(); ++l)
      for (std::size_t k = 0; k < places.size(); ++k)
        {
          LadderLevel of_place = levels[l];
          of_place.overrides.insert(of_place.overrides.end(), places[k].begin(), places[k].end());
          std::vector<std::size_t> at{l};
          if (places.size() > 1)
            at.push_back(k);
          points.push_back({of_place.name(), make_folder_name(of_place.name()), at, of_place.overrides});
        }
    return points;
  }
} // namespace birdstrike
