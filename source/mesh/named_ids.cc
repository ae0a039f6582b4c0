#include <birdstrike/core/errors.h>
#include <birdstrike/core/text_lists.h>
#include <birdstrike/mesh/named_ids.h>

#include <algorithm>
#include <cctype>
#include <set>

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
    std::string as_written_in_lists(std::string name)
    {
      std::replace_if(
        name.begin(), name.end(),
        [](const unsigned char c) { return std::isspace(c) || c == ',' || c == ';' || c == ':' || c == '|'; }, '_');
      return name;
    }

    std::string joined(const std::set<std::string> &words)
    {
      std::string text;
      for (const std::string &word : words)
        text += (text.empty() ? "" : ", ") + word;
      return text;
    }

    const std::map<NamedIds::Of, const char *> nouns{
      {NamedIds::Of::boundaries, "boundary"}, {NamedIds::Of::materials, "material"}, {NamedIds::Of::parts, "part"}};
  } // namespace

  void NamedIds::add(Meaning meaning)
  {
    std::sort(meaning.ids.begin(), meaning.ids.end());
    for (std::string &name : meaning.names)
      {
        name = as_written_in_lists(std::move(name));
        places[name].push_back(meanings.size());
        places_in_lower_case[lower(name)].push_back(meanings.size());
      }
    meanings.push_back(std::move(meaning));
  }

  void NamedIds::add_nodes(std::string name, const Nodes &nodes)
  {
    Nodes &all = all_nodes[lower(as_written_in_lists(std::move(name)))];
    all.n += nodes.n;
    all.off_sides.insert(all.off_sides.end(), nodes.off_sides.begin(), nodes.off_sides.end());
  }

  const NamedIds::Nodes *NamedIds::nodes_of(const std::string &name) const
  {
    const auto found = all_nodes.find(lower(name));
    return found != all_nodes.end() ? &found->second : nullptr;
  }

  NamedIds::Places NamedIds::find(const std::string &name) const
  {
    if (const auto found = places.find(name); found != places.end())
      return found->second;
    const auto found = places_in_lower_case.find(lower(name));
    return found != places_in_lower_case.end() ? found->second : Places();
  }

  bool NamedIds::knows(const std::string &name) const
  {
    return !find(name).empty();
  }

  bool NamedIds::is_same(const std::size_t one, const std::size_t other) const
  {
    return meanings[one].ids == meanings[other].ids && meanings[one].not_read == meanings[other].not_read;
  }

  std::string NamedIds::shortest_name(const std::size_t place) const
  {
    for (const std::string &name : meanings[place].names)
      if (const Places found = find(name);
          std::all_of(found.begin(), found.end(), [&](const std::size_t other) { return is_same(place, other); }))
        return name;
    return meanings[place].names.back();
  }

  const NamedIds::Meaning &NamedIds::meaning_of(const std::string &name, const std::string &entry) const
  {
    const Places found = find(name);
    if (found.empty())
      throw InputError(
        entry + ": the mesh has no " + nouns.at(of) + " '" + name + "'.\nNames in this mesh: " + list() +
        (of == Of::parts ? "." : "; or give an id, a whole number.") +
        (meanings.empty() ? "\nName them in the mesh program, e.g. in Gmsh: Physical Curve(\"root\") = {1};" : ""));
    if (!std::all_of(found.begin(), found.end(), [&](const std::size_t place) { return is_same(found[0], place); }))
      {
        std::set<std::string> all;
        for (const std::size_t place : found)
          all.insert(shortest_name(place));
        throw InputError(entry + ": '" + name +
                         "' means several sets of the mesh.\nGive the one that is meant: " + joined(all) + ".");
      }
    return meanings[found[0]];
  }

  const std::vector<unsigned int> &NamedIds::ids_of(const std::string &name, const std::string &entry) const
  {
    const Meaning &meaning = meaning_of(name, entry);
    if (!meaning.not_read.empty())
      throw InputError(entry + ": the set '" + name + "' is not read.\n" + meaning.not_read);
    if (meaning.ids.empty())
      throw InputError(entry + ": no " + (of == Of::boundaries ? "side on the boundary" : "cell") +
                       " of the mesh lies in '" + name + "' with all its nodes.\nNames in this mesh: " + list() + ".");
    return meaning.ids;
  }

  std::vector<unsigned int> NamedIds::parse(const std::string &text, const std::string &entry) const
  {
    std::vector<unsigned int> all;
    for (const std::string &word : parse_words(text))
      {
        const bool is_id = of != Of::parts && is_number(word) && !knows(word);
        const auto more  = is_id ? parse_ids(word, entry) : ids_of(word, entry);
        all.insert(all.end(), more.begin(), more.end());
      }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  bool NamedIds::has_names() const
  {
    return std::any_of(places.begin(), places.end(), [](const auto &named) { return !is_number(named.first); });
  }

  bool NamedIds::names(const unsigned int id) const
  {
    return std::any_of(meanings.begin(), meanings.end(), [id](const Meaning &meaning) {
      return std::binary_search(meaning.ids.begin(), meaning.ids.end(), id);
    });
  }

  std::string NamedIds::list() const
  {
    std::set<std::string> all;
    for (std::size_t place = 0; place < meanings.size(); ++place)
      if (const std::string name = shortest_name(place); meanings[place].not_read.empty() && !is_number(name))
        all.insert(name);
    return all.empty() ? "none" : joined(all);
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
