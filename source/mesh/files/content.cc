#include "mesh/files/content.h"

#include "mesh/files/file_lines.h"
#include <birdstrike/core/errors.h>
#include <birdstrike/core/text/text_file.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace birdstrike
{
  namespace
  {
    /// The first lines of a file that hold something, without blanks around.
    using Lines = std::vector<std::string>;

    Lines head_of(const std::string &text)
    {
      constexpr std::size_t most = 400;
      Lines                 lines;
      for (std::size_t begin = 0; begin < text.size() && lines.size() < most;)
        {
          const std::size_t end = std::min(text.find('\n', begin), text.size());
          if (const auto line = trim(std::string_view(text).substr(begin, end - begin)); !line.empty())
            lines.emplace_back(line);
          begin = end + 1;
        }
      return lines;
    }

    bool starts(const std::string &line, const std::string_view with) ///< with capitals, in any case
    {
      return upper(std::string_view(line).substr(0, with.size())) == with;
    }

    bool some_starts(const Lines &lines, const std::vector<std::string_view> &with)
    {
      return std::any_of(lines.begin(), lines.end(), [&](const std::string &line) {
        return std::any_of(with.begin(), with.end(), [&](const auto each) { return starts(line, each); });
      });
    }

    std::size_t count_whole_numbers(const std::string &line)
    {
      std::size_t n = 0;
      for (std::size_t begin = 0; (begin = line.find_first_not_of(" \t", begin)) != std::string::npos; ++n)
        {
          const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
          if (line.find_first_not_of("0123456789", begin) < end)
            return 0;
          begin = end;
        }
      return n;
    }

    bool has_keywords(const Lines &lines)
    {
      return lines[0][0] == '*';
    }

    /// Both write keywords behind '*': LS-DYNA's have '_' in them, Abaqus' parameters behind a comma. Neither may occur
    /// in the first lines.
    bool is_ls_dyna(const Lines &lines)
    {
      return some_starts(lines, {"*KEYWORD", "*ELEMENT_", "*SET_", "*SECTION_", "*MAT_", "*CONTROL_", "*DATABASE_"});
    }
    bool is_abaqus(const Lines &lines)
    {
      return has_keywords(lines) && some_starts(lines, {"**", "*HEADING", "*NODE,", "*ELEMENT,", "*PART,", "*NSET,"});
    }

    /// Comments, a line of the numbers of nodes, cells and three kinds of data, nodes of an id and a place.
    bool is_ucd(const Lines &lines)
    {
      const auto head =
        std::find_if(lines.begin(), lines.end(), [](const std::string &line) { return line[0] != '#'; });
      return head != lines.end() && count_whole_numbers(*head) == 5;
    }

    bool is_nastran(const Lines &lines)
    {
      return some_starts(lines, {"BEGIN BULK", "GRID,", "GRID*", "GRID  ", "CQUAD4", "CHEXA", "NASTRAN "});
    }

    struct Format
    {
      std::string_view what;
      bool (*is_in)(const Lines &);
      std::vector<std::string_view> endings; ///< by which it is read here; none: it is not
      std::string                   remedy{};
    };

    const std::vector<Format> &formats()
    {
      static const std::string         by_gmsh = "Convert it: gmsh FILE -save -format msh2 -o NAME.msh";
      static const std::string         by_text = "Save it as Gmsh 4.1, Abaqus, LS-DYNA or legacy VTK, text.";
      static const std::vector<Format> all{
        {"LS-DYNA's keywords", is_ls_dyna, {".k", ".key", ".dyn"}},
        {"Abaqus' keywords", is_abaqus, {".inp"}},
        {"keywords", has_keywords, {".k", ".key", ".dyn", ".inp"}},
        {"Gmsh's format", [](const Lines &l) { return some_starts(l, {"$MESHFORMAT"}); }, {".msh"}},
        {"Gmsh's format 1",
         [](const Lines &l) { return starts(l[0], "$NOD") && !starts(l[0], "$NODES"); },
         {},
         by_gmsh},
        {"VTK's legacy format", [](const Lines &l) { return starts(l[0], "# VTK DATAFILE"); }, {".vtk"}},
        {"VTK's XML format",
         [](const Lines &l) {
           return starts(l[0], "<VTKFILE") || (starts(l[0], "<?XML") && some_starts(l, {"<VTKFILE"}));
         },
         {},
         "Save it as VTK legacy, ASCII (ParaView: Save Data, .vtk, file type Ascii)."},
        {"XML", [](const Lines &l) { return starts(l[0], "<?XML"); }, {}, by_text},
        {"a UNV file (I-deas)",
         [](const Lines &l) {
           return l[0].starts_with("-1") && l[0].size() == 2 && l.size() > 1 && count_whole_numbers(l[1]) == 1;
         },
         {},
         by_gmsh},
        {"ANSYS commands (.cdb)",
         [](const Lines &l) {
           return some_starts(l, {"/PREP7", "/BATCH", "NBLOCK,", "EBLOCK,"});
         },
         {},
         "Export it as Abaqus or Nastran from the program that wrote it."},
        {"a mesh of ANSYS Fluent",
         [](const Lines &l) { return l[0][0] == '(' && l[0].size() > 1 && std::isdigit(l[0][1]) != 0; },
         {},
         by_text},
        {"a mesh of GiD",
         [](const Lines &l) {
           return some_starts(l, {"MESH DIMENSION", "MESH \""});
         },
         {},
         by_text},
        {"Medit's format", [](const Lines &l) { return starts(l[0], "MESHVERSIONFORMATTED"); }, {}, by_gmsh},
        {"a surface of triangles (STL)",
         [](const Lines &l) { return starts(l[0], "SOLID") && l.size() > 1 && starts(l[1], "FACET"); },
         {},
         "Mesh the blade by quadrilaterals or hexahedra."},
        {"a geometry (STEP)",
         [](const Lines &l) { return starts(l[0], "ISO-10303"); },
         {},
         "Mesh it first (Gmsh opens it), by quadrilaterals or hexahedra."},
        {"a geometry of Gmsh (.geo)",
         [](const Lines &l) {
           return some_starts(l, {"POINT(", "POINT (", "SETFACTORY("});
         },
         {},
         "Mesh it: gmsh FILE -2 -format msh2 -o NAME.msh (solids: -3)"},
        {"Nastran's bulk data", is_nastran, {}, by_gmsh},
        {"UCD (AVS)", is_ucd, {".inp"}}};
      return all;
    }

    std::string list_of(const std::vector<std::string_view> &endings)
    {
      std::string text;
      for (const auto each : endings)
        text += (text.empty() ? "" : " ") + std::string(each);
      return text;
    }

    bool has(const std::vector<std::string_view> &endings, const std::string &ending)
    {
      return std::find(endings.begin(), endings.end(), ending) != endings.end();
    }

    bool is_read(const std::string &ending)
    {
      return std::any_of(formats().begin(), formats().end(),
                         [&](const Format &format) { return has(format.endings, ending); });
    }

    constexpr std::size_t most_bytes = 65536;
  } // namespace

  void check_content(const std::string &file, const std::string &ending)
  {
    const std::string text = read_text_file(file, most_bytes).value_or("");
    const Lines       head = head_of(text);
    if (head.empty())
      return;
    const auto found =
      std::find_if(formats().begin(), formats().end(), [&](const Format &format) { return format.is_in(head); });
    if (found == formats().end())
      {
        if (const std::string what = describe_no_text(text); !what.empty() && is_read(ending))
          throw InputError("Blade/Mesh/File: '" + file + "' is no text. It holds " + what + ".");
        return;
      }
    const std::string begin = ": it begins with '" + head[0].substr(0, 40) + "'.\n",
                      holds = "Blade/Mesh/File: '" + file + "' holds " + std::string(found->what);
    if (found->endings.empty() && is_read(ending))
      throw InputError(holds + ", which is not offered" + begin + found->remedy);
    if (!found->endings.empty() && !has(found->endings, ending))
      throw InputError(holds + ", which its ending '" + ending + "' does not say" + begin +
                       "Rename the file; the ending of this format: " + list_of(found->endings) + ".");
  }

  bool begins_with_keyword(const std::string &file)
  {
    const Lines head = head_of(read_text_file(file, most_bytes).value_or(""));
    return !head.empty() && head[0][0] == '*';
  }
} // namespace birdstrike
