#include "parts.h"

#include <cstdio>
#include <fstream>
#include <iostream>

/// An archive holds elements, not registers: a build of one register width reads what another has written and goes on.
///
///   archive_width write FILE   takes some steps, writes the state, takes more, writes again
///   archive_width read FILE    reads the first state, takes the same steps more and compares with the second
namespace
{
  using namespace archive_width;

  constexpr unsigned int n_before = 60, n_after = 40;

  /// Largest difference over the largest value of a quantity. Registers of another width add up in another order:
  /// 1e-16 a step, which grows to 1e-13 where hourglass stresses are differences of larger ones (measured with 4 and 8
  /// lanes); an element that goes on from another's state differs by 1e-3 or more.
  constexpr double tolerance = 1e-11;

  template <class T>
  void put(std::ostream &out, const std::vector<T> &values)
  {
    out << values.size();
    for (const T value : values)
      if constexpr (std::is_same_v<T, double>)
        {
          char text[40];
          std::snprintf(text, sizeof text, " %a", value);
          out << text;
        }
      else
        out << ' ' << value;
    out << '\n';
  }

  template <class T>
  std::vector<T> get(std::istream &in)
  {
    std::size_t n = 0;
    in >> n;
    std::vector<T> values(n);
    std::string    word;
    for (T &value : values)
      {
        in >> word;
        if constexpr (std::is_same_v<T, double>)
          value = std::strtod(word.c_str(), nullptr);
        else
          value = std::stoull(word);
      }
    return values;
  }

  void put(std::ostream &out, const ArchivedState &state)
  {
    out << state.size() << '\n';
    for (const auto &[name, quantity] : state)
      {
        out << name << '\n' << quantity.is_real << ' ' << quantity.n_components << '\n';
        put(out, quantity.real);
        put(out, quantity.whole);
        put(out, quantity.lengths);
      }
  }

  ArchivedState get_state(std::istream &in)
  {
    ArchivedState state;
    std::size_t   n = 0;
    in >> n;
    for (std::size_t k = 0; k < n; ++k)
      {
        std::string name;
        std::getline(in >> std::ws, name);
        ArchivedQuantity &quantity = state[name];
        in >> quantity.is_real >> quantity.n_components;
        quantity.real    = get<double>(in);
        quantity.whole   = get<std::uint64_t>(in);
        quantity.lengths = get<std::uint64_t>(in);
      }
    return state;
  }

  /// Compares real quantities entity by entity, those that both states have: batches of another width promote other
  /// elastic elements to points. Of the sums that elements hold for their registers, the total.
  bool compare(const std::string &name, const ArchivedState &one, const ArchivedState &other)
  {
    const ArchivedQuantity              &a = one.at(name), &b = other.at(name);
    const auto                           population = name.substr(0, name.rfind('/'));
    std::map<std::uint64_t, std::size_t> place;
    const bool                           has_ids = one.contains(population);
    if (has_ids)
      for (std::size_t i = 0; i < other.at(population).whole.size(); ++i)
        place[other.at(population).whole[i]] = i;
    const std::size_t n    = std::max<std::size_t>(a.n_components, 1);
    double            size = 0., difference = 0., sum_a = 0., sum_b = 0.;
    for (std::size_t k = 0; k < a.real.size(); ++k)
      {
        size = std::max(size, std::abs(a.real[k]));
        sum_a += a.real[k];
        const auto at = has_ids ? place.find(one.at(population).whole[k / n]) : place.end();
        if (has_ids ? at == place.end() : k >= b.real.size())
          continue;
        difference = std::max(difference, std::abs(a.real[k] - b.real[has_ids ? n * at->second + k % n : k]));
      }
    for (const double value : b.real)
      sum_b += value;
    if (population.ends_with("dissipation") && has_ids)
      difference = std::abs(sum_a - sum_b);
    if (difference <= tolerance * size)
      return true;
    std::cout << name << ": differs by " << difference << " of " << size << '\n';
    return false;
  }

  bool is_bound_of_a_search(const std::string &name)
  {
    return name.find("/search/") != std::string::npos;
  }
} // namespace

int main(const int argc, char **argv)
{
  const std::string verb = argc == 3 ? argv[1] : "";
  Parts             parts;
  if (verb == "write")
    {
      std::ofstream out(argv[2]);
      parts.advance(0, n_before);
      put(out, parts.write());
      parts.advance(n_before, n_after);
      put(out, parts.write());
      std::cout << "written with " << n_lanes << " lanes\n";
      return out ? 0 : 1;
    }
  if (verb != "read")
    {
      std::cerr << "archive_width write FILE | archive_width read FILE\n";
      return 2;
    }
  std::ifstream       in(argv[2]);
  const ArchivedState first = get_state(in), second = get_state(in);
  Archive             archive = Archive::reading(first);
  parts.archive(archive);
  archive.finish();
  parts.advance(n_before, n_after);
  const ArchivedState again      = parts.write();
  bool                is_same    = !first.empty();
  std::size_t         n_compared = 0;
  for (const auto &[name, quantity] : second)
    if (quantity.is_real && !is_bound_of_a_search(name))
      {
        is_same = compare(name, second, again) && is_same;
        ++n_compared;
      }
    else if (name.ends_with("/failed") && quantity.whole != again.at(name).whole)
      {
        std::cout << name << ": differs\n";
        is_same = false;
      }
  std::cout << "read with " << n_lanes << " lanes, " << n_compared << " quantities compared\n";
  return is_same ? 0 : 1;
}
