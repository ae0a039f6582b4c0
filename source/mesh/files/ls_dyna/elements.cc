#include "mesh/files/ls_dyna/elements.h"

#include <algorithm>

namespace birdstrike
{
  namespace
  {
    const char *const others_remedy =
      "Name the parts that are the blade in Blade/Mesh/Parts. Allowed of these: *ELEMENT_SHELL, also with _THICKNESS, "
      "_BETA, _MCID and _OFFSET; *ELEMENT_SOLID, *ELEMENT_TSHELL, *ELEMENT_BEAM.";
    const char *const shape_remedy =
      "Allowed: quadrilaterals of four nodes, bricks of eight, that all differ. Mesh again without, or name the parts "
      "that are the blade in Blade/Mesh/Parts.";

    /// Whether all words behind ELEMENT_SHELL, say, are of these.
    bool consists_of(const std::vector<std::string> &words, const std::initializer_list<const char *> known)
    {
      return std::all_of(words.begin() + 2, words.end(), [&known](const std::string &word) {
        return std::find(known.begin(), known.end(), word) != known.end();
      });
    }
  } // namespace

  void LsDynaElements::begin()
  {
    n_cards       = 0;
    n_extra       = 0;
    read_one      = nullptr;
    has_thickness = cards.has_word("THICKNESS") || cards.has_word("BETA") || cards.has_word("MCID");
    has_offset    = cards.has_word("OFFSET");
    if (cards.name == "ELEMENT_SOLID" || cards.name == "ELEMENT_TSHELL")
      read_one = &LsDynaElements::read_solid;
    else if (!begin_shell() && !begin_beam() && !begin_other())
      cards.lines.refuse("the elements *" + cards.name + " are not offered",
                         std::string(others_remedy) + " Remove these cards: their layout is not known here.");
  }

  bool LsDynaElements::begin_shell()
  {
    if (cards.words.size() < 2 || cards.words[1] != "SHELL" ||
        !consists_of(cards.words, {"THICKNESS", "BETA", "MCID", "OFFSET"}))
      return false;
    read_one = &LsDynaElements::read_shell;
    return true;
  }

  /// One card more for each option.
  bool LsDynaElements::begin_beam()
  {
    if (cards.words.size() < 2 || cards.words[1] != "BEAM" ||
        !consists_of(cards.words,
                     {"THICKNESS", "SCALAR", "SCALR", "SECTION", "PID", "OFFSET", "ORIENTATION", "WARPAGE", "ELBOW"}))
      return false;
    read_one = &LsDynaElements::read_beam;
    n_extra  = cards.words.size() - 2;
    return true;
  }

  bool LsDynaElements::begin_other()
  {
    struct Known
    {
      const char *name;
      void (LsDynaElements::*read_one)();
      std::size_t n_extra;
      const char *mass_group;
    };
    static constexpr Known all[] = {{"ELEMENT_SPH", &LsDynaElements::read_other, 0, ""},
                                    {"ELEMENT_DISCRETE", &LsDynaElements::read_other, 0, ""},
                                    {"ELEMENT_DISCRETE_LCO", &LsDynaElements::read_other, 1, ""},
                                    {"ELEMENT_DISCRETE_SPHERE", &LsDynaElements::read_other, 0, ""},
                                    {"ELEMENT_DISCRETE_SPHERE_VOLUME", &LsDynaElements::read_other, 0, ""},
                                    {"ELEMENT_SEATBELT", &LsDynaElements::read_other, 0, ""},
                                    {"ELEMENT_MASS", &LsDynaElements::read_mass, 0, ""},
                                    {"ELEMENT_INERTIA", &LsDynaElements::read_mass, 1, ""},
                                    {"ELEMENT_INERTIA_OFFSET", &LsDynaElements::read_mass, 2, ""},
                                    {"ELEMENT_MASS_NODE_SET", &LsDynaElements::read_mass_of_group, 0, "node_set"},
                                    {"ELEMENT_MASS_PART", &LsDynaElements::read_mass_of_group, 0, "part"},
                                    {"ELEMENT_MASS_PART_SET", &LsDynaElements::read_mass_of_group, 0, "part_set"}};
    const auto             found =
      std::find_if(std::begin(all), std::end(all), [this](const Known &known) { return cards.name == known.name; });
    if (found == std::end(all))
      return false;
    read_one   = found->read_one;
    n_extra    = found->n_extra;
    mass_group = found->mass_group;
    return true;
  }

  void LsDynaElements::read_card()
  {
    if (n_cards > 0 || !trim(cards.lines.text()).empty())
      (this->*read_one)();
  }

  void LsDynaElements::add(const Id element, const Id of_part, const std::size_t first, const std::size_t n_nodes)
  {
    const unsigned int     dim   = n_nodes == 2 ? 1 : n_nodes == 4 ? 2 : 3;
    ImportedMesh::Element &added = mesh.elements[dim].emplace_back();
    added.id                     = element;
    for (std::size_t k = 0; k < n_nodes; ++k)
      added.nodes[k] = cards.id(first + k);
    mesh.groups[groups("part", of_part)].elements[dim].push_back(element);
  }

  void LsDynaElements::add_not_offered(const unsigned int dim, const Id element, const Id of_part,
                                       const std::string &what, const std::string &remedy)
  {
    const std::size_t line = dim == 0 ? cards.keyword_line : cards.lines.line_number();
    mesh.elements_not_offered[dim].push_back(mesh.not_offered(element, line, what, remedy));
    mesh.groups[groups("part", of_part)].elements[dim].push_back(element);
  }

  void LsDynaElements::add_shape(const unsigned int dim, const Id element, const Id of_part, const std::string &shape)
  {
    add_not_offered(dim, element, of_part, "element # is " + shape, shape_remedy);
  }

  void LsDynaElements::read_beam()
  {
    if (n_cards == 0)
      add(cards.id(0), cards.id(1), 2, 2);
    n_cards = (n_cards + 1) % (1 + n_extra);
  }

  /// Then thicknesses, of mid-side nodes too where there are such, then the offset.
  void LsDynaElements::read_shell()
  {
    if (n_cards == 0)
      {
        element       = cards.id(0);
        part          = cards.id(1);
        has_mid_nodes = cards.id(6) != 0;
        is_added      = false;
        if (cards.id(5) == 0 || cards.id(5) == cards.id(4))
          add_shape(2, element, part, "a triangle");
        else if (has_mid_nodes)
          add_shape(2, element, part, "of the second order");
        else
          {
            add(element, part, 2, 4);
            is_added = true;
          }
      }
    else if (n_cards == 1 && has_thickness)
      read_thickness(is_added ? &mesh.elements[2].back() : nullptr);
    const std::size_t n_before_offset = 1u + has_thickness * (1u + has_mid_nodes);
    if (n_cards == n_before_offset)
      read_offset();
    n_cards = (n_cards + 1) % (n_before_offset + has_offset);
  }

  /// At the four corners; all zero: that of the section, which is the parameter file's. Then the angle of the
  /// material's axes, or the id of their system.
  void LsDynaElements::read_thickness(ImportedMesh::Element *const shell)
  {
    if (shell == nullptr)
      return;
    unsigned int n_given = 0;
    for (unsigned int k = 0; k < 4; ++k)
      n_given += (shell->thickness[k] = cards.real(k)) > 0.;
    if (n_given != 4 && shell->thickness != std::array<double, 4>{})
      add_not_offered(2, element, part, "element # has a thickness at some corners only",
                      "Give four positive numbers, or four zeros for the blade's own thickness.");
    if (cards.real(4) != 0. && mesh.notes.of_plies.empty())
      mesh.notes.of_plies.push_back("Line " + std::to_string(cards.lines.line_number()) + ", *" + cards.name +
                                    ": element " + std::to_string(element) +
                                    " has axes of its material of its own (BETA, MCID), which are not read.");
  }

  void LsDynaElements::read_offset()
  {
    if (cards.real(0) != 0. && is_added)
      add_not_offered(2, element, part, "element # has its nodes off the mid-surface",
                      "Allowed: an offset of 0. Move the nodes onto the mid-surface.");
  }

  /// All on one card, or element and part on one and the nodes on the next.
  void LsDynaElements::read_solid()
  {
    if (n_cards == 0)
      {
        element = cards.id(0);
        part    = cards.id(1);
        n_cards = trim(cards.field(2, 2 * cards.widths.id, 8 * cards.widths.id)).empty();
        if (n_cards == 1)
          return;
      }
    const std::size_t first  = n_cards == 1 ? 0 : 2;
    const bool        is_ten = n_cards == 1 && (cards.id(8) != 0 || cards.id(9) != 0);
    n_cards                  = 0;
    std::array<Id, 8> nodes;
    for (std::size_t k = 0; k < 8; ++k)
      nodes[k] = cards.id(first + k);
    std::sort(nodes.begin(), nodes.end());
    if (is_ten)
      add_shape(3, element, part, "a tetrahedron of ten nodes");
    else if (nodes[0] == 0 || std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end())
      add_shape(3, element, part, "no brick: a tetrahedron, pyramid or wedge");
    else
      add(element, part, first, 8);
  }

  /// Particles and springs: id (of a particle its node), part.
  void LsDynaElements::read_other()
  {
    if (n_cards == 0)
      add_not_offered(0, cards.id(0), cards.id(1), "the elements *" + cards.name + " are not offered", others_remedy);
    n_cards = (n_cards + 1) % (1 + n_extra);
  }

  /// Of a node, whatever the part.
  void LsDynaElements::read_mass()
  {
    if (n_cards == 0)
      {
        const std::string what = "the elements *" + cards.name + " are not offered";
        const auto        line = cards.keyword_line;
        mesh.elements_not_offered[0].push_back(mesh.not_offered(cards.id(0), line, what, others_remedy));
        mesh.nodes_not_offered.push_back(
          mesh.not_offered(cards.id(1), line, "*" + cards.name + " gives a mass to node # of the blade",
                           "Remove the mass, or make elements of it: masses of nodes are not offered."));
      }
    n_cards = (n_cards + 1) % (1 + n_extra);
  }

  void LsDynaElements::read_mass_of_group()
  {
    const bool        is_set = std::string_view(mass_group) == "node_set";
    const std::size_t group  = groups(mass_group, is_set ? cards.id(1) : cards.id(0));
    mesh.groups[group].not_offered =
      mesh.not_offered(cards.id(0), cards.lines.line_number(), "*" + cards.name + " adds a mass to the blade",
                       "Remove the mass, or raise Blade/Material/Density: masses of nodes are not offered.");
  }
} // namespace birdstrike
