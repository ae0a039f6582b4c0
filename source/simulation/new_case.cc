#include <birdstrike/core/errors.h>
#include <birdstrike/io/case_parameters.h>
#include <birdstrike/simulation/commands.h>
#include <birdstrike/structure/choices.h>

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace birdstrike
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr const char *at_rest = "0";

    struct Answers
    {
      BladeKind   blade;
      std::string mesh, spin;

      bool has_mesh() const
      {
        return !mesh.empty();
      }
      bool turns() const
      {
        return spin != at_rest;
      }
    };

    std::string ask(const std::string &question, const std::string &usual)
    {
      std::cout << question << " [" << (usual.empty() ? "a plate" : usual) << "]: " << std::flush;
      std::string answer;
      std::getline(std::cin, answer);
      return answer.empty() ? usual : answer;
    }

    /// An answer that is not given is asked for where somebody types, and is the usual one elsewhere.
    std::string take(const std::optional<std::string> &given, const std::string &question, const std::string &usual)
    {
      return given ? *given : ::isatty(STDIN_FILENO) ? ask(question, usual) : usual;
    }

    Answers collect(const NewCaseRequest &request)
    {
      Answers           answers;
      const std::string kind = take(request.blade, "Blade: shell or solid", "shell");
      if (!blade_kinds().has(kind) ||
          (blade_kinds().at(kind) != BladeKind::shell && blade_kinds().at(kind) != BladeKind::solid))
        throw InputError("--blade = '" + kind + "'.\nAllowed: shell or solid.");
      answers.blade = blade_kinds().at(kind);
      answers.mesh  = take(request.mesh, "Mesh file of the blade (.msh, .inp, .k, .vtk)", "");
      answers.spin  = take(request.spin, "Speed of the hub, with its unit (4000 rpm)", at_rest);
      return answers;
    }

    /// As somebody who reads the file beside it would write it.
    std::string path_beside(const std::string &mesh, const std::string &prm)
    {
      std::error_code error;
      const fs::path  folder = fs::absolute(prm).parent_path();
      const fs::path  near   = fs::relative(fs::absolute(mesh), folder, error);
      return error || near.empty() ? mesh : near.string();
    }

    std::string write_mesh(const Answers &answers, const std::string &prm)
    {
      if (!answers.has_mesh())
        return "  subsection Mesh                     # a flat plate along x\n"
               "    set Length               = 300 mm\n"
               "    set Chord                = 90 mm\n"
               "    set Elements along span  = 60\n"
               "    set Elements along chord = 18\n"
               "  end\n";
      return fmt::format("  subsection Mesh\n"
                         "    set Generator  = file\n"
                         "    set File       = {}\n"
                         "    set File scale = 1                  # 0.001 if the mesh is in mm\n"
                         "  end\n"
                         "  subsection Supports                 # names of sets in the mesh\n"
                         "    set Clamped = root\n"
                         "    set Tip     = tip\n"
                         "  end\n",
                         path_beside(answers.mesh, prm));
    }

    /// A solid from a file has that of its mesh.
    std::string write_thickness(const Answers &answers)
    {
      return answers.has_mesh() && answers.blade == BladeKind::solid ? ""
                                                                     : "  subsection Thickness\n"
                                                                       "    set Value = 5 mm\n"
                                                                       "  end\n";
    }

    std::string write_spin(const Answers &answers)
    {
      if (!answers.turns())
        return "";
      std::string text = fmt::format("  subsection Spin                     # a hub turns about an axis\n"
                                     "    set Speed = {}\n"
                                     "    set Axis  = 0, 1, 0\n",
                                     answers.spin);
      if (!answers.has_mesh())
        text += "    set Centre = -0.2, 0, 0              # 200 mm before the root\n";
      return text + "  end\n";
    }

    /// Whole bird against a blade at rest; against one that turns it flies along the axis.
    std::string write_bird(const Answers &answers)
    {
      return fmt::format("subsection Bird                       # a cylinder, twice as long as thick\n"
                         "  set Mass               = 100 g\n"
                         "  set Particle spacing   = 3 mm        # a tenth of its diameter, or less\n"
                         "{}"
                         "  set Aim span fraction  = 0.7         # 0: root, 1: tip\n"
                         "  set Aim chord fraction = 0.5         # 0: leading edge, 1: trailing edge\n"
                         "end\n",
                         answers.turns() ? "  set Speed              = 100         # m/s\n"
                                           "  set Flight direction   = 0, 1, 0     # along the axis\n"
                                         : "  set Speed              = 150         # m/s; 300 knots is understood\n"
                                           "  set Angle to surface   = 90          # degrees; 90: at right angles\n");
    }

    std::string write_case(const Answers &answers, const std::string &prm)
    {
      const std::string name = fs::path(prm).filename().string();
      return fmt::format("# A bird strike. Units are SI unless a value names its own.\n"
                         "#\n"
                         "#   birdstrike explain {0}    describes the computation, and warns\n"
                         "#   birdstrike run {0}        computes it\n"
                         "#   birdstrike parameters Bird   prints the entries of section Bird\n"
                         "\n"
                         "subsection Case\n"
                         "  set Description = A first strike\n"
                         "end\n"
                         "\n"
                         "subsection Blade\n"
                         "  set Kind = {1}\n"
                         "{2}"
                         "{5}"
                         "  subsection Material                 # birdstrike materials lists the names\n"
                         "    set Name              = Ti-6Al-4V\n"
                         "    set Hardening         = linear\n"
                         "    set Hardening modulus = 1.25 GPa    # an assumption: give your own\n"
                         "  end\n"
                         "{3}"
                         "end\n"
                         "\n"
                         "{4}"
                         "\n"
                         "subsection Time\n"
                         "  set End time = 10 ms                # later than the peak of the tip\n"
                         "end\n"
                         "\n"
                         "subsection Output\n"
                         "  set History interval = 10 us\n"
                         "  set Field interval   = 0.25 ms\n"
                         "end\n",
                         name, blade_kinds().name(answers.blade), write_mesh(answers, prm), write_spin(answers),
                         write_bird(answers), write_thickness(answers));
    }
  } // namespace

  void write_new_case(const NewCaseRequest &request)
  {
    if (!request.is_forced && fs::exists(request.file))
      throw InputError("The file '" + request.file + "' is there.\nGive another name, or --force to replace it.");
    const Answers answers = collect(request);
    if (answers.has_mesh() && !fs::is_regular_file(answers.mesh))
      throw InputError("--mesh: cannot open '" + answers.mesh + "'.\nGive the path of a mesh file.");
    std::ofstream file(request.file, std::ios::binary);
    file << write_case(answers, request.file) << std::flush;
    if (!file)
      throw InputError("Cannot write '" + request.file + "'.\nGive a file in a folder that is there.");
    std::cout << "Wrote " << request.file << ". Next: birdstrike explain " << request.file << "\n";
  }
} // namespace birdstrike
