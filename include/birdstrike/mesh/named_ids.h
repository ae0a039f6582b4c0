#pragma once

#include <map>
#include <string>
#include <vector>

namespace birdstrike
{
  /// The names by which a mesh calls boundary ids or material ids: groups and sets of its file, or the parts of the
  /// built-in blade. Where sets overlap one name stands for several ids, and an id has several names. Blanks and the
  /// separators of lists (, ; : |) in a name are written as '_'. A name whose letters differ in their case only is
  /// understood too.
  class NamedIds
  {
  public:
    enum class Of
    {
      boundaries,
      materials
    };
    explicit NamedIds(const Of of = Of::boundaries) : of(of)
    {
    }

    /// Adds ids to those of a name; none: the name is known, but nothing of the mesh lies in it. A number as a name
    /// takes the place of the id.
    void add(std::string name, const std::vector<unsigned int> &ids);

    /// "root, 2" -> ids, sorted, each once. Throws InputError for a name that is not there, naming those that are, and
    /// for one without ids.
    std::vector<unsigned int> parse(const std::string &text, const std::string &entry) const;

    bool has_names() const;            ///< that are no numbers
    bool names(unsigned int id) const; ///< whether some name stands for it

    std::string list() const; ///< "root, tip", without those that are numbers; "none"

  private:
    const std::vector<unsigned int> *find(const std::string &name) const;

    Of                                               of;
    std::map<std::string, std::vector<unsigned int>> ids_of;
  };

  /// 0 root, 1 tip, 2 leading_edge, 3 trailing_edge; of a body also 5 lower_face and 6 upper_face, on the side of minus
  /// and plus the normal.
  const NamedIds &built_in_boundaries();
} // namespace birdstrike
