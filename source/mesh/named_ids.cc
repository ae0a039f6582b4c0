#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/named_ids.h>

#include <algorithm>
#include <cctype>

namespace birdstrike
{
  namespace
  {
    bool is_number(const std::string &word)
    {
      return word.find_first_not_of("0123456789") == std::string::npos;
    }

    std::string lower(std::string word)
    {
      std::transform(word.begin(), word.end(), word.begin(), [](const unsigned char c) { return std::tolower(c); });
      return word;
    }
  } // namespace

  void NamedIds::add(std::string name, const std::vector<unsigned int> &ids)
  {
    std::replace_if(
      name.begin(), name.end(),
      [](const unsigned char c) { return std::isspace(c) || c == ',' || c == ';' || c == ':' || c == '|'; }, '_');
    auto &all = ids_of[name];
    all.insert(all.end(), ids.begin(), ids.end());
  }

  const std::vector<unsigned int> *NamedIds::find(const std::string &name) const
  {
    if (const auto found = ids_of.find(name); found != ids_of.end())
      return &found->second;
    for (const auto &[other, ids] : ids_of)
      if (lower(other) == lower(name))
        return &ids;
    return nullptr;
  }

  std::vector<unsigned int> NamedIds::parse(const std::string &text, const std::string &entry) const
  {
    const bool                is_boundary = of == Of::boundaries;
    std::vector<unsigned int> all;
    for (const std::string &word : parse_words(text))
      {
        const auto *ids = find(word);
        if (ids == nullptr && !is_number(word))
          throw InputError(entry + ": the mesh has no " + (is_boundary ? "boundary" : "material") + " '" + word +
                           "'.\nNames in this mesh: " + list() + "; or give an id, a whole number.");
        if (ids != nullptr && ids->empty())
          throw InputError(entry + ": no " + (is_boundary ? "side on the boundary" : "cell") +
                           " of the mesh lies in '" + word + "' with all its nodes.\nNames in this mesh: " + list() +
                           ".");
        const auto more = ids != nullptr ? *ids : parse_ids(word, entry);
        all.insert(all.end(), more.begin(), more.end());
      }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  bool NamedIds::has_names() const
  {
    return std::any_of(ids_of.begin(), ids_of.end(), [](const auto &named) { return !is_number(named.first); });
  }

  bool NamedIds::names(const unsigned int id) const
  {
    return std::any_of(ids_of.begin(), ids_of.end(), [&](const auto &named) {
      return std::find(named.second.begin(), named.second.end(), id) != named.second.end();
    });
  }

  std::string NamedIds::list() const
  {
    std::string names;
    for (const auto &[name, ids] : ids_of)
      if (!is_number(name))
        names += (names.empty() ? "" : ", ") + name;
    return names.empty() ? "none" : names;
  }

  const NamedIds &built_in_boundaries()
  {
    static const NamedIds names = [] {
      NamedIds     all;
      unsigned int id = 0;
      for (const char *name : {"root", "tip", "leading_edge", "trailing_edge"})
        all.add(name, {id++});
      all.add("lower_face", {5});
      all.add("upper_face", {6});
      return all;
    }();
    return names;
  }
} // namespace birdstrike
