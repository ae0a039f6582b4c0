#pragma once

#include <birdstrike/core/named_choices.h>
#include <birdstrike/material/metal.h>

namespace birdstrike
{
  /// Metals by name. `custom` has no values of its own: density, elasticity and yield stress must then be given.
  ///
  /// - Ti-8Al-1Mo-1V, annealed; read: ASM data sheet MTA816 (yield 930, ultimate 1000 MPa at 12 %)
  /// - Ti-6Al-4V, annealed; read: MatWeb (yield 880, ultimate 950 MPa, c_p 526.3, melting 1873 K)
  /// - Al 6061-T6; read: MatWeb (yield 276, ultimate 310 MPa)
  /// - Ti-6Al-4V Johnson-Cook 862: elasticity as above; A 862 B 331 n 0.34 C 0.012 m 0.8 as *recalled*, not verified
  /// - Ti-6Al-4V Johnson-Cook 1098: elasticity as above; A 1098 B 1092 n 0.93 C 0.014 m 1.1 as *recalled*, likewise
  /// - Al 2024 Johnson-Cook: A 369 B 684 n 0.73 C 0.0083 m 1.7, damage 0.13 0.13 -1.5 0.011 0, read in an input deck;
  ///   density 2780, E 73 GPa, nu 0.33, read in data sheets (c_p 875 J/(kg K), melting begins at 775 K)
  ///
  /// The first three are perfectly plastic unless hardening is given: only yield and ultimate stress were read. The two
  /// Johnson-Cook sets of Ti-6Al-4V differ by more than 200 MPa at small strain; compare them with a test before use.
  /// Heat capacity and melting temperature, of Ti-6Al-4V and Al 2024 under all their names, and damage constants stand
  /// ready where they were read; nothing heats unless Adiabatic heating is set, no metal fails unless Failure is.
  const NamedChoices<Metal> &metal_table();
} // namespace birdstrike
