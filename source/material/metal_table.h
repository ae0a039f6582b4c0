#pragma once

#include <birdstrike/core/named_choices.h>
#include <birdstrike/material/metal.h>

namespace birdstrike
{
  /// Metals by name. `custom` has no values of its own: density, elasticity and yield stress must then be given.
  ///
  /// - Ti-8Al-1Mo-1V, annealed; ASM data sheet MTA816 (yield 930, ultimate 1000 MPa, elongation 12 %)
  /// - Ti-6Al-4V, annealed; ASM data sheet MTP641 (yield 880, ultimate 950 MPa, elongation 14 %, c_p 526.3, melting
  ///   1873 K)
  /// - Al 6061-T6; ASM data sheet MA6061T6 (yield 276, ultimate 310 MPa, elongation 12 % of a sheet of 1.6 mm)
  /// - Al 2024 Johnson-Cook: A 369 B 684 n 0.73 C 0.0083 m 1.7, damage 0.13 0.13 -1.5 0.011 0, read in an input deck;
  ///   density 2780, E 73 GPa, nu 0.33, read in data sheets (c_p 875 J/(kg K), melting begins at 775 K)
  ///
  /// The first three are perfectly plastic unless hardening is given: only yield and ultimate stress were read. There
  /// is no Johnson-Cook set of Ti-6Al-4V: those in use differ by 200 MPa at small strain, and none could be read at its
  /// source; whoever has one gives its constants (Hardening = johnson-cook). Heat capacity and melting temperature, and
  /// damage constants, stand ready where they were read; nothing heats unless Adiabatic heating is set, no metal fails
  /// unless Failure is.
  const NamedChoices<Metal> &metal_table();

  /// Where a metal's constants were read.
  std::string source_of(const Metal &metal);
} // namespace birdstrike
