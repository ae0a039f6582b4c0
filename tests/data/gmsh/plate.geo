// A plate 0.2 m x 0.1 m of 3 x 2 quadrilaterals; README.md says what is made of it.
Point(1) = {0, -0.05, 0}; Point(2) = {0.2, -0.05, 0}; Point(3) = {0.2, 0.05, 0}; Point(4) = {0, 0.05, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = 4;
Transfinite Curve{2, 4} = 3;
Transfinite Surface{1};
Recombine Surface{1};
Physical Curve("root") = {4};
Physical Curve("tip") = {2};
Physical Curve("leading edge") = {1};
Physical Curve("trailing edge") = {3};
Physical Surface("blade metal") = {1};
Mesh.SaveGroupsOfNodes = 1;
