#include <birdstrike/core/errors.h>
#include <birdstrike/structure/laminate_parameters.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>

// What Laminate/Plies says.
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
                       "plies, '0; 45; -45; 90', both with the name of a material, '0: 0.125 mm: carbon', '0: carbon', "
                       "or a stacking code, '[0/45/-45/90]2s', with 0_3 for three plies and "
                       "+-45 for two.");
    }

    [[noreturn]] void refuse_name(const std::string &name, const std::string &piece,
                                  const std::array<PlyMaterial, 4> &all, const std::string &where)
    {
      std::string names;
      for (const PlyMaterial &material : all)
        if (!trim(material.name).empty())
          names += (names.empty() ? "" : ", ") + trim(material.name);
      throw InputError(where + "Plies: '" + name + "' in '" + trim(piece) + "' is no thickness, and no material of " +
                       "Blade/Laminate (Material 1/Name, ...)" + (names.empty() ? "" : "; there are " + names) +
                       ".\nGive its constants there. Plies are elastic until they fail: a metal that yields is none.");
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

    /// Place of the material in `used`, where it is put if this is the first ply of it.
    std::size_t find_material(const std::string &name, const std::string &piece, const LaminateParameters &laminate,
                              const std::string &where, std::vector<PlyMaterial> &used)
    {
      const auto is_it = [&](const PlyMaterial &material) { return trim(material.name) == name; };
      const auto known = std::find_if(used.begin(), used.end(), is_it);
      if (known != used.end())
        return known - used.begin();
      const auto &all   = laminate.materials;
      const auto  found = std::find_if(all.begin(), all.end(), is_it);
      if (name.empty())
        used.push_back({"", "", laminate.ply});
      else if (found != all.end())
        used.push_back({name, "Material " + std::to_string(found - all.begin() + 1) + "/", found->ply});
      else
        refuse_name(name, piece, all, where);
      return used.size() - 1;
    }

    bool is_thickness(const std::string &text)
    {
      return dealii::Patterns::Double(1e-30, 1e30).match(text);
    }

    /// "angle", "angle: thickness", "angle: material" or "angle: thickness: material", each ply.
    PlyStack read_list(const std::string &text, const LaminateParameters &laminate, const std::string &where)
    {
      PlyStack    stack;
      std::size_t n_with_thickness = 0;
      for (const std::string &piece : dealii::Utilities::split_string_list(text, ';'))
        {
          std::vector<std::string> parts = dealii::Utilities::split_string_list(piece, ':');
          if (parts.empty() || parts.size() > 3)
            refuse(where, piece);
          stack.layers.push_back({read_angle(parts[0], where), 1.});
          std::string name;
          if (parts.size() == 3 || (parts.size() == 2 && !dealii::Patterns::Double().match(parts[1])))
            {
              name = parts.back();
              parts.pop_back();
            }
          stack.layers.back().material = find_material(name, piece, laminate, where, stack.materials);
          if (parts.size() == 1)
            continue;
          if (!is_thickness(parts[1]))
            refuse(where, piece);
          stack.layers.back().share = dealii::Utilities::string_to_double(parts[1]);
          ++n_with_thickness;
        }
      if (n_with_thickness > 0 && n_with_thickness < stack.layers.size())
        throw InputError(where + "Plies: some plies have a thickness and some have none.\nGive all of them one, or "
                                 "none: then they are equal.");
      return stack;
    }
  } // namespace

  PlyStack LaminateParameters::stack(const std::string &where) const
  {
    const std::string text = trim(plies);
    PlyStack          stack =
      text.starts_with('[') ? PlyStack{read_code(text, where), {{"", "", ply}}} : read_list(text, *this, where);
    if (stack.layers.empty() || stack.layers.size() > most_plies)
      throw InputError(where + "Plies: " + std::to_string(stack.layers.size()) + " plies were read.\nAllowed: 1 to " +
                       std::to_string(most_plies) + ".");
    double sum = 0.;
    for (const PlyLayer &layer : stack.layers)
      sum += layer.share;
    for (PlyLayer &layer : stack.layers)
      layer.share /= sum;
    return stack;
  }
} // namespace birdstrike
