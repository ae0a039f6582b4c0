#pragma once

#include "mesh/files/ls_dyna/groups.h"

#include <set>
#include <unordered_map>

namespace birdstrike
{
  /// The *SET_... keywords of an LS-DYNA file ("Keyword User's Manual, Volume I", *SET): lists, columns, ranges, ADD,
  /// INTERSECT and what GENERAL takes from nodes, elements, parts and other sets, in the order of its cards. Sets and
  /// parts may stand in any order; `resolve` puts them together. A set of another kind, or by boxes, volumes and
  /// branches, is known by its name and says that it is not read.
  class LsDynaSets
  {
  public:
    using Id = ImportedMesh::Id;

    LsDynaSets(ImportedMesh &mesh, LsDynaCards &cards, LsDynaGroups &groups) : mesh(mesh), cards(cards), groups(groups)
    {
    }

    void begin();
    void read_card();
    void resolve(); ///< at the end of the file

  private:
    struct Kind
    {
      const char  *word, *name; ///< "SHELL", "shell_set"
      unsigned int dim;         ///< of elements; 0: nodes, parts, segments
    };
    enum class Source
    {
      members,
      all,
      parts,
      sets,       ///< of a kind
      common_sets ///< what all of them have
    };
    struct Step
    {
      Source          source;
      const Kind     *kind;
      bool            removes;
      std::vector<Id> ids; ///< of segments: four nodes each
    };
    struct Set
    {
      const Kind       *kind     = nullptr;
      Id                number   = 0;
      std::size_t       line     = 0;
      bool              collects = true;
      std::vector<Step> steps{};
      bool              is_begun = false, is_done = false;
      std::vector<Id>   members{};
    };
    using Reader = void (LsDynaSets::*)();

    static const Kind *kind_of(const std::string &word);
    static Reader      reader_of(const std::string &layout);

    void            begin_set();
    void            add(Source source, const std::vector<Id> &ids, const Kind *of = nullptr, bool removes = false);
    void            read_list();
    void            read_column();
    void            read_ranges();
    void            read_steps();
    void            read_segment();
    void            read_general();
    void            read_sum();
    void            read_common();
    void            add_range(Id first, Id last, Id step);
    std::vector<Id> fields(std::size_t first, std::size_t last) const;
    void            refuse_when_asked(std::size_t group, std::size_t line, const std::string &what) const;
    const std::vector<Id> &members_of(std::size_t group);
    std::vector<Id>        members_of(const Set &set, const Step &step);
    std::vector<Id>        all_of(const Kind &kind) const;
    std::vector<Id>        as(const Kind &wanted, const Kind &given, const std::vector<Id> &members);
    std::vector<Id>        nodes_of(unsigned int dim, const std::vector<Id> &elements);
    void                   write(const Set &set, ImportedMesh::Group &group) const;

    ImportedMesh &mesh;
    LsDynaCards  &cards;
    LsDynaGroups &groups;

    // the present keyword
    const Kind *kind = nullptr;
    std::string kind_name;
    Reader      read_one  = nullptr;
    bool        has_title = false, collects = false;
    std::size_t n_cards = 0;
    std::string title;
    std::size_t group = 0;

    std::map<std::size_t, Set>                                           sets; ///< by group
    std::array<std::unordered_map<Id, const ImportedMesh::Element *>, 4> element_of;
  };
} // namespace birdstrike
