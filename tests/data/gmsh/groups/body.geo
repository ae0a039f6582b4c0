// A body in two groups, one of which runs against it.
SetFactory("OpenCASCADE");
Box(1) = {0, -0.05, 0, 0.2, 0.1, 0.01};
Transfinite Curve{9, 10, 11, 12} = 4;
Transfinite Curve{2, 4, 6, 8} = 3;
Transfinite Curve{1, 3, 5, 7} = 2;
Transfinite Surface{:};
Transfinite Volume{1};
Recombine Surface{:};
Physical Surface("root", 11) = {-1};
Physical Surface("tip", 12) = {2};
Physical Volume("metal", 21) = {-1};
Physical Volume("all", 22) = {1};
