#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace birdstrike
{
  /// The names by which a mesh calls boundary ids, material ids or parts: groups and sets of its file, or the parts of
  /// the built-in blade. Where sets overlap one name stands for several ids, and an id has several names. Blanks and
  /// the separators of lists (, ; : |) in a name are written as '_'. A name whose letters differ in their case only is
  /// understood too. A name that two sets share is refused unless both stand for the same ids.
  class NamedIds
  {
  public:
    enum class Of
    {
      boundaries,
      materials,
      parts
    };
    explicit NamedIds(const Of of = Of::boundaries) : of(of)
    {
    }

    /// One set of the file.
    struct Meaning
    {
      std::vector<std::string>  names;      ///< from the shortest on; a number takes the place of the id
      std::vector<unsigned int> ids;        ///< none: known, but nothing of the mesh lies in it
      std::string               not_read{}; ///< says where it stands and why it is not read
    };
    void add(Meaning meaning);
    void add(const std::string &name, const std::vector<unsigned int> &ids)
    {
      add(Meaning{{name}, ids});
    }

    /// "root, 2" -> ids, sorted, each once. Throws InputError for a name that is not there, naming those that are, for
    /// one that means several sets, naming these, for one without ids and for one that is not read.
    std::vector<unsigned int> parse(const std::string &text, const std::string &entry) const;

    /// Of a name that stands for a set of nodes: how many of the mesh it has, and the ids of those that lie on no side
    /// of the boundary that belongs to it. What holds its sides holds none of these.
    struct Nodes
    {
      std::size_t               n = 0;
      std::vector<std::int64_t> off_sides{};
    };
    void         add_nodes(std::string name, const Nodes &nodes); ///< to those that it has
    const Nodes *nodes_of(const std::string &name) const;         ///< null: of none are known

    bool knows(const std::string &name) const;
    bool has_names() const;            ///< that are no numbers
    bool names(unsigned int id) const; ///< whether some name stands for it

    std::string list() const; ///< "root, tip", without those that are numbers; "none"

  private:
    using Places = std::vector<std::size_t>; ///< of meanings

    Places                           find(const std::string &name) const;
    const Meaning                   &meaning_of(const std::string &name, const std::string &entry) const;
    bool                             is_same(std::size_t one, std::size_t other) const;
    std::string                      shortest_name(std::size_t place) const; ///< that means nothing else
    const std::vector<unsigned int> &ids_of(const std::string &name, const std::string &entry) const;

    Of                            of;
    std::vector<Meaning>          meanings;
    std::map<std::string, Places> places, places_in_lower_case;
    std::map<std::string, Nodes>  all_nodes; ///< by names in lower case
  };

  /// 0 root, 1 tip, 2 leading_edge, 3 trailing_edge; of a body also 5 lower_face and 6 upper_face, on the side of minus
  /// and plus the normal.
  const NamedIds &built_in_boundaries();
} // namespace birdstrike
