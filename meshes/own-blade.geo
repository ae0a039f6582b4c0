// A twisted, cambered blade of constant thickness for the chapter "Your own blade" of the manual. Lengths in mm.
//   gmsh own-blade.geo -2 -format msh2 -o own-blade-shell.msh                      the mid-surface, quadrilaterals
//   gmsh own-blade.geo -3 -setnumber Solid 1 -format msh2 -o own-blade-solid.msh   the body, one layer of hexahedra
// The span lies along x from the hub radius to the tip, the axis of the engine along y.
DefineConstant[ Solid = 0 ];

hub = 200; span = 300; thickness = 5;
n_stations = 7; n_points = 5;          // splines through 7 sections of 5 points
n_span = 36; n_chord = 14;             // elements

Macro Section
  // Points of one section: s share of the span, side -1, 0 or 1 half a thickness along the section's normal.
  chord = 120 - 30*s;
  stagger = (15 + 35*s)*Pi/180;
  camber = 0.04*chord;
  For j In {0 : n_points-1}
    t = -0.5 + j/(n_points-1);
    along = chord*t;
    across = camber*(1 - 4*t*t) + side*thickness/2;
    Point(first + j) = {hub + span*s, along*Cos(stagger) - across*Sin(stagger), along*Sin(stagger) + across*Cos(stagger)};
  EndFor
Return

Macro Face
  // Surface `face` through all sections at this side.
  For i In {0 : n_stations-1}
    s = i/(n_stations-1);
    first = 1000*face + 10*i;
    Call Section;
  EndFor
  last = 1000*face + 10*(n_stations-1);
  Spline(10*face + 1) = {1000*face : 1000*face + n_points-1};            // root
  Spline(10*face + 2) = {last : last + n_points-1};                      // tip
  Spline(10*face + 3) = {1000*face : last : 10};                         // leading edge
  Spline(10*face + 4) = {1000*face + n_points-1 : last + n_points-1 : 10}; // trailing edge
  Transfinite Curve{10*face + 1, 10*face + 2} = n_chord + 1;
  Transfinite Curve{10*face + 3, 10*face + 4} = n_span + 1;
  Curve Loop(face) = {10*face + 1, 10*face + 4, -(10*face + 2), -(10*face + 3)};
  Surface(face) = {face};
  Transfinite Surface{face};
  Recombine Surface{face};
Return

If (Solid == 0)
  side = 0; face = 1;
  Call Face;
  Physical Curve("root") = {11};
  Physical Curve("tip") = {12};
  Physical Curve("leading_edge") = {13};
  Physical Curve("trailing_edge") = {14};
  Physical Surface("blade") = {1};
Else
  side = -1; face = 1;
  Call Face;
  side = 1; face = 2;
  Call Face;
  last = 10*(n_stations-1);
  Line(101) = {1000, 2000};
  Line(102) = {1000 + n_points-1, 2000 + n_points-1};
  Line(103) = {1000 + last, 2000 + last};
  Line(104) = {1000 + last + n_points-1, 2000 + last + n_points-1};
  Transfinite Curve{101 : 104} = 2;    // one layer of elements
  Curve Loop(3) = {11, 102, -21, -101};
  Curve Loop(4) = {12, 104, -22, -103};
  Curve Loop(5) = {13, 103, -23, -101};
  Curve Loop(6) = {14, 104, -24, -102};
  For k In {3 : 6}
    Surface(k) = {k};
    Transfinite Surface{k};
    Recombine Surface{k};
  EndFor
  Surface Loop(1) = {1 : 6};
  Volume(1) = {1};
  Transfinite Volume{1};
  Physical Surface("root") = {3};
  Physical Surface("tip") = {4};
  Physical Surface("leading_edge") = {5};
  Physical Surface("trailing_edge") = {6};
  Physical Volume("blade") = {1};
EndIf
