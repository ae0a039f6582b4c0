#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/structure/laminate_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace birdstrike
{
  namespace
  {
    using dealii::Utilities::trim;

    constexpr std::size_t most_plies = 1000;

    [[noreturn]] void refuse(const std::string &where, const std::string &piece)
    {
      throw InputError(where + "Plies: cannot read '" + piece +
                       "'.\nAllowed: angles in degrees with thicknesses, '0: 0.125 mm; 45: 0.125 mm', angles of equal "
                       "plies, '0; 45; -45; 90', or a stacking code, '[0/45/-45/90]2s', with 0_3 for three plies and "
                       "+-45 for two.");
    }

    double read_angle(const std::string &text, const std::string &where)
    {
      if (!dealii::Patterns::Double(-360., 360.).match(text))
        refuse(where, text);
      return dealii::Utilities::string_to_double(text);
    }

    /// "3" of "0_3"; at least 1.
    std::size_t read_count(const std::string &text, const std::string &where)
    {
      if (!dealii::Patterns::Integer(1, most_plies).match(text))
        refuse(where, text);
      return dealii::Utilities::string_to_int(text);
    }

    /// "0_2/+-45" -> 0, 0, 45, -45.
    std::vector<double> read_stack(const std::string &text, const std::string &where)
    {
      std::vector<double> angles;
      for (const std::string &piece : dealii::Utilities::split_string_list(text, '/'))
        {
          const std::size_t underline = std::min(piece.find('_'), piece.size());
          const std::string one       = trim(piece.substr(0, underline));
          const bool        is_pair   = one.starts_with("+-");
          const double      angle     = read_angle(is_pair ? one.substr(2) : one, where);
          const std::size_t n = underline < piece.size() ? read_count(trim(piece.substr(underline + 1)), where) : 1;
          for (std::size_t k = 0; k < n && angles.size() <= most_plies; ++k)
            {
              angles.push_back(angle);
              if (is_pair)
                angles.push_back(-angle);
            }
        }
      return angles;
    }

    /// "[...]2s"
    std::vector<PlyLayer> read_code(const std::string &text, const std::string &where)
    {
      const std::size_t close = text.find(']');
      if (close == std::string::npos)
        refuse(where, text);
      std::string repeat       = trim(text.substr(close + 1));
      const bool  is_symmetric = repeat.ends_with('s');
      if (is_symmetric)
        repeat.pop_back();
      const std::size_t         n   = repeat.empty() ? 1 : read_count(trim(repeat), where);
      const std::vector<double> one = read_stack(text.substr(1, close - 1), where);
      std::vector<double>       angles;
      for (std::size_t k = 0; k < n && angles.size() <= most_plies; ++k)
        angles.insert(angles.end(), one.begin(), one.end());
      if (is_symmetric)
        {
          const std::vector<double> half = angles;
          angles.insert(angles.end(), half.rbegin(), half.rend());
        }
      std::vector<PlyLayer> layers;
      for (const double angle : angles)
        layers.push_back({angle, 1.});
      return layers;
    }

    std::vector<PlyLayer> read_list(const std::string &text, const std::string &where)
    {
      std::vector<PlyLayer> layers;
      std::size_t           n_with_thickness = 0;
      for (const std::string &piece : dealii::Utilities::split_string_list(text, ';'))
        {
          const std::size_t colon = piece.find(':');
          layers.push_back({read_angle(trim(piece.substr(0, colon)), where), 1.});
          if (colon == std::string::npos)
            continue;
          const std::string thickness = trim(piece.substr(colon + 1));
          if (!dealii::Patterns::Double(1e-30, 1e30).match(thickness))
            refuse(where, piece);
          layers.back().share = dealii::Utilities::string_to_double(thickness);
          ++n_with_thickness;
        }
      if (n_with_thickness > 0 && n_with_thickness < layers.size())
        throw InputError(where + "Plies: some plies have a thickness and some have none.\nGive all of them one, or "
                                 "none: then they are equal.");
      return layers;
    }
  } // namespace

  LaminateParameters LaminateParameters::of_blade()
  {
    LaminateParameters result;
    result.reference_direction = "1 0 0";
    result.n_per_ply           = 1;
    result.n_degradation_steps = 100;
    result.failed_share        = 1.;
    return result;
  }

  bool LaminateParameters::is_given() const
  {
    return !trim(plies).empty();
  }

  LaminateParameters LaminateParameters::with_others(const LaminateParameters &blade) const
  {
    LaminateParameters result = *this;
    result.ply                = birdstrike::with_others(ply, blade.ply);
    const auto fill           = [](auto &value, const auto &other) {
      if (value == std::decay_t<decltype(value)>())
        value = other;
    };
    fill(result.reference_direction, blade.reference_direction);
    fill(result.n_per_ply, blade.n_per_ply);
    fill(result.n_degradation_steps, blade.n_degradation_steps);
    fill(result.failed_share, blade.failed_share);
    fill(result.smallest_step, blade.smallest_step);
    return result;
  }

  void LaminateParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.add_parameter(
      "Plies", plies,
      "Makes shells a laminate: angles of its plies in degrees from the bottom (the side that the normal leaves) to "
      "the top, with thicknesses, '0: 0.125 mm; 45: 0.25 mm', or equal ones by a stacking code, '[0/45/-45/90]2s', "
      "'[0_2/+-45]s'. Thicknesses count by their shares of the sum: how thick the blade is says Thickness, and tapered "
      "blades have tapered plies. Empty: a metal. [m]",
      Patterns::Anything());
    prm.add_parameter("Reference direction", reference_direction,
                      "Global direction 'x y z' that the angles are counted from, projected on each element at the "
                      "start, counter-clockwise about the normal; empty: the blade's. [-]",
                      Patterns::Anything());
    prm.add_parameter("Points per ply", n_per_ply,
                      "At how many places through each ply its failure is decided; stiffness is exact with one. 0: the "
                      "blade's. [-]",
                      Patterns::Integer(0, 20));
    declare_ply(prm, ply);
    prm.add_parameter("Degradation steps", n_degradation_steps,
                      "Time steps in which a ply that fails loses what its mode takes; 0: the blade's. [-]",
                      Patterns::Integer(0, 100000));
    prm.add_parameter(
      "Failed share", failed_share,
      "Share of an element's plies whose fibres must have failed before all of it is taken away; 0: the "
      "blade's. [-]",
      Patterns::Double(0., 1.));
    prm.add_parameter("Smallest step", smallest_step,
                      "Where plies can fail, an element is also taken away when its stable step falls below this share "
                      "of what it was at first, or when it is turned inside out; 0: never (in a section: the blade's). "
                      "[-]",
                      Patterns::Double(0., 0.9));
  }

  std::vector<PlyLayer> LaminateParameters::layers(const std::string &where) const
  {
    const std::string     text   = trim(plies);
    std::vector<PlyLayer> result = text.starts_with('[') ? read_code(text, where) : read_list(text, where);
    if (result.empty() || result.size() > most_plies)
      throw InputError(where + "Plies: " + std::to_string(result.size()) + " plies were read.\nAllowed: 1 to " +
                       std::to_string(most_plies) + ".");
    double sum = 0.;
    for (const PlyLayer &layer : result)
      sum += layer.share;
    for (PlyLayer &layer : result)
      layer.share /= sum;
    return result;
  }

  std::array<double, 3> LaminateParameters::reference(const std::string &where) const
  {
    const auto numbers = parse_numbers(reference_direction, 3, where + "Reference direction");
    if (!(std::hypot(numbers[0], numbers[1], numbers[2]) > 0.))
      throw InputError(where + "Reference direction: it has no length.\nAllowed: any three numbers that are not all "
                               "zero, '1 0 0' along the span of built-in blades.");
    return {{numbers[0], numbers[1], numbers[2]}};
  }

  void LaminateParameters::check(const std::string &where) const
  {
    layers(where);
    reference(where);
    check_ply(ply, where);
    if (smallest_step > 0. && !ply.strength.can_fail())
      throw InputError(where + "Smallest step is given, but no strength: no element of such plies is taken away.\nGive "
                               "the strengths, or set Smallest step = 0.");
  }

  bool LaminateParameters::is_symmetric_about_y() const
  {
    const auto   d        = reference();
    const double in_plane = std::hypot(d[0], d[2]), along = std::abs(d[1]), small = 1e-9 * (in_plane + along);
    const auto   all = layers();
    return (in_plane <= small || along <= small) && std::all_of(all.begin(), all.end(), [](const PlyLayer &layer) {
             return std::abs(std::remainder(layer.angle, 90.)) < 1e-9;
           });
  }

  std::string describe(const LaminateParameters &laminate)
  {
    const std::string text = trim(laminate.plies);
    return fmt::format("{} plies{}, {}", laminate.layers().size(), text.starts_with('[') ? ", " + text : "",
                       describe(laminate.ply));
  }
} // namespace birdstrike
