// The plate of plate.geo as a body 0.01 m thick, of 3 x 2 x 1 hexahedra.
Point(1) = {0, -0.05, 0}; Point(2) = {0.2, -0.05, 0}; Point(3) = {0.2, 0.05, 0}; Point(4) = {0, 0.05, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = 4;
Transfinite Curve{2, 4} = 3;
Transfinite Surface{1};
Recombine Surface{1};
made[] = Extrude{0, 0, 0.01}{ Surface{1}; Layers{1}; Recombine; };
Physical Surface("root") = {made[5]};
Physical Surface("tip") = {made[3]};
Physical Surface("leading edge") = {made[2]};
Physical Surface("trailing edge") = {made[4]};
Physical Volume("blade metal") = {made[1]};
Mesh.SaveGroupsOfNodes = 1;
