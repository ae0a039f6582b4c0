#pragma once

#include <iosfwd>

namespace birdstrike
{
  struct FieldSnapshot;

  /// Writes a snapshot as VTK's XML file of an unstructured grid (VTK file formats, "XML": binary, zlib, floats in
  /// single precision): a mesh whose cells share nodes, fields of nodes as point data, fields of cells as cell data,
  /// six components as a symmetric tensor (xx yy zz xy yz xz, which ParaView knows). Each array carries its unit as an
  /// attribute. Ours, because deal.II's DataOut repeats the nodes for every cell and has no cell data.
  /// `time` in s. Throws std::logic_error for arrays that do not fit together.
  void write_vtu(const FieldSnapshot &snapshot, double time, std::ostream &out);
} // namespace birdstrike
