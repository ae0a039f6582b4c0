#include "mesh/files/ls_dyna_cards.h"
#include "mesh/files/readers.h"

#include <algorithm>
#include <map>

namespace birdstrike
{
  namespace
  {
    using Group = ImportedMesh::Group;

    bool contains(const std::vector<std::string> &words, const char *word)
    {
      return std::find(words.begin(), words.end(), word) != words.end();
    }

    class LsDynaFile : private LsDynaCards
    {
    public:
      using LsDynaCards::LsDynaCards;

      ImportedMesh read()
      {
        while (next())
          if (is_keyword())
            begin();
          else if (read_card != nullptr && !is_blank_element())
            (this->*read_card)();
        for (const auto &[set, part] : parts_of_sets)
          for (unsigned int d = 1; d <= 3; ++d)
            {
              const auto &of_part = mesh.groups[group_of("part", part)].elements[d];
              auto       &all     = mesh.groups[set].elements[d];
              lines.add_listed(of_part.size());
              all.insert(all.end(), of_part.begin(), of_part.end());
            }
        return std::move(mesh);
      }

    private:
      ImportedMesh mesh;

      // the present keyword
      void (LsDynaFile::*read_card)() = nullptr;
      unsigned int dim                = 0; ///< of elements
      bool         has_title          = false;
      std::string  title;
      std::size_t  n_cards = 0;           ///< that have been read of this element, part or set
      Id           element = 0, part = 0; ///< whose nodes may stand on the next card
      const char  *kind  = "";
      std::size_t  group = 0; ///< of a set

      std::map<std::string, std::size_t>      groups; ///< by kind and id: "part_3"
      std::vector<std::pair<std::size_t, Id>> parts_of_sets;

      void begin()
      {
        read_card = nullptr;
        n_cards   = 0;
        title     = "";
        has_title = contains(words, "TITLE");
        if (words[0] == "INCLUDE" || name == "NODE_TRANSFORM" || name == "NODE_MERGE_SET" || name == "CASE")
          lines.refuse("the keyword *" + name + " is not offered",
                       "Write the whole mesh, where it stands, as *NODE and *ELEMENT_... into one file.");
        else if (name == "NODE")
          read_card = &LsDynaFile::read_node;
        else if (words[0] == "ELEMENT")
          begin_elements();
        else if (words[0] == "PART" &&
                 (words.size() == 1 || contains({"INERTIA", "CONTACT", "PRINT", "COMPOSITE"}, words[1].c_str())))
          read_card = &LsDynaFile::read_part;
        else if (words[0] == "SET" && words.size() > 1)
          begin_set();
      }

      bool is_blank_element() const
      {
        return n_cards == 0 && words[0] == "ELEMENT" && trim(lines.text()).empty();
      }

      void read_node()
      {
        const auto x = [this](const std::size_t k) {
          return lines.number(field(k + 1, widths.id + k * widths.real, widths.real));
        };
        if (const Id number = id(0); number > 0)
          mesh.nodes.emplace_back(number, Point3(x(0), x(1), x(2)));
      }

      void begin_elements()
      {
        static const std::map<std::string, std::pair<unsigned int, void (LsDynaFile::*)()>> known{
          {"ELEMENT_BEAM", {1, &LsDynaFile::read_beam}},
          {"ELEMENT_SOLID", {3, &LsDynaFile::read_solid}},
          {"ELEMENT_TSHELL", {3, &LsDynaFile::read_solid}},
          {"ELEMENT_SHELL", {2, &LsDynaFile::read_shell}},
          {"ELEMENT_SHELL_THICKNESS", {2, &LsDynaFile::read_shell}},
          {"ELEMENT_SHELL_BETA", {2, &LsDynaFile::read_shell}},
          {"ELEMENT_SHELL_MCID", {2, &LsDynaFile::read_shell}},
          {"ELEMENT_SHELL_OFFSET", {2, &LsDynaFile::read_shell}},
          {"ELEMENT_SHELL_THICKNESS_OFFSET", {2, &LsDynaFile::read_shell}},
          {"ELEMENT_SHELL_BETA_OFFSET", {2, &LsDynaFile::read_shell}},
          {"ELEMENT_SHELL_MCID_OFFSET", {2, &LsDynaFile::read_shell}}};
        const auto found = known.find(name);
        if (found == known.end())
          lines.refuse("the elements *" + name + " are not offered",
                       "Allowed: *ELEMENT_SHELL, also with _THICKNESS, _BETA, _MCID and _OFFSET; *ELEMENT_SOLID, "
                       "*ELEMENT_TSHELL, *ELEMENT_BEAM. Remove all others, and save the blade alone.");
        std::tie(dim, read_card) = found->second;
      }

      void add_element(const Id element, const Id of_part, const std::size_t first, const std::size_t n_nodes)
      {
        ImportedMesh::Element &added = mesh.elements[dim].emplace_back();
        added.id                     = element;
        for (std::size_t k = 0; k < n_nodes; ++k)
          added.nodes[k] = id(first + k);
        mesh.groups[group_of("part", of_part)].elements[dim].push_back(element);
      }

      [[noreturn]] void refuse_shape(const Id element, const std::string &what)
      {
        lines.refuse("element " + std::to_string(element) + " is " + what,
                     "Allowed: quadrilaterals of four nodes, bricks of eight, that all differ. Mesh again without.");
      }

      void read_beam()
      {
        add_element(id(0), id(1), 2, 2);
      }

      void read_shell()
      {
        const bool has_second = words.size() > 2 && words[2] != "OFFSET", has_offset = words.back() == "OFFSET";
        if (n_cards == 0)
          {
            if (id(5) == 0 || id(5) == id(4))
              refuse_shape(id(0), "a triangle");
            if (id(6) != 0)
              refuse_shape(id(0), "of the second order");
            add_element(id(0), id(1), 2, 4);
          }
        else if (n_cards == 1 && has_second && words[2] == "THICKNESS")
          read_thickness(mesh.elements[2].back());
        else if (n_cards == 1u + has_second && real(0) != 0.)
          lines.refuse("element " + std::to_string(mesh.elements[2].back().id) + " has its nodes off the mid-surface",
                       "Allowed: an offset of 0. Move the nodes onto the mid-surface.");
        n_cards = (n_cards + 1) % (1u + has_second + has_offset);
      }

      /// At the four corners; all zero: that of the section, which is the parameter file's.
      void read_thickness(ImportedMesh::Element &shell)
      {
        unsigned int n_given = 0;
        for (unsigned int k = 0; k < 4; ++k)
          n_given += (shell.thickness[k] = real(k)) > 0.;
        if (n_given != 4 && shell.thickness != std::array<double, 4>{})
          lines.refuse("element " + std::to_string(shell.id) + " has a thickness at some corners only",
                       "Give four positive numbers, or four zeros for the blade's own thickness.");
      }

      /// All on one card, or element and part on one and the nodes on the next.
      void read_solid()
      {
        if (n_cards == 0)
          {
            element = id(0);
            part    = id(1);
            n_cards = trim(field(2, 2 * widths.id, 8 * widths.id)).empty();
            if (n_cards == 1)
              return;
          }
        const std::size_t first = n_cards == 1 ? 0 : 2;
        if (n_cards == 1 && (id(8) != 0 || id(9) != 0))
          refuse_shape(element, "a tetrahedron of ten nodes");
        add_element(element, part, first, 8);
        n_cards          = 0;
        const auto nodes = mesh.elements[3].back().nodes;
        for (unsigned int k = 0; k < 8; ++k)
          if (nodes[k] == 0 || std::find(nodes.begin(), nodes.begin() + k, nodes[k]) != nodes.begin() + k)
            refuse_shape(element, "no brick: a tetrahedron, pyramid or wedge");
      }

      /// The title, then a card that begins with the id; of parts with options more cards, which are passed over.
      void read_part()
      {
        if (n_cards == 0)
          title = trim(lines.text());
        else if (n_cards == 1 && !title.empty())
          mesh.groups[group_of("part", integer(0))].name = title;
        n_cards = words.size() == 1 ? (n_cards + 1) % 2 : n_cards + 1;
      }

      /// *SET_kind with LIST, GENERATE and TITLE; those of other options are passed over.
      void begin_set()
      {
        static const std::map<std::string, std::pair<unsigned int, const char *>> kinds{
          {"NODE", {0, "node_set"}},      {"BEAM", {1, "beam_set"}},     {"SHELL", {2, "shell_set"}},
          {"SOLID", {3, "solid_set"}},    {"TSHELL", {3, "tshell_set"}}, {"PART", {0, "part_set"}},
          {"SEGMENT", {0, "segment_set"}}};
        const auto found = kinds.find(words[1]);
        for (std::size_t k = 2; k < words.size(); ++k)
          if (!contains({"LIST", "GENERATE", "TITLE"}, words[k].c_str()))
            return;
        if (found == kinds.end())
          return;
        std::tie(dim, kind) = found->second;
        read_card           = &LsDynaFile::read_set;
      }

      void read_set()
      {
        const std::size_t card = n_cards++ + !has_title;
        if (card == 0)
          title = trim(lines.text());
        else if (card == 1)
          {
            group = group_of(kind, integer(0));
            if (!title.empty())
              mesh.groups[group].name = title;
          }
        else if (words[1] == "SEGMENT")
          mesh.groups[group].sides.push_back({integer(0), integer(1), integer(2), integer(3)});
        else if (contains(words, "GENERATE"))
          for (std::size_t k = 0; k < 8; k += 2)
            add_members(integer(k), integer(k + 1));
        else
          for (std::size_t k = 0; k < 8; ++k)
            if (integer(k) > 0)
              add_member(integer(k));
      }

      void add_members(const Id first, const Id last)
      {
        if (first < 1 || last < first)
          return; // fields of the card that are not filled
        const Id n = last - first + 1;
        lines.add_listed(static_cast<std::size_t>(n));
        for (Id k = 0; k < n; ++k)
          add_member(first + k);
      }

      void add_member(const Id member)
      {
        if (words[1] == "NODE")
          mesh.groups[group].nodes.push_back(member);
        else if (words[1] == "PART")
          parts_of_sets.emplace_back(group, member);
        else
          mesh.groups[group].elements[dim].push_back(member);
      }

      std::size_t group_of(const std::string &kind, const Id number)
      {
        const std::string name     = kind + "_" + std::to_string(number);
        const auto [found, is_new] = groups.emplace(name, mesh.groups.size());
        if (is_new)
          {
            if (number < 0 || number > ImportedMesh::largest_number)
              lines.refuse("a " + kind + " has the id " + std::to_string(number),
                           "Allowed: up to " + std::to_string(ImportedMesh::largest_number) + ".");
            Group &group = mesh.groups.emplace_back();
            group.name   = name;
            if (kind == "part")
              group.material_number = static_cast<unsigned int>(number);
            if (kind == "node_set")
              group.boundary_number = static_cast<unsigned int>(number);
          }
        return found->second;
      }
    };
  } // namespace

  ImportedMesh read_ls_dyna(const std::string &path)
  {
    return LsDynaFile(path).read();
  }
} // namespace birdstrike
