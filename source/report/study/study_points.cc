#include "report/study/study_points.h"
#include <birdstrike/core/errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <set>

namespace birdstrike
{
  namespace
  {
    void require_own_entries(const std::vector<VariedEntry> &entries)
    {
      if (entries.empty())
        throw InputError("Nothing is varied.\n  Action: --vary \"Section/Entry=v1, v2\" or \"Section/Entry=a:b:n\", or "
                         "Study/Vary 1 in the parameter file.");
      std::set<std::string> names;
      for (const VariedEntry &each : entries)
        {
          if (!names.insert(each.entry).second)
            throw InputError(each.entry + " is varied twice.\n  Action: give all its values once.");
          for (const std::string of_each_run : {"Output/Directory", "Case/Name"})
            if (each.entry == of_each_run || each.entry.starts_with("Study/"))
              throw InputError(each.entry +
                               " cannot be varied: the study itself gives each point its folder.\n  Action: vary "
                               "an entry of the case.");
        }
    }

    std::size_t count_points(const StudyPlan &plan)
    {
      double n = 1.;
      for (const std::size_t along : plan.shape())
        n *= static_cast<double>(along);
      if (n > static_cast<double>(most_points))
        throw InputError(fmt::format("{:.0f} points; at most {} make a study.\n  Action: fewer values, or several "
                                     "studies.",
                                     n, most_points));
      return static_cast<std::size_t>(n);
    }

    StudyPoint make_point(const StudyPlan &plan, const std::vector<std::size_t> &at)
    {
      StudyPoint point{"", "", at, {}};
      for (std::size_t e = 0; e < plan.entries.size(); ++e)
        {
          const std::string &value = plan.entries[e].values[at[e]];
          point.name += (e > 0 ? ", " : "") + plan.short_name(e) + "=" + value;
          point.overrides.push_back(plan.entries[e].entry + "=" + value);
        }
      point.folder = make_folder_name(point.name);
      return point;
    }

    void require_different(const std::vector<StudyPoint> &points)
    {
      std::set<std::string> names;
      for (const StudyPoint &point : points)
        if (!names.insert(point.name).second)
          throw InputError("The point " + point.name + " occurs twice.\n  Action: points of a study must differ.");
    }

    /// Texts that differ by blanks, commas and hyphens alone: each gets the hash of its own.
    void separate_folders(std::vector<StudyPoint> &points)
    {
      std::map<std::string, std::size_t> n_points;
      for (const StudyPoint &point : points)
        ++n_points[point.folder];
      for (StudyPoint &point : points)
        if (n_points[point.folder] > 1)
          point.folder = make_folder_name(point.name, true);
    }
  } // namespace

  std::vector<std::size_t> StudyPlan::shape() const
  {
    std::vector<std::size_t> n;
    for (const VariedEntry &each : entries)
      if (!are_pairs || n.empty())
        n.push_back(each.values.size());
    return n;
  }

  std::string StudyPlan::short_name(const std::size_t entry) const
  {
    const auto        last    = [](const std::string &path) { return path.substr(path.rfind('/') + 1); };
    const std::string name    = last(entries[entry].entry);
    const auto        is_same = [&](const VariedEntry &each) { return last(each.entry) == name; };
    return std::count_if(entries.begin(), entries.end(), is_same) > 1 ? entries[entry].entry : name;
  }

  StudyPlan read_study_plan(const std::vector<std::string> &vary, const bool are_pairs)
  {
    StudyPlan plan{{}, are_pairs};
    for (const std::string &text : vary)
      plan.entries.push_back(read_varied_entry(text, are_pairs && vary.size() > 1));
    require_own_entries(plan.entries);
    for (const VariedEntry &each : plan.entries)
      if (are_pairs && each.values.size() != plan.entries[0].values.size())
        throw InputError(
          fmt::format("Pairs need as many values of each entry: {} has {}, {} has {}.\n  Action: give as "
                      "many, or each with each (without --pairs).",
                      plan.entries[0].entry, plan.entries[0].values.size(), each.entry, each.values.size()));
    count_points(plan);
    return plan;
  }

  std::vector<StudyPoint> make_points(const StudyPlan &plan)
  {
    std::vector<StudyPoint> points;
    for (std::size_t k = 0; k < count_points(plan); ++k)
      {
        std::vector<std::size_t> at(plan.entries.size(), k);
        if (!plan.are_pairs)
          for (std::size_t e = at.size(), rest = k; e-- > 0; rest /= plan.entries[e].values.size())
            at[e] = rest % plan.entries[e].values.size();
        points.push_back(make_point(plan, at));
      }
    require_different(points);
    separate_folders(points);
    return points;
  }

  std::string make_folder_name(const std::string &text, const bool is_hashed)
  {
    constexpr std::size_t longest = 100;
    std::string           name;
    std::uint64_t         hash     = 14695981039346656037u;
    bool                  is_whole = !is_hashed;
    for (std::size_t k = 0; k < text.size(); ++k)
      {
        const auto letter = static_cast<unsigned char>(text[k]);
        hash              = (hash ^ letter) * 1099511628211u;
        const bool stays  = std::isalnum(letter) != 0 || std::string(".=+-_").find(text[k]) != std::string::npos;
        is_whole          = is_whole && (stays || letter == ' ' || letter == ',');
        if (stays || (!name.empty() && name.back() != '-'))
          name += stays ? text[k] : '-';
      }
    return is_whole && name.size() <= longest ? name : fmt::format("{}-{:08x}", name.substr(0, longest), hash >> 32);
  }
} // namespace birdstrike
