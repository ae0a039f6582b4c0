#pragma once

#include "mesh/files/imported_mesh.h"

namespace birdstrike
{
  /// Keyword files of Abaqus (.inp), "Abaqus Keywords Reference Guide": *NODE, *ELEMENT, *NSET, *ELSET (GENERATE, sets
  /// of sets), *SURFACE of element faces or nodes, one *INSTANCE that stands where its *PART does. Sets EB3 and SS7 of
  /// Cubit are material 3 and boundary 7, too. Other keywords are passed over; InputError for element types that are
  /// no lines, quadrilaterals or bricks of the first order, and for keywords that would add nodes, elements or files.
  ImportedMesh read_abaqus(const std::string &path);

  /// Keyword files of LS-DYNA, "Keyword User's Manual, Volume I": *NODE, *ELEMENT_SHELL (also _THICKNESS, _BETA, _MCID,
  /// _OFFSET of 0), *ELEMENT_SOLID, *ELEMENT_TSHELL, *ELEMENT_BEAM, *PART, *SET_NODE, _SHELL, _SOLID, _TSHELL, _BEAM,
  /// _PART (_LIST, _GENERATE, _TITLE) and *SET_SEGMENT, in columns of the standard, I10 and LONG formats or with
  /// commas. A part's id is its material id, a node set's its boundary id. Other keywords are passed over; InputError
  /// for other *ELEMENTs, triangles, tetrahedra, wedges, and keywords that would move nodes or add files.
  ImportedMesh read_ls_dyna(const std::string &path);

  /// VTK's legacy format, text, versions 2 to 5: an unstructured grid of lines, quadrilaterals and hexahedra. Scalars
  /// MaterialID (as deal.II writes them), else CellEntityIds (as Gmsh does), number cells and sides.
  ImportedMesh read_vtk(const std::string &path);

  /// Gmsh's format, text, versions 2, 4.0 and 4.1 ("Gmsh reference manual", MSH file format): points, lines,
  /// quadrilaterals and hexahedra; physical groups by number and name, each of one dimension. What is written in one
  /// line there must stand in one line.
  ImportedMesh read_gmsh(const std::string &path);

  /// AVS's unstructured cell data, text: pt, line, quad and hex; material numbers are groups, 0 is none.
  ImportedMesh read_ucd(const std::string &path);
} // namespace birdstrike
