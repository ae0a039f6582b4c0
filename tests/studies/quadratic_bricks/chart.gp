# Error of the tip at 2 ms against the time of the element forces; variables csv, chart, reference from run.sh.
set datafile separator ','
set terminal svg size 800,560 font 'sans,12' background 'white'
set output chart
set logscale xy
set xlabel 'element forces to 2 ms, s (one core)'
set ylabel 'error of the tip, %'
set format y '%g'
set grid
set key outside right
pick(kind, layers) = sprintf("< grep '^impulse,%s,[0-9x]*x%d,' %s", kind, layers, csv)
error(tip) = 100. * abs(tip / reference - 1.)
plot pick('shell', 1) using 10:(error($5)) with linespoints title 'shell, 5 points', \
     pick('one-point', 1) using 10:(error($5)) with linespoints title 'one-point brick, 1 layer', \
     pick('one-point', 4) using 10:(error($5)) with linespoints title 'one-point brick, 4 layers', \
     pick('quadratic-g2xg5', 1) using 10:(error($5)) with linespoints title 'quadratic, 2 x 2 x 5', \
     pick('quadratic-g2xg3', 1) using 10:(error($5)) with linespoints title 'quadratic, 2 x 2 x 3', \
     pick('quadratic-g2xg3', 2) using 10:(error($5)) with linespoints title 'the same, 2 layers', \
     pick('quadratic-g3', 1) using 10:(error($5)) with linespoints title 'quadratic, Gauss 3', \
     pick('quadratic-gl3', 1) using 10:(error($5)) with linespoints title 'quadratic, Lobatto 3'
